#include <memory>

#include "arguments.hpp"
#include "program.hpp"
#include "trajectory.hpp"

namespace rocking::program {

void add_trajectory(CLI::App& app, Action& action) {
  const auto request = std::make_shared<TrajectoryCommand>();
  CLI::App* command = app.add_subcommand(
      "trajectory", "Print one realisation of an experiment file or of a finished run: events and states");
  command->footer(
      "Example: rocking trajectory experiments/headline/headline.json --condition 12 --realisation 3 --periods 20\n"
      "prints the fourth realisation of the thirteenth condition over 20 periods. Numbers start at 0. With `--format "
      "csv --units si` it prints a table for a spreadsheet, in seconds, radians and metres. `rocking trajectory out "
      "--condition 12 --realisation 3` prints that of a run; the exit code is 1 if the bits differ from those of the "
      "run.");
  add_experiment(*command, request->experiment)
      ->description("Experiment file (JSON), -: standard input; or folder of a finished run")
      ->transform(run_folder());
  add_realisation(*command, request->trajectory);
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
