#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "campaign.hpp"
#include "commands.hpp"
#include "ground_motion_notes.hpp"
#include "interrupt.hpp"
#include "needs.hpp"
#include "output.hpp"
#include "rocking/output/plan_text.hpp"
#include "run_folder.hpp"

namespace rocking::program {
namespace {

struct RunRequest {
  std::string file;
  std::string folder;
  std::optional<std::string> shard;
  Overrides overrides;
  ExecutionOptions execution;
  bool dry_run = false;
  bool overwrite = false;
};

/// `2/5` as a shard.
Shard shard_from(const std::string& text) {
  Shard shard;
  const std::size_t slash = text.find('/');
  const auto whole = [&text](std::size_t from, std::size_t length) -> std::uint64_t {
    const std::string digits = text.substr(from, length);
    const bool good =
        !digits.empty() && digits.size() < 10 && digits.find_first_not_of("0123456789") == std::string::npos;
    return good ? std::stoull(digits) : 0;
  };
  if (slash != std::string::npos) {
    shard = {.part = whole(0, slash), .parts = whole(slash + 1, std::string::npos)};
    if (1 <= shard.part && shard.part <= shard.parts) return shard;
  }
  throw UsageError(
      fmt::format("--shard {}: is not a part of a whole; give i/n with 1 <= i <= n, for example 2/5", text));
}

Means means_of(const RunRequest& request) {
  return {.threads = request.execution.threads,
          .shard = request.shard ? std::optional(shard_from(*request.shard)) : std::nullopt,
          .page = request.execution.page == PageChoice::drawn};
}

ExitCode show_plan(const RunRequest& request, const Experiment& experiment) {
  const Means means = means_of(request);
  Plan plan = plan_of(experiment, means);
  plan.time =
      estimate_time(experiment, means,
                    {.elapsed_seconds =
                         [start = std::chrono::steady_clock::now()] {
                           return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
                         },
                     .stop = stop_on_signal()});
  if (why_stopped() == StopReason::signal) return ExitCode::interrupted;
  if (plan.time) plan.time->seconds /= request.execution.pool.processes;
  if (!plan.time)
    print_notice(fmt::format("the time is not known: no realisation was finished within {:g} s", longest_sample_s));
  print_result(request.execution.loudness.json ? facts_text(plan_facts(plan)) : base::printable(plan_text(plan)));
  return ExitCode::done;
}

void expect_no_run(const RunFolder& folder) {
  if (folder.has_report()) {
    throw InTheWay(folder.report_path().string() +
                   ": already exists; choose another folder, or add --overwrite to replace it");
  }
  if (folder.has_store() || folder.has_replacement()) {
    throw InTheWay(
        fmt::format("{0}: contains a run; `rocking resume {0}` continues it. Otherwise choose another folder, "
                    "or add --overwrite to replace it",
                    folder.name()));
  }
}

void expect_fixed_numbers(const Experiment& experiment) {
  for (const Condition& condition : experiment.conditions) {
    if (condition.until) {
      throw UsageError(
          "--shard: cannot be combined with `until`, because one part does not know the counts of the others; give a "
          "number of realisations");
    }
  }
}

std::string folder_of(const std::string& file) {
  return std::filesystem::absolute(file).parent_path().lexically_normal().string();
}

ExitCode run(const RunRequest& request) {
  const auto shard = request.shard ? std::optional(shard_from(*request.shard)) : std::nullopt;
  const Experiment experiment = load_experiment(request.file, request.overrides);
  if (!request.execution.loudness.quiet) tell_ground_motion_notes(experiment);
  if (request.dry_run) return show_plan(request, experiment);
  const Plan plan = plan_of(experiment, means_of(request));
  // With a time limit a run may end with few strobe points, so its needs are not known.
  if (!request.execution.max_time) expect_memory(plan.needs.memory_bytes);
  if (shard) expect_fixed_numbers(experiment);
  RunFolder folder(request.folder);
  folder.claim();
  folder.tidy_up();
  if (!request.overwrite) expect_no_run(folder);
  if (request.execution.loudness.verbose) print_notice(fmt::format("{}: {}", request.file, plan_text(plan)));
  if (!plan.at_most) folder.expect_room(plan.needs.disk_bytes);
  if (folder.has_store() || folder.has_report()) folder.begin_replacement();
  Store store = folder.create_store({.experiment = experiment.canonical_text,
                                     .code = code_identity(),
                                     .files = folder_of(request.file),
                                     .shard = shard});
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
      "and\n"
      "out/report.html, and prints a table of the responses.");
  command
      ->add_option("EXPERIMENT", request->file,
                   "Experiment file (JSON); -: standard input. `rocking schema experiment` describes it")
      ->required();
  const auto folder =
      command->add_option("-o,--output", request->folder, "Folder for the results; created if necessary")
          ->type_name("DIR");
  add_threads(*command, request->execution);
  command
      ->add_option("--seed", request->overrides.seed,
                   "Seed, instead of the one in the file, for example 0x2012 or 8210")
      ->type_name("S");
  command
      ->add_option("--realisations", request->overrides.realisations,
                   "Realisations per condition, instead of the number in the file")
      ->type_name("N");
  command->add_option("--shard", request->shard, "Run only the i-th of n parts; `rocking merge` joins them")
      ->type_name("I/N");
  add_max_time(*command, request->execution);
  add_page_choice(*command, request->execution.page);
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
