#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "campaign.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/output/cost_report.hpp"
#include "rocking/output/cost_table.hpp"
#include "rocking/studies/cost/budget.hpp"
#include "rocking/text/files.hpp"

namespace rocking::program {
namespace {

struct CostRequest {
  std::string file;
  std::string folder;  ///< empty: nothing is written
  double time = 60.0;  ///< to spend [s]
  std::optional<std::uint64_t> sample;
  std::vector<double> tolerances;  ///< empty: the usual ones
  Overrides overrides;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
  bool overwrite = false;
};

std::vector<double> tolerances_of(const CostRequest& request, const Experiment& experiment) {
  std::vector<double> all = cost_tolerances(experiment, request.tolerances);
  if (all.size() >= 3) return all;
  throw UsageError(
      "--tolerances: with the experiment's own these are fewer than three; the tightest is the reference and the "
      "second tightest the floor, so give at least three, for example 1e-8,1e-11,1e-14");
}

/// Absent if interrupted.
std::optional<Cost> measured(const Experiment& experiment, const CostRequest& request,
                             const std::vector<double>& tolerances, Progress& progress) {
  const CostBudget budget{.seconds = request.time, .sample = request.sample};
  RunOptions options;
  options.threads = request.execution.threads;
  options.stop_requested = &stop_on_interrupt();
  options.on_progress = [&](std::uint64_t done, std::uint64_t all) {
    progress.show(done, budget.sample ? all : std::min(all, expected_sample(budget, done, progress.elapsed())),
                  [] { return "times are measured afterwards"; });
  };
  return cost_within(experiment, tolerances, budget,
                     {.elapsed_seconds = [&] { return progress.elapsed(); }, .processor_seconds = thread_seconds},
                     options);
}

/// A line on until_classified; empty if no condition has it.
std::string fixed_horizon_note(const Experiment& experiment) {
  double most = 0.0;
  for (const Condition& condition : experiment.conditions) {
    const Horizon& horizon = condition.horizon;
    if (!horizon.until_classified) continue;
    const double fixed = static_cast<double>(horizon.transient_periods) + horizon.sampled_periods;
    most = std::max(most, static_cast<double>(horizon.until_classified->at_most_periods) / fixed);
  }
  if (most <= 1.0) return "";
  return fmt::format(
      "until_classified: errors, response modes and times are those of the fixed horizon. A realisation that goes on "
      "to "
      "its limit has {:.3g} times as many periods; `rocking run --dry-run` estimates how many go on\n",
      most);
}

std::filesystem::path cost_file_in(const std::string& folder) { return std::filesystem::path(folder) / "cost.json"; }

ExitCode cost(const CostRequest& request) {
  const Experiment experiment = load_experiment(request.file, request.overrides);
  const std::vector<double> tolerances = tolerances_of(request, experiment);
  const bool is_kept = !request.folder.empty();
  if (is_kept) {
    expect_free(cost_file_in(request.folder), request.overwrite);
    ensure_writable(request.folder);
  }
  SystemFacts system = system_facts(request.execution.threads);
  std::optional<Cost> found;
  {
    Progress progress(suitable_progress_style(request.execution.loudness), "realisations");
    found = measured(experiment, request, tolerances, progress);
    system.duration_s = progress.elapsed();
  }
  if (!found) {
    print_notice(fmt::format("interrupted; nothing was written. `rocking cost {}` starts again", request.file));
    return ExitCode::interrupted;
  }
  const MeasuredCost result{.experiment = &experiment, .cost = *std::move(found), .system = std::move(system)};
  const std::string text = cost_document().text(cost_report(result));
  std::string table =
      (experiment.title.empty() ? "" : experiment.title + "\n\n") + cost_table(result) + fixed_horizon_note(experiment);
  if (is_kept) {
    expect_free(cost_file_in(request.folder), request.overwrite);
    write_atomically(cost_file_in(request.folder), text);
    table += fmt::format("numbers: {}\n", cost_file_in(request.folder).string());
  }
  print_result(request.execution.loudness.json ? text : base::printable(table));
  return ExitCode::done;
}

void add_budget(CLI::App& command, CostRequest& request) {
  CLI::Option* time =
      add_duration(command, "--time", request.time, "Measure as many realisations as possible in this time, e.g. 5min")
          ->capture_default_str();
  command.add_option("--sample", request.sample, "Measure N realisations; gives the same numbers again, except times")
      ->check(whole_number(1, largest_cost_sample))
      ->excludes(time)
      ->type_name("N");
  command
      .add_option("--tolerances", request.tolerances, "Instead of 1e-4, 1e-5, ... 1e-14; the experiment's own is added")
      ->delimiter(',')
      ->check(number(1e-16, 1e-2))
      ->type_name("T,T,T");
}

}  // namespace

void add_cost(CLI::App& app, Action& action) {
  const auto request = std::make_shared<CostRequest>();
  CLI::App* command = app.add_subcommand("cost", "Measure the cost of accuracy in time, on a sample of an experiment");
  command->footer(
      "Example: rocking cost experiments/headline/headline.json --time 5min -o out\n"
      "runs a sample of the realisations at a series of tolerances with common random numbers. Prints, for each "
      "tolerance, the\n"
      "error, the number of response modes that change, and the time per period; for larger numbers of realisations, "
      "the width\n"
      "of the intervals and the time; and a recommended tolerance. `-o` saves the numbers in out/cost.json. Times are "
      "processor\n"
      "times of this machine.");
  command->add_option("EXPERIMENT", request->file, "Experiment file (JSON); -: standard input")->required();
  command->add_option("-o,--output", request->folder, "Folder for cost.json; created if necessary")->type_name("DIR");
  add_budget(*command, *request);
  add_threads(*command, request->execution);
  command
      ->add_option("--seed", request->overrides.seed,
                   "Seed, instead of the one in the file, for example 0x2012 or 8210")
      ->type_name("S");
  command
      ->add_option("--realisations", request->overrides.realisations,
                   "Intended realisations per condition, instead of the file's")
      ->type_name("N");
  command->add_flag("--overwrite", request->overwrite, "Replace cost.json in the folder");
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return cost(*request); }; });
}

}  // namespace rocking::program
