#include "rocking/api/run.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "rocking/api/folder_run.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/ensemble/extension.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/output/plan_text.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/output/run_table.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/store/store.hpp"
#include "rocking/store/store_identity.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;

/// Whether the experiments differ in a fixed number of realisations only.
bool is_extension(const Experiment& experiment, const Identity& identity) {
  if (experiment.conditions.front().until) return false;
  const std::vector<std::string> differences = experiment_differences(experiment.canonical_text, identity.experiment);
  return std::ranges::all_of(differences,
                             [](const std::string& difference) { return difference.starts_with("/realisations is "); });
}

void expect_extensible(const Experiment& experiment, const RunFolder& folder, const Store& store) {
  if (!is_extension(experiment, store.identity())) {
    throw refused(folder.name(), "has realisations of another experiment", "choose another folder");
  }
  const std::uint64_t stored = most_stored_realisations(store);
  const std::uint64_t wanted = experiment.conditions.front().realisations;
  if (stored > wanted) {
    throw refused(folder.name(),
                  "has " + std::to_string(stored) + " realisations of a condition, more than " + std::to_string(wanted),
                  "ask for at least as many, or choose another folder");
  }
  if (store.identity().shard) {
    throw refused(folder.name(), "has a part of a run with another number of realisations", "merge the parts first");
  }
  if (folder.has_report()) {
    throw refused(folder.name(), "has the report of a run with another number of realisations",
                  "`rocking resume DIR --realisations N` extends it");
  }
}

/// The store in a folder, with the realisations of this experiment.
Store store_in_folder(const Experiment& experiment, const RunFolder& folder, const Execution& execution,
                      std::optional<fs::path>& damaged_file) {
  const auto open = [&folder] { return folder.open_store(sqlite::Access::write); };
  if (execution.repair) count_pages_again(folder.store_path());
  Store store = open();
  if (store.identity().results != results_version) {
    throw refused(execution.folder, "was written by a version that may give other results", "choose another folder");
  }
  if (const auto damage = store.damage()) {
    if (!execution.repair) {
      throw sqlite::UnusableFile(*damage + ". `repair` keeps the intact realisations and runs the rest again");
    }
    const Experiment stored = experiment_of(store.identity());
    damaged_file = folder.mend_store(std::move(store), stored).damaged_file;
    store = open();
  }
  if (store.identity().experiment != experiment.canonical_text) {
    expect_extensible(experiment, folder, store);
    const Experiment former = experiment_of(store.identity());
    folder.extend_store(std::move(store), former, experiment);
    store = open();
  }
  if (store.identity().shard != execution.shard) {
    throw refused(execution.folder, "has another part of the experiment", "choose another folder");
  }
  return store;
}

/// `folder`: claimed; absent: in memory.
Store store_for(const Experiment& experiment, const std::optional<RunFolder>& folder, const Execution& execution,
                std::optional<fs::path>& damaged_file) {
  Identity identity{
      .experiment = experiment.canonical_text, .code = base::code_identity(), .files = ".", .shard = execution.shard};
  if (!folder) return Store::in_memory(identity);
  if (experiment.canonical_text.empty()) {
    throw refused(folder->name(), "an experiment without text cannot be kept in a folder",
                  "read the experiment from a file or from text, or run it in memory");
  }
  if (folder->has_store()) return store_in_folder(experiment, *folder, execution, damaged_file);
  folder->expect_own_report(identity);
  identity.files = fs::absolute(execution.files).lexically_normal().string();
  return folder->create_store(identity);
}

/// What both ways to a result have in common.
RunResult look_at(const Experiment& experiment, Store store, base::StopRequest stop = {}) {
  const Completeness state = completeness(experiment, store);
  RunResult run{.result = {}, .done = state.done, .all = state.all, .counts = {}, .store = {}};
  run.counts.resize(experiment.conditions.size());
  store.for_each([&](const RealisationKey& key, const Summary& summary) {
    const bool is_wanted = key.condition < run.counts.size() &&
                           key.realisation < effective_realisations(experiment.conditions[key.condition]);
    if (is_wanted) ++run.counts[key.condition][summary.mode];
  });
  try {
    if (!store.identity().shard) run.result = result_of(experiment, store, stop);
  } catch (const base::Stopped&) {
    run.result.reset();
  }
  run.store = std::make_shared<Store>(std::move(store));
  return run;
}

}  // namespace

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

