#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rocking/base/stop_request.hpp"

namespace rocking::analysis {

/// How another program ended.
struct ChildEnd {
  int error = 0;      ///< errno of the attempt to start it; ENOENT: it is not installed
  int status = 0;     ///< as waitpid gives it
  std::string words;  ///< what it said, on one line

  [[nodiscard]] bool is_success() const;
};

/// Runs a program, looked up in PATH, in this folder and waits for it. Its first argument is its name. Its environment is
/// that of this process with locale C, time zone UTC and SOURCE_DATE_EPOCH of 2000-01-01, so that equal input gives equal
/// bytes. If it is asked to stop, the program is killed and base::Stopped is thrown.
[[nodiscard]] ChildEnd run_child(const std::filesystem::path& folder, std::vector<std::string> arguments,
                                 base::StopRequest stop = {});

/// A temporary folder with the lifetime of this object. It is locked while its process lives. A new object removes
/// folders that killed processes left.
class TemporaryFolder {
 public:
  /// Creates and locks the folder. Throws std::system_error with the path.
  TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int lock_ = -1;
};

}  // namespace rocking::analysis
