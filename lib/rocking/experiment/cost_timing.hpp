#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/run.hpp"

namespace rocking::experiment {

/// What realisations cost while they are advanced side by side, as a run does it: naming included, without what a run keeps of
/// them, repeats and checks of labels.
struct CostTiming {
  std::vector<double> seconds_per_period;  ///< processor time, by tolerance [s]; 0 where no period was reached
  std::uint64_t realisations = 0;          ///< of a round, on each thread
  int periods = 0;                         ///< of the longest horizon of a round
};

/// How to take the time.
struct TimingPlan {
  std::function<double()> processor_seconds;  ///< that the calling thread has used so far [s]
  std::function<double()> seconds_left;  ///< by the clock, for all of it [s]; the first round takes longer if it must
};

/// Takes the time of rounds of realisations of `CostSample` on each thread, a round at all tolerances in turn. The first are of
/// a few periods, their horizons cut short, and of as many realisations as fill the lanes, if a thread of the run has as many.
/// As long as there is time for some larger ones, they grow, to full horizons first. Medians of those of the last size
/// count; a few are enough. If it is asked to stop, times are of no use.
[[nodiscard]] CostTiming time_cost(const Experiment& experiment, std::span<const double> tolerances,
                                   const TimingPlan& plan, const RunOptions& options);

}  // namespace rocking::experiment
