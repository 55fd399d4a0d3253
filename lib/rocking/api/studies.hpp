#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/run.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/comparison.hpp"
#include "rocking/studies/cost/cost.hpp"
#include "rocking/studies/diagram.hpp"
#include "rocking/studies/motion/motion.hpp"
#include "rocking/studies/orbits/orbit_study.hpp"
#include "rocking/studies/rare/estimate.hpp"
#include "rocking/studies/run_fragility.hpp"

/// What is asked of an experiment beside its probabilities, and of ground motions. NAME(...) gives a struct,
/// NAME_text(...) the JSON text of it that the program writes.
namespace rocking {

/// One realisation of an experiment, and how long it is followed.
struct TrajectoryRequest {
  std::uint64_t condition = 0;                         ///< from 0
  std::uint64_t realisation = 0;                       ///< from 0
  std::optional<std::int64_t> periods = std::nullopt;  ///< excitation periods, at least 1; absent: all of the horizon
  int samples_per_period = 0;                          ///< of the history; 0: none
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

/// Probability of overturning as a function of the swept intensity, and what else is asked. Throws base::InputError if
/// the experiment sweeps no intensity, has no fixed number of realisations, or is not finished, or if a number is out
/// of range, and base::Stopped if it is asked to stop. Uses `threads`, `on_progress` and `stop` of the execution;
/// progress counts parts of about equal work.
[[nodiscard]] ROCKING_API RunFragility fragility(const Experiment& experiment, const RunResult& run,
                                                 const FragilityQuestion& question = {},
                                                 const Execution& execution = {});

/// The same as JSON text (`rocking.fragility/1`).
[[nodiscard]] ROCKING_API std::string fragility_text(const RunFragility& found);

/// Reads a hazard curve: a line with an intensity and its annual rate, or probability, of exceedance for each point; the
/// first line names both (lib/docs/formats.md). `reading`: what the file leaves open. Throws base::InputError with the
/// line of a fault, and std::system_error where the file cannot be read.
[[nodiscard]] ROCKING_API HazardCurve hazard_curve(const std::filesystem::path& file,
                                                   const HazardReading& reading = {});

/// The probabilities of a `rare.json` that belong to curves of a run of this experiment, for `FragilityQuestion::rare`:
/// those > 0 with the same block, motion, horizon and accuracy, at any intensity; of a suite the means over its records.
/// Throws base::InputError if there are none, if one probability is estimated twice, if estimates under some of the records
/// are missing, if the experiment has no text, or if the file is none, and std::system_error where it cannot be read.
[[nodiscard]] ROCKING_API std::vector<RareOfCurve> rare_levels(const std::filesystem::path& file,
                                                               const Experiment& experiment);

/// Reads magnitudes and distances of records, for `FragilityQuestion::metadata`: lines of `file`, `magnitude`,
/// `distance_km`, of which the first names the columns. Throws base::InputError with the place of each fault, and
/// std::system_error where the file cannot be read.
[[nodiscard]] ROCKING_API std::vector<RecordMetadata> record_metadata(const std::filesystem::path& file);

/// Compares two runs of the same seed, realisation by realisation with common random numbers: the settings that differ
/// and one entry for each condition, with the confidence of the first run's. Realisations that only one run has are
/// left out. Throws base::InputError if the seeds or the numbers of conditions differ.
[[nodiscard]] ROCKING_API Comparison compare(const StoredRun& first, const StoredRun& second);

/// The same as JSON text (`rocking.comparison/1`).
[[nodiscard]] ROCKING_API std::string compare_text(const Comparison& found);

/// Bifurcation diagrams of one realisation: for each combination of values of the sweep's entries after the first, the
/// responses along the first, from the initial state and from the end of the step before, upwards and downwards. Strobe
/// points are dimensionless. Throws base::InputError if there is no sweep, if its first entry takes values that are not
/// numbers, or if an excitation is not periodic, and base::Stopped if it is asked to stop. Uses `threads`,
/// `on_progress` and `stop` of the execution; progress counts steps.
[[nodiscard]] ROCKING_API std::vector<Diagram> bifurcation(const Experiment& experiment, std::uint64_t realisation = 0,
                                                           const Execution& execution = {});

/// The same as JSON text (`rocking.bifurcation/1`).
[[nodiscard]] ROCKING_API std::string bifurcation_text(const Experiment& experiment, std::uint64_t realisation,
                                                       const std::vector<Diagram>& found);

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

/// Whether an experiment sweeps one number of the motion, with several values, so that branches can be followed.
[[nodiscard]] ROCKING_API bool has_branches(const Experiment& experiment);

/// Throws base::InputError if a condition is random or not harmonic, if a number of the request is out of range, or if
/// branches or curves are asked for and nothing can be followed.
ROCKING_API void check_request(const Experiment& experiment, const OrbitsRequest& request);

/// Periodic orbits, their branches and the curves of their bifurcations. Throws as check_request, and base::Stopped if
/// it is asked to stop. Uses `threads`, `on_progress` and `stop` of the execution; progress counts conditions, then points
/// of branches and curves, of which `all` is 0: how many there will be is not known.
[[nodiscard]] ROCKING_API OrbitStudy orbits(const Experiment& experiment, const OrbitsRequest& request = {},
                                            const Execution& execution = {});

/// The study as JSON text (`rocking.orbits/1`), the same bytes as `orbits.json` of the program.
[[nodiscard]] ROCKING_API std::string orbits_text(const Experiment& experiment, const OrbitStudy& study);

/// The study as the program prints it: orbits, branches, bifurcations, curves, and which response modes an orbit backs.
[[nodiscard]] ROCKING_API std::string orbits_table(const OrbitStudy& study);

/// What is asked of each condition, and with how much work.
struct RareRequest {
  RareQuestion question = {};
  std::size_t particles = 1000;  ///< trajectories of a repetition; 20 to 100000
  /// Time for all conditions together [s], on the clock of `elapsed_seconds`, which several threads call. What is not
  /// finished then is left out. Absent: no limit, so that the same is estimated again.
  std::optional<double> seconds = {};
  std::function<double()> elapsed_seconds = {};
  /// Of an earlier study with the same experiment, event and particles, by condition: their repetitions are not made again.
  std::vector<RareEstimate> earlier = {};
  /// When it is asked to stop, it returns what is finished. Else it throws.
  bool keeps_when_stopped = false;
  /// Called by one thread at a time after each repetition; `so_far` gives what would be returned if it had been asked to
  /// stop after it.
  std::function<void(const std::function<std::vector<RareEstimate>()>& so_far)> keep = {};
};

/// Throws base::InputError if nothing in a condition is random or a number is out of range.
ROCKING_API void check_request(const Experiment& experiment, const RareRequest& request);

/// Estimates the probability of overturning, or of a large tilt, one entry for each condition, by a particle run that
/// the committor steers or by importance sampling. Uses `threads`, `on_progress` and `stop` of the execution; progress
/// counts simulated time in realisations to the horizon. Their number is estimated; it is 0, not known, up to the end of
/// the pilot runs of the first condition. Throws as check_request, and base::Stopped if it is asked to stop. Source:
/// lib/docs/rare.md.
[[nodiscard]] ROCKING_API std::vector<RareEstimate> rare_probabilities(const Experiment& experiment,
                                                                       const RareRequest& request,
                                                                       const Execution& execution = {});

/// The same as JSON text (`rocking.rare/1`).
[[nodiscard]] ROCKING_API std::string rare_probabilities_text(const Experiment& experiment, const RareRequest& request,
                                                              const std::vector<RareEstimate>& found);

/// How the cost of an experiment's accuracy is measured.
struct CostRequest {
  /// Clocks, which the library does not read itself; both are needed. The first is called by all threads.
  std::function<double()> elapsed_seconds;    ///< wall-clock time since some instant [s]
  std::function<double()> processor_seconds;  ///< processor time of the calling thread [s]
  /// Wall-clock time to spend [s]. With `sample`, for measuring the speed alone.
  double seconds = 60.0;
  /// Realisations to measure, from 1 to 100000: gives the same numbers again, except times. Absent: as many as the time
  /// allows.
  std::optional<std::uint64_t> sample = {};
  /// From 1e-16 to 1e-2; the experiment's own are added, and together they are at least three. Empty: 1e-4, 1e-5, ...,
  /// 1e-14.
  std::vector<double> tolerances = {};
};

/// Throws base::InputError for a number out of range or too few tolerances, std::invalid_argument without clocks.
ROCKING_API void check_request(const Experiment& experiment, const CostRequest& request);

/// Runs a sample of the realisations at several tolerances with common random numbers: error, changed response modes
/// and processor time by tolerance, half-widths and time by number of realisations, and a recommended tolerance. Uses
/// `threads`, `on_progress` and `stop` of the execution; progress counts realisations of the sample. Throws as
/// check_request, and base::Stopped if it is asked to stop.
[[nodiscard]] ROCKING_API Cost cost(const Experiment& experiment, const CostRequest& request,
                                    const Execution& execution = {});

/// A measured cost as JSON text (`rocking.cost/1`); all but `system` is the same for equal tolerances and samples.
[[nodiscard]] ROCKING_API std::string cost_text(const Experiment& experiment, const Cost& cost,
                                                const Provenance& provenance = {});

/// Files with recorded accelerations, and how to read them.
struct GroundMotionRequest {
  std::vector<std::string> files;
  std::optional<std::string> vertical = std::nullopt;  ///< file with the vertical component of a single file
  std::string format = "auto";                         ///< `auto`, `columns`, `peer_at2`, `esm_asc`
  std::optional<std::string> units = std::nullopt;     ///< as `excitation.units`; absent: that of the file, or m/s^2
  std::optional<double> time_step = std::nullopt;      ///< of columns without times [s], positive
  std::vector<std::string> columns = {};               ///< as `excitation.columns`; empty: not given
  bool series = false;           ///< the JSON text also has the motions sample by sample, which draw() needs
  MotionQuestion question = {};  ///< 1 g, damping, periods of the response spectrum, block
};

/// The ground motions with their intensity measures, in the order of the files. Throws base::InputError with the file,
/// line and value of each fault, also for an unknown format or unit, and std::system_error where a file cannot be read.
[[nodiscard]] ROCKING_API std::vector<MeasuredMotion> motion(const GroundMotionRequest& request);

/// The same as JSON text (`rocking.motion/1`).
[[nodiscard]] ROCKING_API std::string motion_text(const GroundMotionRequest& request,
                                                  const std::vector<MeasuredMotion>& found);

}  // namespace rocking
