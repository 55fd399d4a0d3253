#include "rocking/api/run_folder.hpp"

#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "rocking/base/build_info.hpp"
#include "rocking/base/digest.hpp"
#include "rocking/ensemble/extension.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;
using Kind = base::FolderError::Kind;

/// SQLite opens no file whose absolute path, with the ending of its log, has more than 512 bytes.
void expect_short_path(const fs::path& store) {
  constexpr std::size_t longest = 512;
  constexpr std::string_view longest_ending = ".new-journal";
  const std::size_t length = fs::absolute(store).string().size() + longest_ending.size();
  if (length <= longest) return;
  throw base::FolderError(Kind::contradiction, "",
                          "the path of the folder is " + std::to_string(length - longest) +
                              " bytes too long for SQLite (" + std::to_string(longest) + " at most)",
                          "choose a shorter one: " + base::cut_to(store.parent_path().string(), 100));
}

}  // namespace

void RunFolder::claim() {
  expect_short_path(store_path());
  ensure_writable(path_);
  auto lock = FolderLock::of(path_);
  if (!lock) {
    throw base::FolderError(Kind::at_work, name(), "another `rocking` is working in this folder",
                            "wait for it, or choose another folder");
  }
  lock_.emplace(*std::move(lock));
}

void RunFolder::expect_room(std::uint64_t bytes) const {
  std::error_code unknown;
  const std::uintmax_t free = fs::space(path_, unknown).available;
  if (unknown || bytes <= free) return;
  throw std::system_error(std::make_error_code(std::errc::no_space_on_device),
                          name() + ": its realisations may need " + size_in_words(bytes) + ", " + size_in_words(free) +
                              " are free; free some space, choose another disk, or divide the run with --shard");
}

Store RunFolder::create_store(const Identity& identity) const { return Store::create(store_path(), identity); }

bool RunFolder::has_store() const {
  std::error_code none;
  const auto status = fs::status(store_path(), none);
  if (!fs::exists(status)) return false;
  return !fs::is_regular_file(status) || fs::file_size(store_path(), none) > 0;
}

Store RunFolder::opened(sqlite::Access access) const {
  expect_short_path(store_path());
  expect_installed();
  if (!has_store()) {
    throw base::FolderError(Kind::missing, name(), "contains no run (there is no realisations.sqlite)");
  }
  return Store::open(store_path(), access);
}

Store RunFolder::open_store(sqlite::Access access) const {
  Store store = opened(access);
  expect_own_report(store.identity());
  return store;
}

Store RunFolder::valid(Store store) const {
  if (const auto damage = store.damage()) {
    throw sqlite::UnusableFile(*damage + ". `rocking resume " + shell_word(name()) +
                               "` keeps the intact rows and runs the rest again");
  }
  return store;
}

Store RunFolder::open_valid_store() const { return valid(open_store(sqlite::Access::read)); }

Store RunFolder::open_valid_store_beside_any_report() const { return valid(opened(sqlite::Access::read)); }

void RunFolder::expect_own_report(const Identity& identity) const {
  if (!has_report()) return;
  const std::string text = read_file(report_path());
  const std::string digest = base::to_hex(base::sha256(identity.experiment));
  // It is in no other place of a report, and the search takes a hundredth of the time of reading all.
  if (text.find("\"sha256\": \"" + digest + '"') != std::string::npos) return;
  std::vector<std::string> differences;
  try {
    const ReportClaims claims = claims_of_report(text);
    if (claims.sha256 == digest) return;
    differences = experiment_differences(claims.experiment, identity.experiment);
  } catch (const base::InputError&) {
    return;
  }
  throw base::InputError({report_path().string(), "",
                          "is of another run than " + store_path().string() +
                              (differences.empty() ? "" : ": in its experiment " + differences.front()),
                          "move the one that does not belong there to another folder; `rocking resume " +
                              files_.folder.string() + "` writes the report of the realisations"});
}

Repair RunFolder::mend_store(Store damaged, const Experiment& experiment) const {
  return rocking::mend_store(store_path(), path_, std::move(damaged), experiment);
}

void RunFolder::extend_store(Store former, const Experiment& experiment, const Experiment& extension) const {
  rocking::extend_store(store_path(), std::move(former), experiment, extension, base::code_identity());
}

void RunFolder::expect_no_run() const {
  if (has_report()) {
    throw base::FolderError(Kind::in_the_way, report_path().string(), "already exists",
                            "choose another folder, or add --overwrite to replace it");
  }
  if (has_store() || has_replacement()) {
    throw base::FolderError(Kind::in_the_way, name(), "contains a run",
                            "`rocking resume " + shell_word(name()) +
                                "` continues it. Otherwise choose another folder, or add --overwrite to replace it");
  }
}

void RunFolder::begin_replacement() {
  replacement().begin();
  enter_replacement();
}

void RunFolder::enter_replacement() { files_.folder = replacement().path(); }

bool RunFolder::has_earlier_run() const {
  const RunFiles earlier{path_};
  return is_replacement() && (fs::exists(earlier.store()) || fs::exists(earlier.report()));
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

void RunFolder::tidy_up(const Tell& tell) const {
  replacement().finish_installing();
  if (!forget_what_did_not_begin()) return;
  tell(name() +
       ": a new run or an extension (`run --overwrite`, `resume`) ended before its first realisation was stored, and "
       "is lost; repeat its command if it is still wanted");
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
  throw base::FolderError(Kind::in_the_way, name(),
                          "a new run was interrupted while it replaced the one in this folder",
                          "`rocking resume " + shell_word(name()) + "` completes the replacement");
}

Experiment experiment_of(const Identity& identity, const Overrides& overrides) {
  try {
    return experiment_in(identity.experiment, overrides, {.files = files_seen_from(identity.files)});
  } catch (const std::system_error& cause) {
    throw base::FolderError(cause);
  }
}

}  // namespace rocking
