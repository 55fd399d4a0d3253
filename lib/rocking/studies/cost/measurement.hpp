#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "rocking/ensemble/run.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Plan of a measurement.
struct CostPlan {
  std::vector<double> tolerances;  ///< falling, at least three; the last is the reference
  std::uint64_t sample = 0;        ///< realisations at most
  /// Whether there are enough, including those in progress; called often and on all threads. Empty: `sample` are
  /// enough.
  std::function<bool()> is_enough = {};
};

/// One realisation at one tolerance.
struct ToleranceRun {
  section::ResponseMode mode;
  std::uint64_t periods = 0;  ///< of the excitation that it reached
  std::uint64_t steps = 0;
  std::optional<double> error;  ///< see error_beside; absent for the reference
  bool diverged = false;        ///< from the reference, before the horizon; see divergence_period
};

/// One realisation at all tolerances, with common random numbers.
struct MeasuredRealisation {
  RealisationKey key;
  std::vector<ToleranceRun> runs;  ///< in the order of the tolerances
};

/// Largest difference in Theta, Theta' and V at the ends of the first `cost_error_periods` periods that both runs
/// reached. Absent if they have no period in common, or if the reference did not move.
[[nodiscard]] std::optional<double> error_beside(const RealisationResult& result, const RealisationResult& reference);

/// Runs the first realisations of `CostSample`, each at all tolerances, until there are as many as planned, or enough;
/// at least one. The result depends on the experiment, the tolerances and the number of realisations, not on the
/// threads. Empty if it is asked to stop.
[[nodiscard]] std::vector<MeasuredRealisation> measure_cost(const Experiment& experiment, const CostPlan& plan,
                                                            const RunOptions& options);

}  // namespace rocking
