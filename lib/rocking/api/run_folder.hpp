#pragma once

#include <filesystem>
#include <string>

#include "rocking/api/run.hpp"
#include "rocking/base/error.hpp"
#include "rocking/store/store.hpp"
#include "rocking/text/folder_lock.hpp"

/// The folder of a run.
namespace rocking {

[[nodiscard]] std::filesystem::path store_in(const std::filesystem::path& folder);

/// An empty file, as a full disk may leave, does not count.
[[nodiscard]] bool has_store(const std::filesystem::path& folder);

/// Creates the folder if necessary and locks it. Throws std::system_error with the path if it cannot be used, or if
/// another run, of this process or another, is at work in it.
[[nodiscard]] FolderLock claimed(const std::filesystem::path& folder);

/// Opens the store for reading after a check of every page and row. Throws std::system_error with the path where there
/// is none, sqlite::UnusableFile if it is damaged.
[[nodiscard]] Store valid_store(const std::filesystem::path& folder);

/// As open_run, whatever report the folder has.
[[nodiscard]] StoredRun stored_run(const std::filesystem::path& folder);

/// Expects that a report in the folder, if there is one, is of the experiment of the store there: a copy that went wrong
/// leaves that of another run. What is no report is left to those that read it. Throws base::InputError with both names.
void expect_own_report(const std::filesystem::path& folder, const Identity& identity);

/// The error of a folder that cannot be used as asked.
[[nodiscard]] base::InputError refused(const std::filesystem::path& folder, std::string reason, std::string remedy);

}  // namespace rocking
