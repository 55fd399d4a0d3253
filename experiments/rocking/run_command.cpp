#include <filesystem>
#include <memory>
#include <string>

#include <fmt/format.h>

#include "arguments.hpp"
#include "before_run.hpp"
#include "campaign.hpp"
#include "output.hpp"
#include "program.hpp"
#include "rocking/rocking.hpp"

namespace rocking::program {
namespace {

struct RunRequest {
  std::string file;
  std::string folder;
  NewRun run;
  Overrides overrides;
  ExecutionOptions execution;
  bool dry_run = false;
  std::string running;  ///< folder whose progress is asked for; empty: none
};

ExitCode run(const RunRequest& request) {
  const Experiment experiment = load_sampled_experiment(request.file, request.overrides);
  if (request.dry_run) return show_plan(experiment, request.run.shard, request.execution);
  if (!request.execution.loudness.quiet) tell_notes(experiment);
  NewRun asked = request.run;
  asked.files = std::filesystem::absolute(request.file).parent_path();
  FolderMeans means = means_of(request.execution);
  if (request.execution.loudness.verbose)
    means.on_plan = [&](const Plan& plan) { print_notice(fmt::format("{}: {}", request.file, describe(plan))); };
  return run_to_end(begin_run(request.folder, experiment, asked, means), request.execution);
}

}  // namespace

void add_run(CLI::App& app, Action& action, const ProcessPool& pool) {
  const auto request = std::make_shared<RunRequest>();
  request->execution = {.threads = pool.threads, .max_time = {}, .loudness = {}, .pool = pool};
  CLI::App* command = app.add_subcommand("run", "Simulate an experiment and estimate the probability of each response");
  command->footer(
      "Example: rocking run experiments/headline/headline.json -o out\n"
      "simulates every realisation of every condition, stores them in out/realisations.sqlite, writes out/report.json "
      "and out/report.html, and prints a table of the responses. `rocking run --status out` prints how far it is");
  CLI::Option* experiment = add_experiment(*command, request->file)->required(false);
  const auto folder =
      command
          ->add_option("-o,--output", request->folder,
                       "Folder for the results; created if necessary; required except with --dry-run or --status")
          ->type_name("DIR");
  add_threads(*command, request->execution);
  add_seed(*command, request->overrides);
  add_realisations(*command, request->overrides, "Realisations per condition, instead of the number in the file");
  add_skip_unreadable(*command, request->overrides);
  add_shard(*command, request->run.shard);
  add_max_time(*command, request->execution);
  add_page_choice(*command, request->execution.page);
  add_extent(*command, request->execution.extent);
  const auto dry_run = command->add_flag("--dry-run", request->dry_run,
                                         "Print what would be done, with the time, and stop; writes nothing");
  command->add_flag("--overwrite", request->run.overwrite, "Replace the run in the folder when this one is complete");
  CLI::Option* status = add_status(*command, request->running);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request, experiment, folder, dry_run, status] {
    const bool is_new = status->empty();
    if (is_new && experiment->empty()) throw CLI::RequiredError("EXPERIMENT");
    if (is_new && folder->empty() && dry_run->empty()) throw CLI::RequiredError("-o DIR (the folder for the results)");
    action = [request, is_new] {
      return is_new ? run(*request) : show_status(request->running, request->execution.loudness);
    };
  });
}

}  // namespace rocking::program
