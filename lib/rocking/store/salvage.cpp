#include "rocking/store/salvage.hpp"

#include <fstream>
#include <string>
#include <system_error>
#include <utility>

namespace rocking {
namespace {

namespace fs = std::filesystem;

// Also absent if the path to the row is damaged.
std::optional<Summary> find_undamaged(const Store& store, const RealisationKey& key) {
  try {
    return store.find(key);
  } catch (const sqlite::UnusableFile&) {
    return std::nullopt;
  }
}

// A big-endian number in the header of a database.
std::uintmax_t number_at(const std::string& header, std::size_t place, std::size_t bytes) {
  std::uintmax_t number = 0;
  for (std::size_t i = place; i < place + bytes; ++i) number = number << 8 | static_cast<unsigned char>(header[i]);
  return number;
}

/// The first free name for a damaged store, or the one that a process gave it before it was killed.
fs::path name_for_damaged(const fs::path& store, const fs::path& folder) {
  for (int number = 1;; ++number) {
    fs::path name = folder / ("damaged-" + std::to_string(number) + ".sqlite");
    if (!fs::exists(name) || fs::equivalent(name, store)) return name;
  }
}

bool has_rows(const Store& store) {
  bool any = false;
  try {
    store.for_each_key([&any](const RealisationKey&) { any = true; });
  } catch (const sqlite::UnusableFile&) {
    // The earlier finding counts.
  }
  return any;
}

// Keeps the file under another name, with its logs.
fs::path keep_store_file(const fs::path& path, const fs::path& folder) {
  fs::path kept = name_for_damaged(path, folder);
  std::error_code no_links;
  if (!fs::exists(kept)) fs::create_hard_link(path, kept, no_links);
  if (no_links) fs::copy_file(path, kept);
  for (const char* suffix : sqlite::log_suffixes) {
    const fs::path log = path.string() + suffix;
    if (fs::exists(log)) fs::rename(log, kept.string() + suffix);
  }
  return kept;
}

}  // namespace

// Offsets: SQLite's file format, "The Database Header". A page size of 65536 is written as 1.
void count_pages_again(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) return;
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  std::string header(100, '\0');
  if (!file.read(header.data(), 100) || !header.starts_with("SQLite format 3")) return;
  const std::uintmax_t page_size = number_at(header, 16, 2) == 1 ? 65536 : number_at(header, 16, 2);
  if (page_size == 0) return;
  const std::uintmax_t pages = std::filesystem::file_size(path) / page_size;
  if (pages == 0 || number_at(header, 28, 4) <= pages) return;
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) bytes += static_cast<char>(pages >> shift & 0xffU);
  file.seekp(28).write(bytes.data(), 4);
}

// Reading all rows in order would end at the first damaged page; looking up each key separately avoids it.
std::uint64_t salvage(const Experiment& experiment, const Store& damaged, Store& into) {
  std::uint64_t kept = 0;
  for (std::uint64_t condition = 0; condition < experiment.conditions.size(); ++condition) {
    const std::uint64_t realisations = effective_realisations(experiment.conditions[condition]);
    for (std::uint64_t realisation = 0; realisation < realisations; ++realisation) {
      const RealisationKey key{condition, realisation};
      const auto summary = find_undamaged(damaged, key);
      if (!summary) continue;
      into.add(key, *summary);
      ++kept;
    }
  }
  return kept;
}

fs::path mended_store_beside(const fs::path& path) { return path.parent_path() / "mended.sqlite"; }

Repair mend_store(const fs::path& path, const fs::path& kept_in, Store damaged, const Experiment& experiment) {
  const fs::path mended = mended_store_beside(path);
  Store::remove(mended);  // of a process that was killed
  Repair repair;
  {
    Store store = Store::create(mended, damaged.identity());
    repair.realisations = salvage(experiment, damaged, store);
    if (repair.realisations == 0 && has_rows(damaged)) {
      throw sqlite::UnusableFile(path.string() +
                                 ": is damaged: none of its realisations belongs to its experiment, which may be that "
                                 "of another store; run the experiment again, with --overwrite");
    }
    store.close_up();
  }
  { const Store closed = std::move(damaged); }
  repair.damaged_file = keep_store_file(path, kept_in);
  sqlite::remove_logs(path);  // SQLite would apply them to the new file
  fs::rename(mended, path);
  return repair;
}

}  // namespace rocking
