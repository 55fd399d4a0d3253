#include "rocking/text/folder_lock.hpp"

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rocking {
namespace {

std::filesystem::path lock_file_in(const std::filesystem::path& folder) { return folder / ".lock"; }

// Whether the path still leads to the open file.
bool is_file_at(int descriptor, const std::filesystem::path& path) {
  struct stat open {};
  struct stat named {};
  return ::fstat(descriptor, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && open.st_ino == named.st_ino &&
         open.st_dev == named.st_dev;
}

// A lock file of this library is empty. A file of this name that another program wrote is not removed, nor one that
// another process has created since.
bool is_empty_file_at(int descriptor, const std::filesystem::path& path) {
  struct stat facts {};
  return is_file_at(descriptor, path) && ::fstat(descriptor, &facts) == 0 && S_ISREG(facts.st_mode) &&
         facts.st_size == 0;
}

}  // namespace

// A separate file, open for writing, because some network file systems can lock no other. The former holder of the lock
// may have removed the file after it was opened here. A lock on it is then useless, and the next attempt creates a new
// file.
std::optional<FolderLock> FolderLock::at(const std::filesystem::path& path) {
  for (;;) {
    FolderLock lock(path);
    lock.descriptor_ = ::open(lock.path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
    if (lock.descriptor_ < 0) {
      throw std::system_error(errno, std::generic_category(), lock.path_.string() + ": cannot be opened");
    }
    if (!lock.lock()) {
      ::close(std::exchange(lock.descriptor_, -1));  // the file belongs to the holder
      return std::nullopt;
    }
    if (is_file_at(lock.descriptor_, lock.path_)) return lock;
  }
}

std::optional<FolderLock> FolderLock::of(const std::filesystem::path& folder) { return at(lock_file_in(folder)); }

std::optional<FolderLock> FolderLock::of_file(const std::filesystem::path& file) {
  return at(file.parent_path() / ("." + file.filename().string() + ".lock"));
}

bool FolderLock::lock() {
  constexpr int most_attempts = 10;  // `rocking run --status` holds it for a moment
  for (int attempt = 0; ::flock(descriptor_, LOCK_EX | LOCK_NB) != 0; ++attempt) {
    if (errno != EWOULDBLOCK) return true;  // on a file system without locks the user must prevent conflicts
    if (attempt == most_attempts) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return true;
}

FolderLock::~FolderLock() {
  if (descriptor_ < 0) return;
  if (is_empty_file_at(descriptor_, path_)) ::unlink(path_.c_str());
  ::close(descriptor_);
}

bool is_locked(const std::filesystem::path& folder) {
  const int lock = ::open(lock_file_in(folder).c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (lock < 0) return false;
  const bool held = ::flock(lock, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(lock);
  return held;
}

}  // namespace rocking
