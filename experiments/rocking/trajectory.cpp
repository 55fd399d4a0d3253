#include "trajectory.hpp"

#include <filesystem>

#include "arguments.hpp"
#include "rocking/pages.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/rocking.hpp"
#include "usage.hpp"

namespace rocking::program {
namespace {

void expect_consistent(const TrajectoryOutput& output, const Loudness& loudness) {
  if (output.format == "csv" && loudness.json)
    throw UsageError("--json: the result is a table with `--format csv`; omit one of them");
}

std::string text_of(const TrajectoryRequest& asked, const Trajectory& trajectory, const TrajectoryOutput& output) {
  const TrajectoryUnits units = output.units == "si" ? TrajectoryUnits::si : TrajectoryUnits::normalised;
  return output.format == "csv" ? trajectory_csv(asked, trajectory, units) : trajectory_text(asked, trajectory, units);
}

/// Of a finished run, checked against its digest. Throws UsageError if more is asked for than a run has.
Trajectory replayed(const TrajectoryCommand& command) {
  const TrajectoryRequest& asked = command.trajectory;
  if (asked.periods || asked.samples_per_period != 0 || command.overrides.seed || !command.page.empty()) {
    throw UsageError(command.experiment +
                     ": is a run; --periods, --samples, --seed and --html need an experiment file");
  }
  return rocking::replay(command.experiment, asked);
}

void print_simulated(const TrajectoryCommand& command, const Experiment& experiment) {
  const TrajectoryRequest& asked = command.trajectory;
  try {
    if (command.page.empty()) {
      print_result(text_of(asked, trajectory(experiment, asked), command.output));
    } else {
      write_trajectory_page(experiment, asked, command.page);
      print_written(command.loudness, {command.page});
    }
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

void add_realisation(CLI::App& command, TrajectoryRequest& asked) {
  const auto add = [&](const char* name, std::uint64_t& number, const char* description, const char* type) {
    command.add_option(name, number, description)
        ->check(whole_number(0, random::realisation_limit - 1))
        ->capture_default_str()
        ->type_name(type);
  };
  add("--condition", asked.condition, "Number of the condition, from 0", "I");
  add("--realisation", asked.realisation, "Number of the realisation, which determines the random numbers, from 0",
      "K");
}

void add_trajectory_output(CLI::App& command, TrajectoryOutput& output) {
  command.add_option("--format", output.format, "Text to print; csv: a table for spreadsheets")
      ->check(one_of({"json", "csv"}))
      ->capture_default_str()
      ->type_name("NAME");
  command.add_option("--units", output.units, "Units of states and times: Theta, X, tau; or rad, m, s")
      ->check(one_of({"normalised", "si"}))
      ->capture_default_str()
      ->type_name("NAME");
}

ExitCode print_trajectory(const TrajectoryCommand& command) {
  expect_consistent(command.output, command.loudness);
  const TrajectoryRequest& asked = command.trajectory;
  try {
    if (std::filesystem::is_directory(command.experiment)) {
      print_result(text_of(asked, replayed(command), command.output));
    } else {
      print_simulated(command, load_experiment(command.experiment, command.overrides));
    }
    return ExitCode::done;
  } catch (const DifferentBits& error) {
    print_notice(error.what());
    return ExitCode::check_failed;
  }
}

}  // namespace rocking::program
