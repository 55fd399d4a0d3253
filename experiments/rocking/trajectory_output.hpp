#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "output.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/store/summary.hpp"

namespace rocking::program {

/// How a trajectory is printed.
struct TrajectoryOutput {
  std::string format = "json";       ///< or `csv`
  std::string units = "normalised";  ///< or `si`
};

/// Adds `--format` and `--units`.
void add_trajectory_output(CLI::App& command, TrajectoryOutput& output);

/// Throws UsageError if `--json` contradicts the format.
void expect_consistent(const TrajectoryOutput& output, const Loudness& loudness);

[[nodiscard]] std::string text_of(const RealisationKey& key, const Trajectory& trajectory,
                                  const TrajectoryOutput& output);

}  // namespace rocking::program
