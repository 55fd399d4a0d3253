#include "run_folder.hpp"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "exit_code.hpp"
#include "output.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/error.hpp"
#include "rocking/ensemble/extension.hpp"
#include "rocking/store/salvage.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::program {
namespace {

namespace fs = std::filesystem;

// A store that will replace the one of the run once it is complete, beside it.
fs::path mended_store_in(const fs::path& folder) { return folder / "mended.sqlite"; }
fs::path extended_store_in(const fs::path& folder) { return folder / "extended.sqlite"; }

/// The first free name for a damaged store, or the one that a process gave it before it was killed.
fs::path name_for_damaged(const fs::path& store, const fs::path& folder) {
  for (int number = 1;; ++number) {
    fs::path name = folder / fmt::format("damaged-{}.sqlite", number);
    if (!fs::exists(name) || fs::equivalent(name, store)) return name;
  }
}

/// SQLite opens no file whose absolute path, with the ending of its log, has more than 512 bytes.
void expect_short_path(const std::filesystem::path& store) {
  constexpr std::size_t longest = 512;
  constexpr std::string_view longest_ending = ".new-journal";
  const std::size_t length = std::filesystem::absolute(store).string().size() + longest_ending.size();
  if (length <= longest) return;
  throw UsageError(
      fmt::format("the path of the folder is {} bytes too long for SQLite ({} at most); choose a shorter one: {}",
                  length - longest, longest, base::cut_to(store.parent_path().string(), 100)));
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

}  // namespace

void RunFolder::claim() {
  expect_short_path(store_path());
  ensure_writable(path_);
  auto lock = FolderLock::of(path_);
  if (!lock) {
    throw InTheWay(name() + ": another `rocking` is working in this folder; wait for it, or choose another folder");
  }
  lock_.emplace(*std::move(lock));
}

void RunFolder::expect_room(std::uint64_t bytes) const {
  std::error_code unknown;
  const std::uintmax_t free = std::filesystem::space(path_, unknown).available;
  if (unknown || bytes <= free) return;
  throw std::system_error(
      std::make_error_code(std::errc::no_space_on_device),
      fmt::format("{}: its realisations may need {}, {} are free; free some space, choose another disk, or "
                  "divide the run with --shard",
                  name(), size_in_words(bytes), size_in_words(free)));
}

Store RunFolder::create_store(const Identity& identity) const { return Store::create(store_path(), identity); }

bool RunFolder::has_store() const {
  std::error_code none;
  const auto status = std::filesystem::status(store_path(), none);
  if (!std::filesystem::exists(status)) return false;
  return !std::filesystem::is_regular_file(status) || std::filesystem::file_size(store_path(), none) > 0;
}

Store RunFolder::open_store(sqlite::Access access) const {
  expect_short_path(store_path());
  expect_installed();
  if (!has_store()) throw MissingInput(name() + ": contains no run (there is no realisations.sqlite)");
  return Store::open(store_path(), access);
}

Store RunFolder::open_valid_store() const {
  Store store = open_store(sqlite::Access::read);
  if (const auto damage = store.damage()) {
    throw sqlite::UnusableFile(
        fmt::format("{}. `rocking resume {}` keeps the intact rows and runs the rest again", *damage, name()));
  }
  return store;
}

RunFolder::Repair RunFolder::mend_store(Store damaged, const Experiment& experiment) const {
  Repair repair;
  {
    Store store = Store::create(mended_store_in(files_.folder), damaged.identity());
    repair.realisations = salvage(experiment, damaged, store);
    if (repair.realisations == 0 && has_rows(damaged)) {
      throw sqlite::UnusableFile(
          fmt::format("{}: is damaged: none of its realisations belongs to its experiment, which may be "
                      "that of another store; run the experiment again, with --overwrite",
                      store_path().string()));
    }
    store.close_up();
  }
  { const Store closed = std::move(damaged); }
  repair.damaged_file = keep_store_file();
  sqlite::remove_logs(store_path());  // SQLite would apply them to the new file
  fs::rename(mended_store_in(files_.folder), store_path());
  return repair;
}

void RunFolder::extend_store(Store former, const Experiment& experiment, const Experiment& extension) const {
  {
    Store store = Store::create(extended_store_in(files_.folder), extended_identity(former.identity(), extension));
    copy_common_realisations(former, experiment, extension, store);
    store.close_up();
  }
  { const Store closed = std::move(former); }
  sqlite::remove_logs(store_path());  // SQLite would apply them to the new file
  fs::rename(extended_store_in(files_.folder), store_path());
}

// Keeps the file under another name, with its logs.
std::filesystem::path RunFolder::keep_store_file() const {
  fs::path kept = name_for_damaged(store_path(), path_);
  std::error_code no_links;
  if (!fs::exists(kept)) fs::create_hard_link(store_path(), kept, no_links);
  if (no_links) fs::copy_file(store_path(), kept);
  for (const char* suffix : sqlite::log_suffixes) {
    const std::filesystem::path log = store_path().string() + suffix;
    if (std::filesystem::exists(log)) std::filesystem::rename(log, kept.string() + suffix);
  }
  return kept;
}

void RunFolder::begin_replacement() {
  replacement().begin();
  enter_replacement();
}

void RunFolder::enter_replacement() { files_.folder = replacement().path(); }

bool RunFolder::has_earlier_run() const {
  const RunFiles earlier{path_};
  return is_replacement() && (std::filesystem::exists(earlier.store()) || std::filesystem::exists(earlier.report()));
}

void RunFolder::discard_replacement() {
  replacement().discard();
  files_.folder = path_;
}

void RunFolder::install_replacement() {
  if (!is_replacement()) return;
  replacement().install();
  files_.folder = path_;
}

void RunFolder::tidy_up() const {
  replacement().finish_installing();
  if (!forget_what_did_not_begin()) return;
  print_notice(fmt::format(
      "{}: a new run or an extension (`run --overwrite`, `merge`, `resume --realisations`) ended before its "
      "first realisation was stored, and is lost; repeat its command if it is still wanted",
      name()));
}

// True if that is a loss. A mended store is made again by the next command that needs it.
bool RunFolder::forget_what_did_not_begin() const {
  bool lost = replacement().discard_unless_begun();
  for (const RunFiles& files : {RunFiles{path_}, RunFiles{replacement().path()}}) {
    Store::remove_unfinished(files.store());
    Store::remove(mended_store_in(files.folder));
    lost = Store::remove(extended_store_in(files.folder)) || lost;
  }
  return lost;
}

void RunFolder::expect_installed() const {
  if (!is_half_installed()) return;
  throw InTheWay(
      fmt::format("{0}: a new run was interrupted while it replaced the one in this folder; `rocking "
                  "resume {0}` completes the replacement",
                  name()));
}

std::string code_identity() {
  const base::BuildInfo build = base::build_info();
  return fmt::format("{} {}", build.version, build.revision);
}

Identity extended_identity(Identity identity, const Experiment& extension) {
  identity.experiment = extension.canonical_text;
  identity.code = code_identity();
  return identity;
}

Experiment experiment_of(const Identity& identity, const Overrides& overrides) {
  try {
    return read_experiment(identity.experiment, overrides, {.files = files_seen_from(identity.files)});
  } catch (const std::system_error& error) {
    throw MissingInput(error.what());
  }
}

}  // namespace rocking::program
