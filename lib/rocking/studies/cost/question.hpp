#pragma once

#include "rocking/api/run.hpp"
#include "rocking/studies/cost/cost.hpp"

/// What accuracy costs in time.
namespace rocking {

/// How the cost of an experiment's accuracy is measured.
struct CostQuestion {
  /// Wall-clock time to spend [s]. With `sample`, for measuring the speed alone.
  double seconds = 60.0;
  /// Realisations to measure, from 1 to 100000: gives the same numbers again, except times. Absent: as many as the time
  /// allows.
  std::optional<std::uint64_t> sample = {};
  /// From 1e-16 to 1e-2; the experiment's own are added, and together they are at least three. Empty: 1e-4, 1e-5, ...,
  /// 1e-14.
  std::vector<double> tolerances = {};
};

/// Runs a sample of the realisations at several tolerances with common random numbers: error, changed response modes
/// and processor time by tolerance, half-widths and time by number of realisations, and a recommended tolerance. Uses
/// `threads`, `on_progress`, `stop` and both clocks of the execution; progress counts realisations of the sample. Throws
/// base::InputError for a number out of range or too few tolerances, std::invalid_argument without clocks, and
/// base::Stopped if it is asked to stop.
[[nodiscard]] ROCKING_API Cost cost(const Experiment& experiment, const CostQuestion& question,
                                    const Execution& execution);

}  // namespace rocking
