#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "replacement.hpp"
#include "rocking/experiment/store.hpp"

namespace rocking::program {

/// A folder with the outcome of a run: the store of its realisations and, once all are done, its report.
class RunFolder {
 public:
  explicit RunFolder(std::filesystem::path path) : path_(std::move(path)), files_{path_} {}
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

  /// From here on the paths below are those of a run that is to replace the one in the folder, if there is one. begin_replacement
  /// begins with an empty subfolder, enter_replacement goes on with one that was begun.
  void begin_replacement();
  void enter_replacement();
  [[nodiscard]] bool has_replacement() const { return replacement().has_begun(); }
  [[nodiscard]] bool is_replacement() const { return files_.folder != path_; }
  /// Whether there is one for it to replace.
  [[nodiscard]] bool has_earlier_run() const;
  /// Gives up a run that was to replace another.
  void discard_replacement();
  /// Lets a complete run take its place; nothing to do for one that replaces none.
  void install_replacement();
  /// Does what processes that were killed left to be done: installs a complete replacement, removes temporary files. For whoever
  /// has claimed the folder.
  void tidy_up() const;
  [[nodiscard]] bool is_half_installed() const { return replacement().is_half_installed(); }
  /// Throws InTheWay where that is still to be done: what the folder holds then belongs to two runs.
  void expect_installed() const;

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

  [[nodiscard]] std::string name() const { return path_.string(); }
  [[nodiscard]] std::filesystem::path store_path() const { return files_.store(); }
  [[nodiscard]] std::filesystem::path report_path() const { return files_.report(); }
  [[nodiscard]] std::filesystem::path page_path() const { return files_.page(); }
  [[nodiscard]] std::filesystem::path progress_path() const { return files_.progress(); }

 private:
  void wait_for_lock();
  void remove_leftovers() const;
  [[nodiscard]] std::filesystem::path keep_store_file() const;
  [[nodiscard]] std::filesystem::path lock_path() const { return path_ / ".lock"; }
  [[nodiscard]] std::filesystem::path renewed_path() const { return files_.folder / "mended.sqlite"; }

  [[nodiscard]] Replacement replacement() const { return Replacement(path_); }

  std::filesystem::path path_;
  RunFiles files_;
  int lock_ = -1;
};

/// Version and revision of this program, as a store knows it.
[[nodiscard]] std::string code_identity();

/// The experiment that a store belongs to. Throws InputError or MissingInput where a file that it names has changed or is
/// gone.
[[nodiscard]] experiment::Experiment experiment_of(const experiment::Identity& identity);

}  // namespace rocking::program
