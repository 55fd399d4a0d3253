#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rocking/api/export.hpp"
#include "rocking/api/run.hpp"
#include "rocking/output/write_trajectory.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/comparison.hpp"
#include "rocking/studies/diagram.hpp"

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
/// experiment has no such condition or a number is out of range.
[[nodiscard]] ROCKING_API Trajectory trajectory(const Experiment& experiment, const TrajectoryRequest& request = {});

/// A trajectory as JSON text (`rocking.trajectory/1`), in normalised or SI units.
[[nodiscard]] ROCKING_API std::string trajectory_text(const TrajectoryRequest& request, const Trajectory& trajectory,
                                                      TrajectoryUnits units = TrajectoryUnits::normalised);

/// The same as a table (CSV).
[[nodiscard]] ROCKING_API std::string trajectory_csv(const TrajectoryRequest& request, const Trajectory& trajectory,
                                                     TrajectoryUnits units = TrajectoryUnits::normalised);

/// Periodic orbits of all conditions, as JSON text (`rocking.orbits/1`); `longest` is the largest period that is
/// searched, in excitation periods. Throws base::InputError if a condition is random or not harmonic, and base::Stopped
/// if it is asked to stop. Uses `threads`, `on_progress` and `stop` of the execution; progress counts conditions.
[[nodiscard]] ROCKING_API std::string orbits(const Experiment& experiment, int longest,
                                             const Execution& execution = {});

/// Probability of overturning as a function of the swept intensity, as JSON text (`rocking.fragility/1`). Throws
/// base::InputError if the experiment sweeps no intensity, has no fixed number of realisations, or is not finished.
[[nodiscard]] ROCKING_API std::string fragility(const Experiment& experiment, const RunResult& run);

/// Compares two runs of the same seed, realisation by realisation with common random numbers: one entry for each
/// condition, with the confidence of the first run's. Realisations that only one run has are left out. Throws
/// base::InputError if the seeds or the numbers of conditions differ.
[[nodiscard]] ROCKING_API std::vector<ConditionComparison> compare(const StoredRun& first, const StoredRun& second);

/// The same as JSON text (`rocking.comparison/1`), with the settings that differ.
[[nodiscard]] ROCKING_API std::string comparison(const StoredRun& first, const StoredRun& second);

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
