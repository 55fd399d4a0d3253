#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "arguments.hpp"
#include "campaign.hpp"
#include "commands.hpp"
#include "experiment_argument.hpp"
#include "machine.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/output/cost_report.hpp"
#include "rocking/output/cost_table.hpp"
#include "rocking/studies/cost/budget.hpp"
#include "study_file.hpp"
#include "watched.hpp"

namespace rocking::program {
namespace {

struct CostCommand {
  std::string experiment;
  CostRequest cost{.elapsed_seconds = seconds_from_now(), .processor_seconds = thread_seconds};
  StudyFile file{"cost.json"};
  Overrides overrides;
  ExecutionOptions execution{.threads = available_threads(), .max_time = {}, .loudness = {}};
};

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

ExitCode cost(CostCommand& command) {
  const Experiment experiment = load_experiment(command.experiment, command.overrides);
  try {
    check_request(experiment, command.cost);
  } catch (const base::InputError& error) {
    throw with_flags(error, {{"tolerances", "--tolerances"}});
  }
  command.file.prepare();
  MeasuredCost measured{.experiment = &experiment, .cost = {}, .system = system_facts(command.execution.threads)};
  {
    Progress progress(suitable_progress_style(command.execution.loudness), "realisations");
    measured.cost = rocking::cost(experiment, command.cost, watched(command.execution, progress));
    measured.system.duration_s = progress.elapsed();
  }
  const std::string text = cost_document().text(cost_report(measured));
  const std::string table = heading(experiment) + cost_table(measured) + fixed_horizon_note(experiment);
  deliver_study(command.execution.loudness, text, table, [&] { return command.file.write(text); });
  return ExitCode::done;
}

void add_budget(CLI::App& command, CostCommand& asked) {
  CLI::Option* time = add_duration(command, "--max-time,--time", asked.cost.seconds,
                                   "Measure as many realisations as possible in this time, e.g. 5min")
                          ->capture_default_str();
  command
      .add_option("--sample", asked.cost.sample, "Measure N realisations; gives the same numbers again, except times")
      ->check(whole_number(1, largest_cost_sample))
      ->excludes(time)
      ->type_name("N");
  command
      .add_option("--tolerances", asked.cost.tolerances,
                  "Instead of 1e-4, 1e-5, ... 1e-14; the experiment's own is added")
      ->delimiter(',')
      ->check(number(1e-16, 1e-2))
      ->type_name("T,T,T");
}

}  // namespace

void add_cost(CLI::App& app, Action& action) {
  const auto request = std::make_shared<CostCommand>();
  CLI::App* command = app.add_subcommand("cost", "Measure the cost of accuracy in time, on a sample of an experiment");
  command->footer(
      "Example: rocking cost experiments/headline/headline.json --max-time 5min -o out\n"
      "runs a sample of the realisations at a series of tolerances with common random numbers. Prints, for each "
      "tolerance, the error, the number of response modes that change, and the time per period; for larger numbers of "
      "realisations, the width of the intervals and the time; and a recommended tolerance. `-o` saves the numbers in "
      "out/cost.json. Times are processor times of this machine.");
  add_experiment(*command, request->experiment);
  add_budget(*command, *request);
  add_threads(*command, request->execution);
  add_seed(*command, request->overrides);
  command
      ->add_option("--realisations", request->overrides.realisations,
                   "Intended realisations per condition, instead of the file's")
      ->type_name("N");
  request->file.add_to(*command, false);
  add_loudness(*command, request->execution.loudness);
  command->final_callback([&action, request] { action = [request] { return cost(*request); }; });
}

}  // namespace rocking::program
