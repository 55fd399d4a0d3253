#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "arguments.hpp"
#include "commands.hpp"
#include "experiment_argument.hpp"
#include "output.hpp"
#include "pages/animation.hpp"
#include "rocking/api/trajectory.hpp"
#include "rocking/api/trajectory_extent.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/text/files.hpp"
#include "study_file.hpp"
#include "trajectory_output.hpp"

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

ExitCode write_animation_page(const TrajectoryCommand& command, const Experiment& experiment) {
  const TrajectoryRequest& asked = command.trajectory;
  const auto text = pages::animation_page_of(experiment, {asked.condition, asked.realisation},
                                             TrajectoryExtent(periods_of(experiment, asked), asked.samples_per_period));
  if (!text) throw UsageError("--html: the block overturns before two samples were taken; give more --samples");
  write_atomically(command.page, *text);
  print_study(command.loudness, facts_text(std::vector<Fact>{{"written", std::vector{command.page}}}),
              command.page + '\n');
  return ExitCode::done;
}

ExitCode print_trajectory(const TrajectoryCommand& command) {
  expect_consistent(command.output, command.loudness);
  const Experiment experiment = load_experiment(command.experiment, command.overrides);
  const TrajectoryRequest& asked = command.trajectory;
  try {
    check_request(experiment, asked);
  } catch (const base::InputError& error) {
    throw with_flags(error, {{"condition", "--condition"}});
  }
  if (!command.page.empty()) return write_animation_page(command, experiment);
  print_result(text_of({asked.condition, asked.realisation}, trajectory(experiment, asked), command.output));
  return ExitCode::done;
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
  command->add_option("--condition", request->trajectory.condition, "Number of the condition, from 0")
      ->check(whole_number(0, random::realisation_limit - 1))
      ->capture_default_str()
      ->type_name("I");
  command->add_option("--realisation", request->trajectory.realisation, "Number of the realisation, from 0")
      ->check(whole_number(0, random::realisation_limit - 1))
      ->capture_default_str()
      ->type_name("K");
  command
      ->add_option("--periods", request->trajectory.periods, "Periods of the excitation; default: all of the horizon")
      ->check(whole_number(1, 100'000'000))
      ->type_name("N");
  command
      ->add_option("--samples", request->trajectory.samples_per_period,
                   "Adds a history: N states per period, evenly spaced; 0: none")
      ->check(whole_number(0, 100'000))
      ->capture_default_str()
      ->type_name("N");
  command
      ->add_option("--html", request->page,
                   "Writes a page with the animated block to this file instead of printing the trajectory")
      ->type_name("FILE");
  add_seed(*command, request->overrides);
  add_trajectory_output(*command, request->output);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return print_trajectory(*request); }; });
}

}  // namespace rocking::program
