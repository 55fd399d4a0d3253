#include "replacement.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace rocking::program {
namespace {

namespace fs = std::filesystem;

/// Renames become durable when their folder is.
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

void Replacement::install() const {
  fs::rename(path(), complete());
  flush_folder(folder_);
  finish_installing();
}

// The store is moved first: while it is still in the subfolder, nothing has been moved, and what the subfolder lacks the new run
// does not have. Were a report moved first, a kill would leave it beside the earlier store, from which `resume` would write the
// earlier report again.
void Replacement::finish_installing() const {
  if (!is_half_installed()) return;
  const RunFiles now{folder_};
  const RunFiles next{complete()};
  if (fs::exists(next.store())) {
    if (!fs::exists(next.report())) fs::remove(now.report());
    if (!fs::exists(next.page())) fs::remove(now.page());
    fs::remove(now.progress());
    // A log of the earlier store would be taken for one of the new store.
    for (const char* suffix : {"-wal", "-shm", "-journal"}) fs::remove(now.store().string() + suffix);
    fs::rename(next.store(), now.store());
    flush_folder(folder_);
  }
  if (fs::exists(next.report())) fs::rename(next.report(), now.report());
  if (fs::exists(next.page())) fs::rename(next.page(), now.page());
  flush_folder(folder_);
  fs::remove_all(complete());
}

}  // namespace rocking::program