RunResult run(const Experiment& experiment, const Execution& execution) {
  check_experiment(experiment);
  check_strobe(experiment);
  if (execution.shard) check_shard(experiment, *execution.shard);
  std::optional<RunFolder> folder;
  if (!execution.folder.empty()) folder.emplace(execution.folder).claim();
  std::optional<fs::path> damaged_file;
  Store store = store_for(experiment, folder, execution, damaged_file);
  const OptionsOfExecution asked(execution);
  // Whether it ended or was stopped follows from the rows.
  static_cast<void>(run(experiment, store, asked.options()));
  if (folder) store.close_up();
  RunResult found = look_at(experiment, std::move(store), asked.stop());
  found.damaged_file = std::move(damaged_file);
  return found;
}

std::string bytes_of(const RunResult& run) { return store_of(run).bytes(); }

RunResult run_of(const Experiment& experiment, const std::string& bytes) {
  check_experiment(experiment);
  Store store = Store::of_bytes(bytes);
  if (store.identity().experiment != experiment.canonical_text) {
    refuse("bytes", "", "are of a run of another experiment; give the experiment of that run");
  }
  return look_at(experiment, std::move(store));
}

StoredRun open_run(const fs::path& folder) { return stored_run(RunFolder(folder).open_valid_store()); }

StoredRun stored_run(Store store) {
  StoredRun stored{.experiment = experiment_of(store.identity()), .run = {}};
  stored.run = look_at(stored.experiment, std::move(store));
  return stored;
}

StoredRun resume(const fs::path& folder, const Overrides& extension, const Execution& execution) {
  const OptionsOfExecution asked(execution);
  FolderRun going_on = resume_run(folder, extension, {.threads = execution.threads, .page = false});
  const RunEnd end = run_in_folder(going_on, asked.options());
  going_on.store.close_up();
  if (end == RunEnd::complete) going_on.folder.install_replacement();
  return stored_run(std::move(going_on.store));
}

std::vector<RunRealisation> realisations_of(const RunResult& run) {
  std::vector<RunRealisation> found;
  run.store->for_each([&found](const RealisationKey& key, const Summary& summary) {
    found.push_back({.key = key,
                     .mode = summary.mode,
                     .termination = summary.termination,
                     .left_ground = summary.left_ground,
                     .was_past_balance = summary.was_past_balance,
                     .overturned_side = summary.overturned_side,
                     .margin = summary.margin,
                     .peaks = summary.peaks});
  });
  return found;
}

std::string report(const Experiment& experiment, const RunResult& run, const Provenance& provenance) {
  return report_text(with_text(experiment), complete_result(experiment, run), facts_of(provenance));
}

std::string table(const Experiment& experiment, const RunResult& run, std::size_t width) {
  return run_table(report_of(with_text(experiment), complete_result(experiment, run), {}), {.width = width});
}

std::string digest_of(const RunResult& run) { return base::to_hex(complete_result(run).digest); }

Plan plan(const Experiment& experiment, const std::function<double()>& elapsed_seconds, const Execution& execution) {
  check_experiment(experiment);
  check_strobe(experiment);
  if (execution.shard) check_shard(experiment, *execution.shard);
  const OptionsOfExecution asked(execution);
  const Means means{.threads = asked.options().threads, .shard = execution.shard};
  Plan found = plan_of(experiment, means);
  if (!elapsed_seconds) return found;
  found.time = estimate_time(experiment, means, {.elapsed_seconds = elapsed_seconds, .stop = asked.stop()});
  asked.stop().check();
  return found;
}

std::string describe(const Plan& plan) { return plan_text(plan); }

std::string describe_block(const Experiment& experiment) { return block_text(experiment); }

std::string describe_as_json(const Plan& plan) { return facts_text(plan_facts(plan)); }

}  // namespace rocking
