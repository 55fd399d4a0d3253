#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "rocking/experiment/store.hpp"

namespace rocking::program {

/// A folder with the outcome of a run: the store of its realisations and, once all are done, its report.
class RunFolder {
 public:
  explicit RunFolder(std::filesystem::path path) : path_(std::move(path)) {}
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;
  ~RunFolder();

  /// Makes the folder if need be, checks that it can be written to, and keeps others from working in it as long as this
  /// object lives. Throws InTheWay where another process does, std::system_error with the path where it cannot be used.
  void claim();
  /// Whether a process, this one or another, has claimed it.
  [[nodiscard]] bool is_at_work() const;
  /// Throws std::system_error where the disk has not that many bytes free.
  void expect_room(std::uint64_t bytes) const;

  /// An empty file, as a full disk or a cut may leave, is none: nothing is lost where a run begins anew.
  [[nodiscard]] bool has_store() const;
  [[nodiscard]] bool has_report() const { return std::filesystem::exists(report_path()); }
  /// A new store. Throws as experiment::Store does.
  [[nodiscard]] experiment::Store create_store(const experiment::Identity& identity) const;
  /// The store that is there. Throws MissingInput where none is, otherwise as experiment::Store does.
  [[nodiscard]] experiment::Store open_store(experiment::sqlite::Access access) const;
  /// The same for reading, after a check of every page and row: throws sqlite::UnusableFile where one is damaged.
  [[nodiscard]] experiment::Store open_sound_store() const;
  /// What becomes of the file of a store that is renewed.
  enum class FormerFile : std::uint8_t { kept, removed };
  struct Renewal {
    std::uint64_t realisations = 0;     ///< taken over
    std::filesystem::path former_file;  ///< where the former file is now, if it is kept
  };
  /// Puts a store of the current layout and results version into the place of another, with all that is sound in that and
  /// has the bits that this program gives. Throws sqlite::UnusableFile where none of its rows is sound: its identity may
  /// then be that of another store.
  Renewal renew_store(experiment::Store former, const experiment::Experiment& experiment, FormerFile file) const;
  /// Removes store, report and page.
  void clear() const;

  [[nodiscard]] std::string name() const { return path_.string(); }
  [[nodiscard]] std::filesystem::path store_path() const { return path_ / "realisations.sqlite"; }
  [[nodiscard]] std::filesystem::path report_path() const { return path_ / "report.json"; }
  [[nodiscard]] std::filesystem::path page_path() const { return path_ / "report.html"; }
  [[nodiscard]] std::filesystem::path progress_path() const { return path_ / "progress.json"; }

 private:
  void wait_for_lock();
  void remove_leftovers() const;
  [[nodiscard]] std::filesystem::path keep_store_file() const;
  [[nodiscard]] std::filesystem::path lock_path() const { return path_ / ".lock"; }
  [[nodiscard]] std::filesystem::path renewed_path() const { return path_ / "mended.sqlite"; }

  std::filesystem::path path_;
  int lock_ = -1;
};

/// Version and revision of this program, as a store knows it.
[[nodiscard]] std::string code_identity();

/// The experiment that a store belongs to. Throws InputError or MissingInput where a file that it names has changed or is
/// gone.
[[nodiscard]] experiment::Experiment experiment_of(const experiment::Identity& identity);

}  // namespace rocking::program
