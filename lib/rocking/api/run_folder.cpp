#include "rocking/api/run_folder.hpp"

#include <system_error>
#include <utility>

#include "rocking/text/files.hpp"

namespace rocking {

namespace fs = std::filesystem;

fs::path store_in(const fs::path& folder) { return folder / "realisations.sqlite"; }

bool has_store(const fs::path& folder) {
  std::error_code none;
  const auto bytes = fs::file_size(store_in(folder), none);
  return !none && bytes > 0;
}

FolderLock claimed(const fs::path& folder) {
  ensure_writable(folder);
  if (auto lock = FolderLock::of(folder)) return *std::move(lock);
  throw std::system_error(
      std::make_error_code(std::errc::device_or_resource_busy),
      folder.string() + ": another run is at work in this folder; wait for it, or choose another folder");
}

Store valid_store(const fs::path& folder) {
  if (!has_store(folder)) {
    throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory),
                            folder.string() + ": contains no run (there is no realisations.sqlite)");
  }
  Store store = Store::open(store_in(folder), sqlite::Access::read);
  if (const auto damage = store.damage()) throw sqlite::UnusableFile(*damage);
  return store;
}

base::InputError refused(const fs::path& folder, std::string reason, std::string remedy) {
  return base::InputError(
      {.place = folder.string(), .value = "", .reason = std::move(reason), .remedy = std::move(remedy), .where = {}});
}

}  // namespace rocking
