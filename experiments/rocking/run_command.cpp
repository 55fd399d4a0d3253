#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "arguments.hpp"
#include "campaign.hpp"
#include "commands.hpp"
#include "dry_run.hpp"
#include "experiment_argument.hpp"
#include "ground_motion_notes.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/output/plan_text.hpp"
#include "run_folder.hpp"

namespace rocking::program {
namespace {

struct RunRequest {
  std::string file;
  std::string folder;
  std::optional<Shard> shard;
  Overrides overrides;
  ExecutionOptions execution;
  bool dry_run = false;
  bool overwrite = false;
};

void expect_fixed_numbers(const Experiment& experiment) {
  for (const Condition& condition : experiment.conditions) {
    if (!condition.until) continue;
    throw UsageError(
        "--shard: cannot be combined with `until`, because one part does not know the counts of the others; give a "
        "number of realisations");
  }
}

std::string folder_of(const std::string& file) {
  return std::filesystem::absolute(file).parent_path().lexically_normal().string();
}

ExitCode run(const RunRequest& request) {
  const Experiment experiment = load_experiment(request.file, request.overrides);
  const Loudness& loudness = request.execution.loudness;
  if (!loudness.quiet) tell_ground_motion_notes(experiment);
  const Means means{.threads = request.execution.threads,
                    .shard = request.shard,
                    .page = request.execution.page == PageChoice::drawn};
  if (request.dry_run) return show_plan(experiment, means, request.execution);
  const Plan plan = plan_of(experiment, means);
  // With a time limit a run may end with few strobe points, so its needs are not known.
  if (!request.execution.max_time) expect_memory(plan.needs.memory_bytes);
  if (request.shard) expect_fixed_numbers(experiment);
  RunFolder folder(request.folder);
  folder.claim();
  folder.tidy_up();
  if (!request.overwrite) folder.expect_no_run();
  if (loudness.verbose) print_notice(fmt::format("{}: {}", request.file, plan_text(plan)));
  if (!plan.at_most) folder.expect_room(plan.needs.disk_bytes);
  if (folder.has_store() || folder.has_report()) folder.begin_replacement();
  Store store = folder.create_store({.experiment = experiment.canonical_text,
                                     .code = base::code_identity(),
                                     .files = folder_of(request.file),
                                     .shard = request.shard});
  return run_to_end(folder, experiment, store, request.execution);
}

}  // namespace

void add_run(CLI::App& app, Action& action, const ProcessPool& pool) {
  const auto request = std::make_shared<RunRequest>();
  request->execution = {.threads = pool.threads, .max_time = {}, .loudness = {}, .pool = pool};
  CLI::App* command = app.add_subcommand("run", "Simulate an experiment and estimate the probability of each response");
  command->footer(
      "Example: rocking run experiments/headline/headline.json -o out\n"
      "simulates every realisation of every condition, stores them in out/realisations.sqlite, writes out/report.json "
      "and out/report.html, and prints a table of the responses.");
  add_experiment(*command, request->file);
  const auto folder =
      command->add_option("-o,--output", request->folder, "Folder for the results; created if necessary")
          ->type_name("DIR");
  add_threads(*command, request->execution);
  add_seed(*command, request->overrides);
  command
      ->add_option("--realisations", request->overrides.realisations,
                   "Realisations per condition, instead of the number in the file")
      ->type_name("N");
  add_skip_unreadable(*command, request->overrides);
  add_shard(*command, request->shard);
  add_max_time(*command, request->execution);
  add_page_choice(*command, request->execution.page);
  add_extent(*command, request->execution.extent);
  const auto dry_run = command->add_flag("--dry-run", request->dry_run,
                                         "Print what would be done, with the time, and stop; writes nothing");
  command->add_flag("--overwrite", request->overwrite, "Replace the run in the folder when this one is complete");
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request, folder, dry_run] {
    if (folder->empty() && dry_run->empty()) throw CLI::RequiredError("-o DIR (the folder for the results)");
    action = [request] { return run(*request); };
  });
}

}  // namespace rocking::program
