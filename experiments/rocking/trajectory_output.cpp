#include "trajectory_output.hpp"

#include "exit_code.hpp"
#include "rocking/output/trajectory_report.hpp"
#include "usage.hpp"

namespace rocking::program {

void add_trajectory_output(CLI::App& command, TrajectoryOutput& output) {
  command.add_option("--format", output.format, "Text to print")
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

std::string text_of(const RealisationKey& key, const Trajectory& trajectory, const TrajectoryOutput& output) {
  const TrajectoryUnits units = output.units == "si" ? TrajectoryUnits::si : TrajectoryUnits::normalised;
  const TrajectoryReport report = trajectory_report(key, trajectory, units);
  return output.format == "csv" ? trajectory_table(report) : trajectory_document().text(report);
}

}  // namespace rocking::program
