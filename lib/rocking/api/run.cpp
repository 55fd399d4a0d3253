#include "rocking/api/run.hpp"

#include <utility>

#include "rocking/api/folder_run.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/output/plan_text.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/run_table.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/store/store.hpp"
#include "rocking/store/store_identity.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;

/// What both ways to a result have in common.
RunResult look_at(const Experiment& experiment, Store store, unsigned threads = 1) {
  const Completeness state = completeness(experiment, store);
  RunResult run{.result = {}, .done = state.done, .all = state.all, .counts = {}, .store = {}};
  run.counts.resize(experiment.conditions.size());
  run.result =
      result_of(experiment, store, {.threads = threads}, [&](const RealisationKey& key, const Summary& summary) {
        if (key.realisation < effective_realisations(experiment.conditions[key.condition]))
          ++run.counts[key.condition][summary.mode];
      });
  if (store.identity().shard) run.result.reset();
  run.store = std::make_shared<Store>(std::move(store));
  return run;
}

/// Runs what is missing. Whether it ended or was stopped follows from the rows.
RunResult finished(FolderRun run, const OptionsOfExecution& asked) {
  const RunEnd end = run_in_folder(run, asked.options());
  run.store.close_up();
  if (end == RunEnd::complete) run.folder.install_replacement();
  RunResult found = look_at(run.experiment, std::move(run.store), asked.options().threads);
  found.damaged_file = std::move(run.damaged_file);
  return found;
}

}  // namespace

RunResult run(const Experiment& experiment, const Execution& execution) {
  check_experiment(experiment);
  check_strobe(experiment);
  if (execution.shard) check_shard(experiment, *execution.shard);
  const OptionsOfExecution asked(execution);
  if (execution.folder.empty()) {
    Store store = Store::in_memory({.experiment = experiment.canonical_text,
                                    .code = base::code_identity(),
                                    .files = ".",
                                    .shard = execution.shard});
    static_cast<void>(run(experiment, store, asked.options()));
    return look_at(experiment, std::move(store), asked.options().threads);
  }
  return finished(with_input_errors([&] {
                    return begin_or_continue_run(
                        execution.folder, experiment, {.files = execution.files, .shard = execution.shard},
                        {.threads = execution.threads, .page = false, .repair = execution.repair});
                  }),
                  asked);
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

StoredRun open_run(const fs::path& folder, unsigned threads) {
  return stored_run(RunFolder(folder).open_valid_store(), threads);
}

StoredRun stored_run(Store store, unsigned threads) {
  StoredRun stored{.experiment = experiment_of(store.identity()), .run = {}};
  stored.run = look_at(stored.experiment, std::move(store), threads);
  return stored;
}

StoredRun resume(const fs::path& folder, const Overrides& extension, const Execution& execution) {
  const OptionsOfExecution asked(execution);
  FolderRun going_on = resume_run(folder, extension, {.threads = execution.threads, .page = false});
  StoredRun stored{.experiment = going_on.experiment, .run = {}};
  stored.run = finished(std::move(going_on), asked);
  return stored;
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

Plan plan(const Experiment& experiment, const Execution& execution) {
  check_experiment(experiment);
  check_strobe(experiment);
  if (execution.shard) check_shard(experiment, *execution.shard);
  const OptionsOfExecution asked(execution);
  const Means means{.threads = asked.options().threads, .shard = execution.shard};
  Plan found = plan_of(experiment, means);
  if (!execution.elapsed_seconds) return found;
  found.time = estimate_time(experiment, means, {.elapsed_seconds = execution.elapsed_seconds, .stop = asked.stop()});
  asked.stop().check();
  return found;
}

std::string describe(const Plan& plan) { return plan_text(plan); }

std::string describe_block(const Experiment& experiment) { return block_text(experiment); }

std::string describe_as_json(const Plan& plan) { return facts_text(plan_facts(plan)); }

}  // namespace rocking
