#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "commands.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "plan.hpp"
#include "progress.hpp"
#include "rocking/base/build_info.hpp"
#include "rocking/experiment/run.hpp"
#include "rocking/report/files.hpp"
#include "rocking/report/mode_table.hpp"
#include "rocking/report/write_report.hpp"

namespace rocking::program {
namespace {

struct RunRequest {
  std::string file;
  std::string folder;
  unsigned threads = available_threads();
  report::Overrides overrides;
  bool dry_run = false;
  bool overwrite = false;
  Loudness loudness;
};

std::filesystem::path report_path(const RunRequest& request) {
  return std::filesystem::path(request.folder) / "report.json";
}

// Everything that could keep the report from being written shows here, before hours are spent.
void prepare_folder(const RunRequest& request) {
  report::ensure_writable(request.folder);
  const auto path = report_path(request);
  if (std::filesystem::exists(path) && !request.overwrite) {
    throw InTheWay(path.string() + ": is already there; choose another folder, or add --overwrite to replace it");
  }
}

ExitCode show_plan(const RunRequest& request, const experiment::Experiment& experiment) {
  const Plan plan = plan_of(experiment);
  print_result(request.loudness.json ? report::facts_text(facts_of(plan)) : to_text(plan));
  return ExitCode::done;
}

std::uint64_t unresolved_realisations(const experiment::ExperimentResult& result) {
  std::uint64_t count = 0;
  for (const auto& condition : result.conditions) {
    for (const auto& [mode, probability] : condition.modes) {
      if (mode.kind == section::ResponseKind::unresolved) count += probability.counts.successes;
    }
  }
  return count;
}

std::string summary_of(const experiment::Experiment& experiment, const experiment::ExperimentResult& result) {
  std::uint64_t realisations = 0;
  for (const auto& condition : result.conditions) realisations += condition.realisations;
  std::string text = experiment.title.empty() ? "" : experiment.title + "\n\n";
  text += report::mode_table(experiment, result);
  text += fmt::format("\nper cent of n realisations [simultaneous {:g} % interval]; {}, {}, of which {} unresolved\n",
                      100.0 * experiment.conditions.front().confidence, counted(result.conditions.size(), "condition"),
                      counted(realisations, "realisation"), unresolved_realisations(result));
  return text;
}

std::optional<experiment::ExperimentResult> simulate(const RunRequest& request,
                                                     const experiment::Experiment& experiment, Progress& progress) {
  experiment::RunOptions options;
  options.threads = request.threads;
  options.stop_requested = &stop_on_interrupt();
  options.on_progress = [&progress](std::uint64_t done, std::uint64_t all) { progress.show(done, all); };
  return experiment::run(experiment, options);
}

ExitCode run(const RunRequest& request) {
  const experiment::Experiment experiment = load_experiment(request.file, request.overrides);
  if (request.dry_run) return show_plan(request, experiment);
  prepare_folder(request);
  const Loudness& loudness = request.loudness;
  if (loudness.verbose) print_notice(fmt::format("{}: {}", request.file, to_text(plan_of(experiment))));

  report::SystemFacts system{
      .build = base::build_info(), .machine = machine_description(), .start = utc_now(), .threads = request.threads};
  std::optional<experiment::ExperimentResult> result;
  {
    Progress progress(loudness.quiet || loudness.no_progress ? ProgressStyle::none : suitable_progress_style());
    result = simulate(request, experiment, progress);
    system.duration_s = progress.elapsed();
  }
  if (!result) {
    print_notice("interrupted; nothing was written, and a new run starts from the beginning");
    return ExitCode::interrupted;
  }
  const std::string text = report::report_text(experiment, *result, system);
  report::write_atomically(report_path(request), text);
  const std::string where = fmt::format("report: {}\n", report_path(request).string());
  print_result(loudness.json ? text : summary_of(experiment, *result) + where);
  if (!loudness.quiet) {
    print_notice(fmt::format("{} on {}", spoken_duration(system.duration_s), counted(request.threads, "thread")));
  }
  return ExitCode::done;
}

}  // namespace

void add_run(CLI::App& app, Action& action) {
  const auto request = std::make_shared<RunRequest>();
  CLI::App* command = app.add_subcommand("run", "Simulate an experiment: how likely is each response?");
  command->footer(
      "Example: rocking run experiments/headline/headline.json -o out\n"
      "simulates every realisation of every condition, prints a table of the responses and writes out/report.json.");
  command->add_option("EXPERIMENT", request->file, "Experiment file (JSON); `rocking schema experiment` describes it")
      ->required();
  const auto folder =
      command->add_option("-o,--output", request->folder, "Folder for the report; made if need be")->type_name("DIR");
  command->add_option("-j,--threads", request->threads, "Threads; changes the time, never the result")
      ->check(CLI::Range(1U, 4096U))
      ->capture_default_str()
      ->type_name("N");
  command->add_option("--seed", request->overrides.seed, "Seed in place of the file's, as 0x2012 or 8210")
      ->type_name("S");
  command
      ->add_option("--realisations", request->overrides.realisations,
                   "Realisations of each condition in place of the file's")
      ->type_name("N");
  const auto dry_run =
      command->add_flag("--dry-run", request->dry_run, "Say what would be done, and stop; writes nothing");
  command->add_flag("--overwrite", request->overwrite, "Replace a report that is already in the folder");
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request, folder, dry_run] {
    if (folder->empty() && dry_run->empty()) throw CLI::RequiredError("-o DIR (the folder for the report)");
    action = [request] { return run(*request); };
  });
}

}  // namespace rocking::program
