#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/export.hpp"
#include "rocking/api/run.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/comparison.hpp"
#include "rocking/studies/diagram.hpp"
#include "rocking/studies/run_fragility.hpp"

/// What is asked of an experiment beside its probabilities. One realisation is looked at with `trajectory_of`.
namespace rocking {

/// One realisation of an experiment, and how long it is followed.
struct TrajectoryRequest {
  std::uint64_t condition = 0;    ///< from 0
  std::uint64_t realisation = 0;  ///< from 0
  std::int64_t periods = 0;       ///< excitation periods; 0: all of the horizon
  int samples_per_period = 0;     ///< of the history; 0: none
};

/// The trajectory of one realisation: strobe points, events, history, peaks, energy. Throws base::InputError if the
/// experiment has no such condition or a number is out of range, and base::Stopped if the `stop` of the execution, the
/// only field that is used, asks for it.
[[nodiscard]] ROCKING_API Trajectory trajectory(const Experiment& experiment, const TrajectoryRequest& request = {},
                                                const Execution& execution = {});

/// A trajectory as JSON text (`rocking.trajectory/1`), in normalised or SI units.
[[nodiscard]] ROCKING_API std::string trajectory_text(const TrajectoryRequest& request, const Trajectory& trajectory,
                                                      TrajectoryUnits units = TrajectoryUnits::normalised);

/// The same as a table (CSV).
[[nodiscard]] ROCKING_API std::string trajectory_csv(const TrajectoryRequest& request, const Trajectory& trajectory,
                                                     TrajectoryUnits units = TrajectoryUnits::normalised);

/// Probability of overturning as a function of the swept intensity, and what else is asked. Throws base::InputError if the
/// experiment sweeps no intensity, has no fixed number of realisations, or is not finished, or if a number is out of range,
/// and base::Stopped if it is asked to stop. Uses `threads`, `on_progress` and `stop` of the execution; progress counts
/// parts of about equal work.
[[nodiscard]] ROCKING_API RunFragility fragility_curves(const Experiment& experiment, const RunResult& run,
                                                        const FragilityQuestion& question = {},
                                                        const Execution& execution = {});

/// The same as JSON text (`rocking.fragility/1`).
[[nodiscard]] ROCKING_API std::string fragility(const Experiment& experiment, const RunResult& run,
                                                const FragilityQuestion& question = {},
                                                const Execution& execution = {});

/// Reads a hazard curve: a line `intensity, annual rate of exceedance` for each point. Throws base::InputError with the
/// line of a fault, and std::system_error where the file cannot be read.
[[nodiscard]] ROCKING_API HazardCurve hazard_curve(const std::filesystem::path& file);

/// Compares two runs of the same seed, realisation by realisation with common random numbers: the settings that differ
/// and one entry for each condition, with the confidence of the first run's. Realisations that only one run has are left
/// out. Throws base::InputError if the seeds or the numbers of conditions differ.
[[nodiscard]] ROCKING_API Comparison compare(const StoredRun& first, const StoredRun& second);

/// The same as JSON text (`rocking.comparison/1`).
[[nodiscard]] ROCKING_API std::string comparison_text(const Comparison& found);

/// Bifurcation diagrams of one realisation: for each combination of values of the sweep's entries after the first, the
/// responses along the first, from the initial state and from the end of the step before, upwards and downwards. Strobe
/// points are dimensionless. Throws base::InputError if there is no sweep, if its first entry takes values that are not
/// numbers, or if an excitation is not periodic, and base::Stopped if it is asked to stop. Uses `threads`,
/// `on_progress` and `stop` of the execution; progress counts steps.
[[nodiscard]] ROCKING_API std::vector<Diagram> diagrams(const Experiment& experiment, std::uint64_t realisation = 0,
                                                        const Execution& execution = {});

/// The same as JSON text (`rocking.bifurcation/1`).
[[nodiscard]] ROCKING_API std::string bifurcation(const Experiment& experiment, std::uint64_t realisation = 0,
                                                  const Execution& execution = {});

}  // namespace rocking
