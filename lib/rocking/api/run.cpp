#include "rocking/api/run.hpp"

#include <stdexcept>
#include <utility>

#include "rocking/api/refuse.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/shard.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/api/written_experiment.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/run_table.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/store/store.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

namespace fs = std::filesystem;

std::string code_name() {
  const base::BuildInfo build = base::build_info();
  return std::string(build.version) + ' ' + std::string(build.revision);
}

Store store_for(const Experiment& experiment, const Execution& execution) {
  const fs::path& folder = execution.folder;
  Identity identity{
      .experiment = experiment.canonical_text, .code = code_name(), .files = ".", .shard = execution.shard};
  if (folder.empty()) return Store::in_memory(identity);
  if (experiment.canonical_text.empty()) {
    throw refused(folder, "an experiment without text cannot be kept in a folder",
                  "read the experiment from a file or from text, or run it in memory");
  }
  if (!has_store(folder)) {
    identity.files = fs::absolute(execution.files).lexically_normal().string();
    return Store::create(store_in(folder), identity);
  }
  Store store = Store::open(store_in(folder), sqlite::Access::write);
  if (store.identity().experiment != experiment.canonical_text) {
    throw refused(folder, "has realisations of another experiment", "choose another folder");
  }
  if (store.identity().shard != execution.shard) {
    throw refused(folder, "has another part of the experiment", "choose another folder");
  }
  if (store.identity().results != results_version) {
    throw refused(folder, "was written by a version that may give other results", "choose another folder");
  }
  return store;
}

/// What both ways to a result have in common.
RunResult look_at(const Experiment& experiment, Store store, base::StopRequest stop = {}) {
  const Completeness state = completeness(experiment, store);
  RunResult run{.result = {}, .done = state.done, .all = state.all, .counts = {}, .store = {}};
  for (std::size_t i = 0; i < experiment.conditions.size(); ++i) {
    run.counts.push_back(store.mode_counts(i, effective_realisations(experiment.conditions[i])));
  }
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
  if (execution.shard) check_shard(experiment, *execution.shard);
  std::optional<FolderLock> lock;
  if (!execution.folder.empty()) lock.emplace(claimed(execution.folder));
  Store store = store_for(experiment, execution);
  const OptionsOfExecution asked(execution);
  // Whether it ended or was stopped follows from the rows.
  static_cast<void>(run(experiment, store, asked.options()));
  if (!execution.folder.empty()) store.close_up();
  return look_at(experiment, std::move(store), asked.stop());
}

StoredRun open_run(const std::filesystem::path& folder) {
  Store store = valid_store(folder);
  const Identity& identity = store.identity();
  StoredRun stored{
      .experiment = read_experiment(identity.experiment, Overrides{}, {.files = files_seen_from(identity.files)}),
      .run = {}};
  stored.run = look_at(stored.experiment, std::move(store));
  return stored;
}

std::string report(const Experiment& experiment, const RunResult& run, const Provenance& provenance) {
  return report_text(with_text(experiment), complete_result(experiment, run), facts_of(provenance));
}

std::string table(const Experiment& experiment, const RunResult& run, std::size_t width) {
  return run_table(experiment, report_of(with_text(experiment), complete_result(experiment, run), {}),
                   {.width = width});
}

std::string digest_of(const RunResult& run) { return base::to_hex(complete_result(run).digest); }

}  // namespace rocking
