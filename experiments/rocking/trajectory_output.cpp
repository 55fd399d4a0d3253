#include "trajectory_output.hpp"

#include "exit_code.hpp"
#include "rocking/random/draws.hpp"
#include "usage.hpp"

namespace rocking::program {

void add_realisation(CLI::App& command, TrajectoryRequest& asked, Naming naming) {
  const auto add = [&](const char* name, std::uint64_t& number, const char* description, const char* type) {
    CLI::Option* option = command.add_option(name, number, description)
                              ->check(whole_number(0, random::realisation_limit - 1))
                              ->type_name(type);
    if (naming == Naming::required) {
      option->required();
    } else {
      option->capture_default_str();
    }
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

void expect_consistent(const TrajectoryOutput& output, const Loudness& loudness) {
  if (output.format == "csv" && loudness.json)
    throw UsageError("--json: the result is a table with `--format csv`; omit one of them");
}

std::string text_of(const TrajectoryRequest& asked, const Trajectory& trajectory, const TrajectoryOutput& output) {
  const TrajectoryUnits units = output.units == "si" ? TrajectoryUnits::si : TrajectoryUnits::normalised;
  return output.format == "csv" ? trajectory_csv(asked, trajectory, units) : trajectory_text(asked, trajectory, units);
}

}  // namespace rocking::program
