#include "resumption.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "machine.hpp"
#include "output.hpp"
#include "realisation_list.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/ensemble/extension.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/store/results_version.hpp"
#include "rocking/store/salvage.hpp"
#include "rocking/studies/plan/plan.hpp"
#include "rocking/text/number_text.hpp"
#include "run_folder.hpp"

namespace rocking::program {
namespace {

bool holds_run(const RunFolder& folder) {
  return folder.has_store() || folder.has_replacement() || folder.is_half_installed();
}

// Realisations of another results version are not mixed with this program's: the bits could differ.
void expect_same_results(const RunFolder& folder, const Identity& identity) {
  if (identity.results == results_version) return;
  throw InTheWay(fmt::format(
      "{}: was begun by rocking {}, this is {}, which may give different results; finish it with the former, "
      "or start again in another folder",
      folder.name(), identity.code, base::code_identity()));
}

// Damage is found before rows are added.
Store mended_store(const RunFolder& folder, const Experiment& experiment, Store store) {
  const auto damage = store.damage();
  if (!damage) return store;
  const Repair repair = folder.mend_store(std::move(store), experiment);
  Store mended = folder.open_store(sqlite::Access::write);
  const auto missing = missing_realisations(experiment, mended);
  print_notice(fmt::format("{}; {} in it {} intact and kept, the rest is run again: {}. The damaged file is now {}",
                           *damage, counted(repair.realisations, "realisation"),
                           repair.realisations == 1 ? "is" : "are", listed_realisations(missing),
                           repair.damaged_file.string()));
  return mended;
}

void expect_extensible(const RunFolder& folder, const Store& store, const Experiment& extension) {
  if (store.identity().shard) {
    throw UsageError(folder.name() +
                     ": is a shard, and the shards of a longer run have other realisations; merge the shards, then "
                     "extend the whole");
  }
  const std::uint64_t stored = most_stored_realisations(store);
  std::uint64_t wanted = 0;
  for (const Condition& condition : extension.conditions) wanted = std::max(wanted, condition.realisations);
  if (stored <= wanted) return;
  throw UsageError(fmt::format("--realisations {}: {} already has conditions with {}; give at least {}", wanted,
                               folder.name(), counted(stored, "realisation"), stored));
}

// A finished run stays in its folder until the extended one is complete. An unfinished one has no report yet, and its
// store is extended in place.
Store extended_store(RunFolder& folder, const Experiment& experiment, const Experiment& extension, Store store,
                     const Loudness& loudness) {
  if (!folder.is_replacement() && folder.has_report()) {
    if (!loudness.quiet) {
      print_notice(
          "the intervals of the extended run cover as often as stated if the earlier result did not determine its "
          "length; for a run that is extended until its intervals are narrow enough, use `until`");
    }
    store.close_up();
    folder.begin_replacement();
  } else {
    std::filesystem::remove(folder.report_path());  // of a replacement that was not installed: not of the extension
  }
  folder.extend_store(std::move(store), experiment, extension);
  return folder.open_store(sqlite::Access::write);
}

}  // namespace

ExitCode resume_run(const ResumeRequest& request) {
  if (!holds_run(RunFolder(request.folder))) {
    throw MissingInput(request.folder + ": contains no run to resume (realisations.sqlite is missing or empty)");
  }
  RunFolder folder(request.folder);
  folder.claim();
  folder.tidy_up();
  if (folder.has_replacement()) folder.enter_replacement();
  count_pages_again(folder.store_path());
  Store store = folder.open_store(sqlite::Access::write);
  expect_same_results(folder, store.identity());
  const Experiment experiment = experiment_of(store.identity());
  store = mended_store(folder, experiment, std::move(store));
  const Overrides extension{.seed = {}, .realisations = request.realisations, .levels = request.levels};
  const bool is_asked = request.realisations || !request.levels.empty();
  const Experiment wanted = is_asked ? experiment_of(store.identity(), extension) : experiment;
  const bool is_extension = wanted.canonical_text != experiment.canonical_text;
  if (is_extension) expect_extensible(folder, store, wanted);
  const Plan plan = plan_of(wanted, {.threads = request.execution.threads,
                                     .shard = store.identity().shard,
                                     .stored = completeness(wanted, store).done,
                                     .page = request.execution.page == PageChoice::drawn});
  if (!request.execution.max_time) expect_memory(plan.needs.memory_bytes);
  if (!plan.at_most) folder.expect_room(plan.needs.disk_bytes);
  if (is_extension) {
    store = extended_store(folder, experiment, wanted, std::move(store), request.execution.loudness);
  }
  return run_to_end(folder, wanted, store, request.execution);
}

}  // namespace rocking::program
