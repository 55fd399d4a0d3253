#pragma once

#include <filesystem>

namespace rocking::analysis {

/// A folder of its own for this object's lifetime, where temporary files belong. Its lock tells that its process lives: one that
/// a killed process left is removed by the next object that is made.
class TemporaryFolder {
 public:
  /// Throws std::system_error with the path.
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
