#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "rocking/api/replacement.hpp"
#include "rocking/base/error.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/salvage.hpp"
#include "rocking/store/store.hpp"
#include "rocking/text/folder_lock.hpp"

namespace rocking {

/// Takes what a caller should know of a folder, in words.
using Tell = std::function<void(const std::string& notice)>;

/// A folder with the results of a run: the store of its realisations and, once all are done, its report.
class RunFolder {
 public:
  explicit RunFolder(std::filesystem::path path) : path_(std::move(path)), files_{path_} {}

  /// Creates the folder if necessary, checks that it is writable, and locks it for the lifetime of this object. Throws
  /// FolderError if another run, of this process or another, is at work in it, std::system_error with the path if it
  /// cannot be used.
  void claim();
  /// Whether a process, this one or another, has claimed it.
  [[nodiscard]] bool is_at_work() const { return is_locked(path_); }
  /// Throws std::system_error if the disk does not have that many bytes free.
  void expect_room(std::uint64_t bytes) const;

  /// From this call on the paths below are those of a run that will replace the one in the folder, if there is one.
  /// begin_replacement starts with an empty subfolder, enter_replacement continues with an existing one.
  void begin_replacement();
  void enter_replacement();
  [[nodiscard]] bool has_replacement() const { return replacement().has_begun(); }
  [[nodiscard]] bool is_replacement() const { return files_.folder != path_; }
  /// Whether the folder has an earlier run, which the new one will replace.
  [[nodiscard]] bool has_earlier_run() const;
  /// Discards the replacement.
  void discard_replacement();
  /// Replaces the earlier run by the complete new one; no effect without an earlier run.
  void install_replacement();
  /// Completes the work of processes that were killed: installs a complete replacement, removes unfinished files. Tells
  /// if a new run or an extension had not begun yet and is therefore lost. The caller has claimed the folder.
  void tidy_up(const Tell& tell) const;
  [[nodiscard]] bool is_half_installed() const { return replacement().is_half_installed(); }
  /// Throws FolderError if that is still to be done, because the files in the folder then belong to two runs.
  void expect_installed() const;

  /// An empty file, as a full disk or a power failure may leave, does not count: a new run loses nothing.
  [[nodiscard]] bool has_store() const;
  [[nodiscard]] bool has_report() const { return std::filesystem::exists(report_path()); }
  /// Throws FolderError if it has a run, finished or not.
  void expect_no_run() const;
  /// Creates a store. Throws as Store does.
  [[nodiscard]] Store create_store(const Identity& identity) const;
  /// Opens the store. Throws FolderError if there is none, base::InputError if the report is that of another run,
  /// otherwise as Store does.
  [[nodiscard]] Store open_store(sqlite::Access access) const;
  /// Opens it for reading after a check of every page and row; throws sqlite::UnusableFile if one is damaged.
  [[nodiscard]] Store open_valid_store() const;
  /// The same, whatever report the folder has.
  [[nodiscard]] Store open_valid_store_beside_any_report() const;
  /// Expects that a report in the folder, if there is one, is of the experiment of a store: a copy that went wrong leaves
  /// that of another run. What is no report is left to those that read it. Throws base::InputError with both names.
  void expect_own_report(const Identity& identity) const;
  /// Replaces a damaged store by one with its undamaged rows. Throws sqlite::UnusableFile if there is no such row,
  /// because the identity may then be wrong too.
  [[nodiscard]] Repair mend_store(Store damaged, const Experiment& experiment) const;
  /// Replaces the store by one of an extension of its experiment, with the realisations that the two have in common.
  void extend_store(Store former, const Experiment& experiment, const Experiment& extension) const;

  [[nodiscard]] std::string name() const { return path_.string(); }
  [[nodiscard]] std::filesystem::path store_path() const { return files_.store(); }
  [[nodiscard]] std::filesystem::path report_path() const { return files_.report(); }
  [[nodiscard]] std::filesystem::path page_path() const { return files_.page(); }
  [[nodiscard]] std::filesystem::path progress_path() const { return files_.progress(); }

 private:
  [[nodiscard]] Store opened(sqlite::Access access) const;
  [[nodiscard]] Store valid(Store store) const;
  [[nodiscard]] bool forget_what_did_not_begin() const;
  [[nodiscard]] Replacement replacement() const { return Replacement(path_); }

  std::filesystem::path path_;
  RunFiles files_;
  std::optional<FolderLock> lock_;
};

/// The experiment of a store. Throws base::InputError if a file that the experiment names has changed, FolderError if one
/// cannot be read.
[[nodiscard]] Experiment experiment_of(const Identity& identity, const Overrides& overrides = {});

}  // namespace rocking
