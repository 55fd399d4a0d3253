#pragma once

#include <filesystem>
#include <optional>
#include <utility>

namespace rocking {

/// The lock of a folder in which a run is at work, or of a file there that a study will write, held for the lifetime of
/// the object. It excludes other processes, and other objects of this process. On a file system without locks nothing is
/// excluded.
class FolderLock {
 public:
  /// Locks a folder that can be written. Absent if another still holds the lock after 0.2 s. Throws std::system_error
  /// with the path.
  [[nodiscard]] static std::optional<FolderLock> of(const std::filesystem::path& folder);
  /// The same of one file in the folder, which need not exist.
  [[nodiscard]] static std::optional<FolderLock> of_file(const std::filesystem::path& file);

  FolderLock(FolderLock&& other) noexcept
      : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(std::filesystem::path path) : path_(std::move(path)) {}
  [[nodiscard]] static std::optional<FolderLock> at(const std::filesystem::path& path);
  [[nodiscard]] bool lock();

  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// Whether a process, this one or another, holds the lock of the folder.
[[nodiscard]] bool is_locked(const std::filesystem::path& folder);

}  // namespace rocking
