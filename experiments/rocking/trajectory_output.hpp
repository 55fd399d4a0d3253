#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "output.hpp"
#include "rocking/api/trajectory.hpp"

namespace rocking::program {

/// How a trajectory is printed.
struct TrajectoryOutput {
  std::string format = "json";       ///< or `csv`
  std::string units = "normalised";  ///< or `si`
};

/// Whether a realisation must be named.
enum class Naming : std::uint8_t { required, optional };

/// Adds `--condition` and `--realisation`.
void add_realisation(CLI::App& command, TrajectoryRequest& asked, Naming naming);

/// Adds `--format` and `--units`.
void add_trajectory_output(CLI::App& command, TrajectoryOutput& output);

/// Throws UsageError if `--json` contradicts the format.
void expect_consistent(const TrajectoryOutput& output, const Loudness& loudness);

[[nodiscard]] std::string text_of(const TrajectoryRequest& asked, const Trajectory& trajectory,
                                  const TrajectoryOutput& output);

}  // namespace rocking::program
