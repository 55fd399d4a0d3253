#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/record.hpp"
#include "rocking/experiment/run.hpp"
#include "rocking/experiment/summary.hpp"

namespace rocking::experiment {

/// Excitation periods from the start over which the error of a motion is measured: later, where motions part
/// exponentially, a difference says nothing of the steps that made it.
inline constexpr std::int64_t cost_error_periods = 10;

/// What to measure.
struct CostPlan {
  std::vector<double> tolerances;  ///< falling, at least three; the last is the reference
  std::uint64_t sample = 0;        ///< realisations at most
  /// Whether there are enough, those under way counted in; asked on all threads, often. Empty: `sample` of them are.
  std::function<bool()> is_enough = {};
};

/// One realisation at one tolerance.
struct ToleranceRun {
  section::ResponseMode mode;
  std::uint64_t periods = 0;  ///< of the excitation that it reached
  std::uint64_t steps = 0;
  std::optional<double> error;  ///< see error_beside; of the reference absent
  bool parted = false;          ///< from the reference, before the horizon; see parting_period
};

/// One realisation at all tolerances, with the same draws.
struct MeasuredRealisation {
  RealisationKey key;
  std::vector<ToleranceRun> runs;  ///< in the order of the tolerances
};

/// Largest difference in Theta, Theta' and V at the ends of the first `cost_error_periods` periods, as far as both runs
/// came. Absent where they have no period in common, and where the reference did not move: no error is to be had there.
[[nodiscard]] std::optional<double> error_beside(const Record& record, const Record& reference);

/// Runs the first realisations of `CostSample`, each at all tolerances, until there are as many as planned, or enough; at least
/// one. What is returned is a function of the experiment, the tolerances and how many there are: threads have no say. Empty if
/// it is asked to stop.
[[nodiscard]] std::vector<MeasuredRealisation> measure_cost(const Experiment& experiment, const CostPlan& plan,
                                                            const RunOptions& options);

}  // namespace rocking::experiment
