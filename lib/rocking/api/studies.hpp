#pragma once

#include <complex>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/export.hpp"
#include "rocking/api/run.hpp"
#include "rocking/output/write_orbits.hpp"
#include "rocking/output/write_trajectory.hpp"
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

/// Which periodic orbits are searched.
struct OrbitsRequest {
  int longest = 5;  ///< largest period, in excitation periods; at most 12
  /// Follow the orbits over the swept parameter, where the experiment sweeps one number on which the motion depends
  /// continuously.
  bool branches = false;
  std::optional<double> from = {};   ///< smallest value of the parameter for branches; absent: of the sweep
  std::optional<double> to = {};     ///< largest value
  std::uint64_t most_points = 1000;  ///< of a branch
  std::uint64_t most_branches = 50;
  /// JSON pointers of a second parameter, over which the folds, period doublings and losses of symmetry of the branches
  /// are followed too; the numbers at the others keep their ratio to the first. Empty: none.
  std::vector<std::string> second = {};
  std::optional<double> second_from = {};  ///< smallest value of it; needed with `second`, as the next one
  std::optional<double> second_to = {};    ///< largest value
  std::uint64_t most_curve_points = 400;   ///< of a curve in each direction
};

/// A periodic orbit, stable or not.
struct PeriodicOrbit {
  int period = 0;                                 ///< n: excitation periods until it repeats
  int cycles = 0;                                 ///< m: pairs of impacts in them
  std::vector<section::StrobePoint> points;       ///< at the n instants of the section
  std::vector<std::complex<double>> multipliers;  ///< by falling modulus
  std::string kind;                               ///< `node`, `focus`, `saddle`, ... (lib/docs/formats.md)
  bool is_stable = false;
  double residual = 0.0;  ///< of the map over n periods
};

/// Periodic orbits of each condition, without branches. Throws base::InputError if a condition is random or not harmonic,
/// and base::Stopped if it is asked to stop. Uses `threads`, `on_progress` and `stop` of the execution; progress counts
/// conditions.
[[nodiscard]] ROCKING_API std::vector<std::vector<PeriodicOrbit>> periodic_orbits(const Experiment& experiment,
                                                                                  int longest = 5,
                                                                                  const Execution& execution = {});

/// What a search for periodic orbits has found.
struct OrbitStudy {
  int longest = 0;                                       ///< largest period searched from the grid
  std::vector<OrbitsOfCondition> conditions;             ///< of the experiment
  std::optional<FoundBranches> branches = std::nullopt;  ///< and their bifurcations, if asked for
  std::optional<FoundCurves> curves = std::nullopt;      ///< of bifurcations over two parameters, if asked for
};

/// Periodic orbits, their branches and the curves of their bifurcations as values. Throws as periodic_orbits, and
/// base::InputError if branches or curves are asked for and nothing can be followed.
[[nodiscard]] ROCKING_API OrbitStudy orbit_study(const Experiment& experiment, const OrbitsRequest& request = {},
                                                 const Execution& execution = {});

/// The study as JSON text (`rocking.orbits/1`), the same bytes as `orbits.json` of the program.
[[nodiscard]] ROCKING_API std::string orbits_text(const Experiment& experiment, const OrbitStudy& study);

/// The study as the program prints it: orbits, branches, bifurcations, curves, and which response modes an orbit backs.
[[nodiscard]] ROCKING_API std::string orbits_table(const Experiment& experiment, const OrbitStudy& study);

/// Periodic orbits, and their branches if asked for, as JSON text (`rocking.orbits/1`). Throws as periodic_orbits, and
/// base::InputError if branches are asked for and nothing can be followed.
[[nodiscard]] ROCKING_API std::string orbits(const Experiment& experiment, const OrbitsRequest& request,
                                             const Execution& execution = {});
[[nodiscard]] ROCKING_API std::string orbits(const Experiment& experiment, int longest,
                                             const Execution& execution = {});

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
