#include "rocking/api/folder_run.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include "rocking/api/refuse.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/ensemble/extension.hpp"
#include "rocking/output/report_differences.hpp"
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
void mend(FolderRun& run, const FolderMeans& means) {
  const auto damage = run.store.damage();
  if (!damage) return;
  if (!means.repair) {
    throw sqlite::UnusableFile(*damage + ". `repair` keeps the intact realisations and runs the rest again");
  }
  const Experiment stored = experiment_of(run.store.identity());
  const Repair repair = run.folder.mend_store(std::move(run.store), stored);
  run.store = run.folder.open_store(sqlite::Access::write);
  run.damaged_file = repair.damaged_file;
  means.tell(*damage + "; " + counted(repair.realisations, "realisation") + " in it " +
             (repair.realisations == 1 ? "is" : "are") + " intact and kept, the rest is run again: " +
             listed_realisations(missing_realisations(stored, run.store)) + ". The damaged file is now " +
             repair.damaged_file.string());
}

/// Whether the experiments differ in a fixed number of realisations only.
bool is_extension(const Experiment& experiment, const Identity& identity) {
  if (experiment.conditions.front().until) return false;
  const std::vector<std::string> differences = experiment_differences(experiment.canonical_text, identity.experiment);
  return std::ranges::all_of(differences,
                             [](const std::string& difference) { return difference.starts_with("/realisations is "); });
}

// Without being asked to extend it.
void expect_own_run(const FolderRun& run, const Experiment& experiment, const NewRun& asked) {
  const Identity& identity = run.store.identity();
  const bool is_longer = identity.experiment != experiment.canonical_text;
  if (is_longer && !is_extension(experiment, identity)) {
    throw FolderError(Kind::in_the_way, run.folder.name(), "has realisations of another experiment",
                      "choose another folder");
  }
  if (is_longer && run.folder.has_report()) {
    throw FolderError(Kind::in_the_way, run.folder.name(),
                      "has the report of a run with another number of realisations",
                      "`rocking resume DIR --realisations N` extends it");
  }
  if (is_longer || identity.shard == asked.shard) return;
  throw FolderError(Kind::in_the_way, run.folder.name(), "has another part of the experiment", "choose another folder");
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
void extend(FolderRun& run, const Tell& remark) {
  if (!run.folder.is_replacement() && run.folder.has_report()) {
    remark(
        "the intervals of the extended run cover as often as stated if the earlier result did not determine its "
        "length; for a run that is extended until its intervals are narrow enough, use `until`");
    run.store.close_up();
    run.folder.begin_replacement();
  } else {
    fs::remove(run.folder.report_path());  // of a replacement that was not installed: not of the extension
  }
  const Experiment former = experiment_of(run.store.identity());
  run.folder.extend_store(std::move(run.store), former, run.experiment);
  run.store = run.folder.open_store(sqlite::Access::write);
}

/// Goes on with a run. `wanted`: gives the experiment, or refuses that of the store.
FolderRun go_on(RunFolder folder, const std::function<Experiment(const FolderRun& run)>& wanted,
                const FolderMeans& means) {
  folder.claim();
  folder.tidy_up(means.tell);
  if (folder.has_replacement()) folder.enter_replacement();
  if (means.repair) count_pages_again(folder.store_path());
  Store store = folder.open_store(sqlite::Access::write);
  FolderRun run{.folder = std::move(folder), .experiment = {}, .store = std::move(store)};
  expect_same_results(run.folder, run.store.identity());
  mend(run, means);
  run.experiment = wanted(run);
  const bool is_longer = run.experiment.canonical_text != run.store.identity().experiment;
  if (is_longer) expect_extensible(run.folder, run.store, run.experiment);
  const Plan plan = plan_of(run.experiment, {.threads = means.threads,
                                             .shard = run.store.identity().shard,
                                             .stored = completeness(run.experiment, run.store).done,
                                             .page = means.page});
  expect_memory(plan, means);
  if (!plan.at_most) run.folder.expect_room(plan.needs.disk_bytes);
  if (is_longer) extend(run, means.remark);
  return run;
}

}  // namespace

void say_nothing(const std::string& /*notice*/) {}

void check_shard(const Experiment& experiment, const Shard& shard) {
  if (shard.part < 1 || shard.part > shard.parts) {
    refuse("shard", std::to_string(shard.part) + '/' + std::to_string(shard.parts),
           "is not a part of a whole: the part is a number from 1 to that of the parts");
  }
  for (const Condition& condition : experiment.conditions) {
    if (!condition.until) continue;
    refuse("/realisations", "until", "needs all realisations at once, and a part does not know those of the others");
  }
}

FolderRun begin_run(const fs::path& path, const Experiment& experiment, const NewRun& asked, const FolderMeans& means) {
  check_strobe(experiment);
  const Plan plan = plan_of(experiment, {.threads = means.threads, .shard = asked.shard, .page = means.page});
  expect_memory(plan, means);
  if (asked.shard) check_shard(experiment, *asked.shard);
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
  const RunFolder folder(path);
  if (!folder.has_store() && !folder.has_replacement() && !folder.is_half_installed()) {
    throw FolderError(Kind::missing, folder.name(),
                      "contains no run to resume (realisations.sqlite is missing or empty)");
  }
  return go_on(
      RunFolder(path), [&extension](const FolderRun& run) { return experiment_of(run.store.identity(), extension); },
      means);
}

FolderRun begin_or_continue_run(const fs::path& path, const Experiment& experiment, const NewRun& asked,
                                const FolderMeans& means) {
  if (experiment.canonical_text.empty()) {
    throw FolderError(Kind::contradiction, path.string(), "an experiment without text cannot be kept in a folder",
                      "read the experiment from a file or from text, or run it in memory");
  }
  RunFolder folder(path);
  if (!folder.has_store()) return begin_run(path, experiment, asked, means);
  const auto own = [&](const FolderRun& run) {
    expect_own_run(run, experiment, asked);
    return experiment;
  };
  return go_on(std::move(folder), own, means);
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

ExperimentResult complete_result(const FolderRun& run, const base::ManyParts& how) {
  if (auto result = result_of(run.experiment, run.store, how)) return std::move(*result);
  throw sqlite::UnusableFile(run.folder.store_path().string() +
                             ": is damaged: stored realisations are missing; `rocking resume " +
                             shell_word(run.folder.name()) + "` runs them again");
}

}  // namespace rocking
