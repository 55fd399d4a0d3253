#pragma once

#include <functional>
#include <span>

#include "rocking/scene/experiment.hpp"
#include "rocking/studies/cost/question.hpp"

/// From measured realisations to the cost of accuracy, its forecast and the recommended tolerance.
namespace rocking {

struct MeasuredRealisation;
struct RunOptions;

/// Excitation periods from the start over which the error of a motion is measured. Later, motions diverge
/// exponentially, and a difference does not depend on the accuracy of the steps.
inline constexpr std::int64_t cost_error_periods = 10;

/// Largest share of flips relative to the half-width. As bias it reduces the coverage of a 95 % interval to 94.9 %.
inline constexpr double bearable_share = 0.05;
/// Largest median error: a hundredth of the distance at which two runs count as diverged.
inline constexpr double bearable_error = 1e-4;

/// A tighter tolerance is recommended if it takes at most this many times the steps.
inline constexpr double cheap_steps = 1.1;

/// One entry for each tolerance.
[[nodiscard]] std::vector<ToleranceCost> cost_curve(std::span<const double> tolerances,
                                                    std::span<const MeasuredRealisation> measured, double confidence);

/// Upper bound of the share of response modes that a tolerance changes: of all that flip or, if that is less, of the
/// excess over the flips at the floor. If the sample is the entire experiment, the share itself.
[[nodiscard]] double share_at_most(const Departure& departure, const Yardstick& yardstick);

/// A tolerance is shown to suffice if for it and for every tighter one the median error is at most `bearable_error` and
/// share_at_most is at most `bearable_share` of the half-width (0 if the sample is the entire experiment). If none is
/// shown to suffice, it is sufficient that for it and for every tighter one the median error is at most
/// `bearable_error`, no more modes flip than at the floor, and share_at_most is at most the half-width. Among the
/// coarsest sufficient tolerance and the tighter ones that pass and take at most `cheap_steps` times its steps, the
/// tightest is recommended.
///
/// `curve` is sorted by falling tolerance and has at least three entries; `confidence` is that of its intervals.
[[nodiscard]] Recommendation recommend(std::span<const ToleranceCost> curve, const Yardstick& yardstick,
                                       double confidence);

/// Clocks of a measurement.
struct TimingPlan {
  std::function<double()> processor_seconds;  ///< used by the calling thread so far [s]
  std::function<double()> seconds_left;       ///< wall-clock time left [s]; the first round may take longer
};

/// Measures rounds of realisations of `CostSample` on each thread, each round at all tolerances one after the other.
/// The first rounds have shortened horizons of a few periods, and as many realisations as fill the lanes, if a thread
/// of the run has as many. Rounds grow as long as there is time for some of the next size, first to full horizons. The
/// result is the median over the rounds of the last size. If it is asked to stop, the times are meaningless.
[[nodiscard]] CostTiming time_cost(const Experiment& experiment, std::span<const double> tolerances,
                                   const TimingPlan& plan, const RunOptions& options);

/// The tolerances of all conditions, each once: falling. Several if a sweep varies it.
[[nodiscard]] std::vector<double> own_tolerances(const Experiment& experiment);

/// Every decade from 1e-4 to 1e-14, and the experiment's own tolerances: falling.
[[nodiscard]] std::vector<double> tolerance_ladder(const Experiment& experiment);

/// `tolerances` are those of the measurements and include those of all conditions. All but the timing is a function
/// of the experiment, the tolerances and how many realisations are measured.
[[nodiscard]] Cost cost_of(const Experiment& experiment, std::span<const double> tolerances,
                           std::span<const MeasuredRealisation> measured, CostTiming timing);

}  // namespace rocking
