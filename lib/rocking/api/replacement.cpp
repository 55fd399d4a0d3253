#include "rocking/api/replacement.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace rocking {
namespace {

namespace fs = std::filesystem;

/// Flushes a folder to the disk, which makes renames in it durable.
void flush_folder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

bool Replacement::has_begun() const { return fs::exists(RunFiles{path()}.store()); }

bool Replacement::is_half_installed() const { return fs::exists(complete()); }

void Replacement::begin() const {
  discard();
  fs::create_directory(path());
}

void Replacement::discard() const { fs::remove_all(path()); }

bool Replacement::discard_unless_begun() const { return !has_begun() && fs::remove_all(path()) > 0; }

void Replacement::install() const {
  fs::rename(path(), complete());
  flush_folder(folder_);
  finish_installing();
}

// The store is moved first. As long as it is in the subfolder, no file has been moved, and a file that the subfolder
// lacks is not part of the new run. If a report were moved first, a kill would leave it beside the earlier store, from
// which `resume` would write the earlier report again.
void Replacement::finish_installing() const {
  if (!is_half_installed()) return;
  const RunFiles now{folder_};
  const RunFiles next{complete()};
  if (fs::exists(next.store())) {
    if (!fs::exists(next.report())) fs::remove(now.report());
    if (!fs::exists(next.page())) fs::remove(now.page());
    fs::remove(now.progress());
    // SQLite would apply a log of the earlier store to the new one.
    for (const char* suffix : {"-wal", "-shm", "-journal"}) fs::remove(now.store().string() + suffix);
    fs::rename(next.store(), now.store());
    flush_folder(folder_);
  }
  if (fs::exists(next.report())) fs::rename(next.report(), now.report());
  if (fs::exists(next.page())) fs::rename(next.page(), now.page());
  flush_folder(folder_);
  fs::remove_all(complete());
}

}  // namespace rocking
