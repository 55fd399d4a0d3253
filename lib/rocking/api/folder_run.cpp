#include "rocking/api/folder_run.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "rocking/base/build_info.hpp"
#include "rocking/ensemble/extension.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/store/store_identity.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/locate.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;
using base::FolderError;
using Kind = FolderError::Kind;

void expect_memory(const Plan& plan, const FolderMeans& means) {
  // A run that is limited may end with few strobe points.
  const std::uint64_t bytes = plan.needs.memory_bytes;
  if (means.is_limited || !means.free_memory || bytes <= *means.free_memory) return;
  throw std::system_error(std::make_error_code(std::errc::not_enough_memory),
                          "the run may need " + size_in_words(bytes) + " of memory, " +
                              size_in_words(*means.free_memory) +
                              " are free; divide the sweep between several files, use shorter horizons or fewer "
                              "threads, or use a machine with more memory");
}

void expect_fixed_numbers(const Experiment& experiment) {
  for (const Condition& condition : experiment.conditions) {
    if (!condition.until) continue;
    throw FolderError(Kind::contradiction, "--shard",
                      "cannot be combined with `until`, because one part does not know the counts of the others",
                      "give a number of realisations");
  }
}

constexpr std::size_t most_ranges = 12;

/// Consecutive realisations of a condition.
struct Range {
  RealisationKey first;
  std::uint64_t count = 1;
};

std::vector<Range> ranges_of(const std::vector<RealisationKey>& keys) {
  std::vector<Range> ranges;
  for (const auto& key : keys) {
    const bool follows = !ranges.empty() && ranges.back().first.condition == key.condition &&
                         ranges.back().first.realisation + ranges.back().count == key.realisation;
    if (follows) {
      ++ranges.back().count;
    } else {
      ranges.push_back({key});
    }
  }
  return ranges;
}

/// `condition 0: realisations 3-9, 12; condition 2: realisations 4`; of a long list the first ranges, and the number
/// of realisations that follow. `none` for an empty one. The keys are in ascending order.
std::string listed_realisations(const std::vector<RealisationKey>& keys) {
  if (keys.empty()) return "none";
  std::string text;
  std::uint64_t listed = 0;
  std::uint64_t condition = 0;
  const std::vector<Range> ranges = ranges_of(keys);
  for (std::size_t i = 0; i < ranges.size() && i < most_ranges; ++i) {
    const auto& [first, count] = ranges[i];
    if (i == 0 || first.condition != condition) {
      text += (i == 0 ? "" : "; ") + ("condition " + std::to_string(first.condition)) + ": realisations ";
    } else {
      text += ", ";
    }
    condition = first.condition;
    text += std::to_string(first.realisation);
    if (count > 1) text += '-' + std::to_string(first.realisation + count - 1);
    listed += count;
  }
  return listed == keys.size() ? text : text + ", and " + std::to_string(keys.size() - listed) + " more";
}

// Realisations of another results version are not mixed with this program's: the bits could differ.
void expect_same_results(const RunFolder& folder, const Identity& identity) {
  if (identity.results == results_version) return;
  throw FolderError(Kind::in_the_way, folder.name(),
                    "was begun by rocking " + identity.code + ", this is " + base::code_identity() +
                        ", which may give different results",
                    "finish it with the former, or start again in another folder");
}

// Damage is found before rows are added.
Store mended_store(const RunFolder& folder, const Experiment& experiment, Store store, const Tell& tell) {
  const auto damage = store.damage();
  if (!damage) return store;
  const Repair repair = folder.mend_store(std::move(store), experiment);
  Store mended = folder.open_store(sqlite::Access::write);
  tell(*damage + "; " + counted(repair.realisations, "realisation") + " in it " +
       (repair.realisations == 1 ? "is" : "are") +
       " intact and kept, the rest is run again: " + listed_realisations(missing_realisations(experiment, mended)) +
       ". The damaged file is now " + repair.damaged_file.string());
  return mended;
}

void expect_extensible(const RunFolder& folder, const Store& store, const Experiment& extension) {
  if (store.identity().shard) {
    throw FolderError(Kind::contradiction, folder.name(),
                      "is a shard, and the shards of a longer run have other realisations",
                      "merge the shards, then extend the whole");
  }
  const std::uint64_t stored = most_stored_realisations(store);
  std::uint64_t wanted = 0;
  for (const Condition& condition : extension.conditions) wanted = std::max(wanted, condition.realisations);
  if (stored <= wanted) return;
  throw FolderError(Kind::contradiction, "--realisations " + std::to_string(wanted),
                    folder.name() + " already has conditions with " + counted(stored, "realisation"),
                    "give at least " + std::to_string(stored));
}

