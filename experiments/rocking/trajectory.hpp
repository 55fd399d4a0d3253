#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "exit_code.hpp"
#include "output.hpp"
#include "rocking/api/trajectory.hpp"
#include "rocking/input/read_experiment.hpp"

namespace rocking::program {

/// How a trajectory is printed.
struct TrajectoryOutput {
  std::string format = "json";       ///< or `csv`
  std::string units = "normalised";  ///< or `si`
};

struct TrajectoryCommand {
  std::string experiment;  ///< file, or folder of a finished run
  TrajectoryRequest trajectory;
  std::string page;  ///< file; empty: none
  Overrides overrides;
  TrajectoryOutput output;
  Loudness loudness;
};

/// Adds `--condition` and `--realisation`.
void add_realisation(CLI::App& command, TrajectoryRequest& asked);

/// Adds `--format` and `--units`.
void add_trajectory_output(CLI::App& command, TrajectoryOutput& output);

/// Prints one realisation, or writes its page. Of a run it is checked against its digest.
[[nodiscard]] ExitCode print_trajectory(const TrajectoryCommand& command);

}  // namespace rocking::program
