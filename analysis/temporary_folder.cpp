#include "analysis/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rocking::analysis {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view beginning_of_name = "rocking-figure-";

/// Opens a folder of this user and locks it. Returns the descriptor, or -1 if another process holds the lock or there
/// is no such folder.
int locked(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return -1;
  struct stat facts {};
  const bool is_ours = ::fstat(descriptor, &facts) == 0 && facts.st_uid == ::geteuid() && facts.st_nlink > 0;
  if (is_ours && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return descriptor;
  ::close(descriptor);
  return -1;
}

void remove_abandoned_folders(const fs::path& place) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(place, fs::directory_options::skip_permission_denied, ignored)) {
    if (!entry.path().filename().string().starts_with(beginning_of_name)) continue;
    const int lock = locked(entry.path());
    if (lock < 0) continue;
    fs::remove_all(entry.path(), ignored);
    ::close(lock);
  }
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  const fs::path place = fs::temp_directory_path();
  remove_abandoned_folders(place);
  // Until it is locked, another process may take the new folder for an abandoned one and remove it; then another one is
  // made.
  for (int attempt = 0;; ++attempt) {
    std::string name = (place / (std::string(beginning_of_name) + "XXXXXX")).string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(), name + ": cannot be created");
    }
    path_ = name;
    lock_ = locked(path_);
    if (lock_ >= 0 || attempt == 3) return;  // a file system without locks: no other process can get one either
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace rocking::analysis
