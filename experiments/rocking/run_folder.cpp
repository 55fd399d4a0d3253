#include "run_folder.hpp"

#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "exit_code.hpp"
#include "output.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/error.hpp"
#include "rocking/ensemble/extension.hpp"
#include "rocking/store/salvage.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::program {
namespace {

namespace fs = std::filesystem;

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
  Store store = Store::open(store_path(), access);
  expect_own_report(files_.folder, store.identity());
  return store;
}

Store RunFolder::open_valid_store() const {
  Store store = open_store(sqlite::Access::read);
  if (const auto damage = store.damage()) {
    throw sqlite::UnusableFile(fmt::format("{}. `rocking resume {}` keeps the intact rows and runs the rest again",
                                           *damage, shell_word(name())));
  }
  return store;
}

Repair RunFolder::mend_store(Store damaged, const Experiment& experiment) const {
  return rocking::mend_store(store_path(), path_, std::move(damaged), experiment);
}

void RunFolder::extend_store(Store former, const Experiment& experiment, const Experiment& extension) const {
  rocking::extend_store(store_path(), std::move(former), experiment, extension, base::code_identity());
}

void RunFolder::expect_no_run() const {
  if (has_report()) {
    throw InTheWay(report_path().string() +
                   ": already exists; choose another folder, or add --overwrite to replace it");
  }
  if (has_store() || has_replacement()) {
    throw InTheWay(
        fmt::format("{}: contains a run; `rocking resume {}` continues it. Otherwise choose another folder, "
                    "or add --overwrite to replace it",
                    name(), shell_word(name())));
  }
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
    if (!fs::exists(files.folder)) continue;
    Store::remove_unfinished(files.store());
    Store::remove(mended_store_beside(files.store()));
    lost = Store::remove(extended_store_beside(files.store())) || lost;
  }
  return lost;
}

void RunFolder::expect_installed() const {
  if (!is_half_installed()) return;
  throw InTheWay(
      fmt::format("{}: a new run was interrupted while it replaced the one in this folder; `rocking "
                  "resume {}` completes the replacement",
                  name(), shell_word(name())));
}

Experiment experiment_of(const Identity& identity, const Overrides& overrides) {
  return input_of(
      [&] { return experiment_in(identity.experiment, overrides, {.files = files_seen_from(identity.files)}); });
}

}  // namespace rocking::program
