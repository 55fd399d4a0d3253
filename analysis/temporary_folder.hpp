#pragma once

#include <filesystem>

namespace rocking::analysis {

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