// A finished run stays in its folder until the extended one is complete. An unfinished one has no report yet, and its
// store is extended in place.
Store extended_store(RunFolder& folder, const Experiment& experiment, const Experiment& extension, Store store,
                     const Tell& remark) {
  if (!folder.is_replacement() && folder.has_report()) {
    remark(
        "the intervals of the extended run cover as often as stated if the earlier result did not determine its "
        "length; for a run that is extended until its intervals are narrow enough, use `until`");
    store.close_up();
    folder.begin_replacement();
  } else {
    fs::remove(folder.report_path());  // of a replacement that was not installed: not of the extension
  }
  folder.extend_store(std::move(store), experiment, extension);
  return folder.open_store(sqlite::Access::write);
}

}  // namespace

void say_nothing(const std::string& /*notice*/) {}

FolderRun begin_run(const fs::path& path, const Experiment& experiment, const NewRun& asked, const FolderMeans& means) {
  check_strobe(experiment);
  const Plan plan = plan_of(experiment, {.threads = means.threads, .shard = asked.shard, .page = means.page});
  expect_memory(plan, means);
  if (asked.shard) expect_fixed_numbers(experiment);
  RunFolder folder(path);
  folder.claim();
  folder.tidy_up(means.tell);
  if (!asked.overwrite) folder.expect_no_run();
  if (means.on_plan) means.on_plan(plan);
  if (!plan.at_most) folder.expect_room(plan.needs.disk_bytes);
  if (folder.has_store() || folder.has_report()) folder.begin_replacement();
  Store store = folder.create_store({.experiment = experiment.canonical_text,
                                     .code = base::code_identity(),
                                     .files = fs::absolute(asked.files).lexically_normal().string(),
                                     .shard = asked.shard});
  return {.folder = std::move(folder), .experiment = experiment, .store = std::move(store)};
}

FolderRun resume_run(const fs::path& path, const Overrides& extension, const FolderMeans& means) {
  RunFolder folder(path);
  if (!folder.has_store() && !folder.has_replacement() && !folder.is_half_installed()) {
    throw FolderError(Kind::missing, folder.name(),
                      "contains no run to resume (realisations.sqlite is missing or empty)");
  }
  folder.claim();
  folder.tidy_up(means.tell);
  if (folder.has_replacement()) folder.enter_replacement();
  count_pages_again(folder.store_path());
  Store store = folder.open_store(sqlite::Access::write);
  expect_same_results(folder, store.identity());
  const Experiment experiment = experiment_of(store.identity());
  store = mended_store(folder, experiment, std::move(store), means.tell);
  const bool is_asked = extension.realisations || !extension.levels.empty();
  Experiment wanted = is_asked ? experiment_of(store.identity(), extension) : experiment;
  const bool is_extension = wanted.canonical_text != experiment.canonical_text;
  if (is_extension) expect_extensible(folder, store, wanted);
  const Plan plan = plan_of(wanted, {.threads = means.threads,
                                     .shard = store.identity().shard,
                                     .stored = completeness(wanted, store).done,
                                     .page = means.page});
  expect_memory(plan, means);
  if (!plan.at_most) folder.expect_room(plan.needs.disk_bytes);
  if (is_extension) store = extended_store(folder, experiment, wanted, std::move(store), means.remark);
  return {.folder = std::move(folder), .experiment = std::move(wanted), .store = std::move(store)};
}

Report report_in(const RunFolder& folder) {
  folder.expect_installed();
  if (!folder.has_report()) {
    throw FolderError(Kind::missing, folder.name(),
                      folder.has_store() ? "there is no report.json yet" : "contains no run (there is no report.json)",
                      folder.has_store() ? "`rocking resume " + shell_word(folder.name()) + "` finishes the run" : "");
  }
  if (folder.has_store()) static_cast<void>(folder.open_store(sqlite::Access::read));  // the report is that of this run
  std::string text;
  try {
    text = read_file(folder.report_path());
  } catch (const std::system_error& cause) {
    throw FolderError(cause);
  }
  try {
    return parse_report(text);
  } catch (const base::InputError& error) {
    throw located(error, text, folder.report_path().string());
  }
}

RunEnd run_in_folder(FolderRun& run, const RunOptions& options) {
  const RunEnd end = rocking::run(run.experiment, run.store, options);
  if (end == RunEnd::complete && run.store.identity().shard) run.folder.install_replacement();
  return end;
}

ExperimentResult complete_result(const FolderRun& run, base::StopRequest stop) {
  if (auto result = result_of(run.experiment, run.store, stop)) return std::move(*result);
  throw sqlite::UnusableFile(run.folder.store_path().string() +
                             ": is damaged: stored realisations are missing; `rocking resume " +
                             shell_word(run.folder.name()) + "` runs them again");
}

}  // namespace rocking
