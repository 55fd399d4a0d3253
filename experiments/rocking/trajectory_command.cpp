#include <memory>
#include <string>

#include "arguments.hpp"
#include "output.hpp"
#include "program.hpp"
#include "rocking/pages.hpp"
#include "rocking/rocking.hpp"

namespace rocking::program {
namespace {

struct TrajectoryCommand {
  std::string experiment;
  TrajectoryRequest trajectory;
  std::string page;  ///< file; empty: none
  Overrides overrides;
  TrajectoryOutput output;
  Loudness loudness;
};

ExitCode print_trajectory(const TrajectoryCommand& command) {
  expect_consistent(command.output, command.loudness);
  const Experiment experiment = load_experiment(command.experiment, command.overrides);
  const TrajectoryRequest& asked = command.trajectory;
  try {
    if (command.page.empty()) {
      print_result(text_of(asked, trajectory(experiment, asked), command.output));
    } else {
      write_trajectory_page(experiment, asked, command.page);
      print_written(command.loudness, {command.page});
    }
    return ExitCode::done;
  } catch (const base::InputError& error) {
    base::Problem problem = error.problems().front();
    if (problem.place == "samples_per_period") {
      throw UsageError("--html: the block overturns before two samples were taken; give more --samples");
    }
    if (problem.place == "condition") problem.place = "--condition";
    throw base::InputError(problem);
  }
}

}  // namespace

void add_trajectory(CLI::App& app, Action& action) {
  const auto request = std::make_shared<TrajectoryCommand>();
  CLI::App* command =
      app.add_subcommand("trajectory", "Print one realisation of an experiment file: events and states");
  command->footer(
      "Example: rocking trajectory experiments/headline/headline.json --condition 12 --realisation 3 --periods 20\n"
      "prints the fourth realisation of the thirteenth condition over 20 periods. Numbers start at 0. With `--format "
      "csv --units si` it prints a table for a spreadsheet, in seconds, radians and metres.");
  add_experiment(*command, request->experiment);
  add_realisation(*command, request->trajectory, Naming::optional);
  command
      ->add_option("--periods", request->trajectory.periods,
                   "Periods of the excitation from the initial state; default: all of the horizon")
      ->check(whole_number(1, 100'000'000))
      ->type_name("N");
  command
      ->add_option("--samples", request->trajectory.samples_per_period,
                   "Add a history: N states per period, evenly spaced; 0: none")
      ->check(whole_number(0, 100'000))
      ->capture_default_str()
      ->type_name("N");
  command
      ->add_option("--html", request->page,
                   "Write a page with the animated block to FILE and print its path, instead of the trajectory; with "
                   "--samples, from N states per period")
      ->type_name("FILE");
  add_seed(*command, request->overrides);
  add_trajectory_output(*command, request->output);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return print_trajectory(*request); }; });
}

}  // namespace rocking::program
