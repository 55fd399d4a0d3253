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
  std::uint64_t realisations = 0;          ///< side by side and one after another, on each thread at a time
  int periods = 0;                         ///< that each of them was given
};

/// How to take the time.
struct TimingPlan {
  std::function<double()> processor_seconds;  ///< that the calling thread has used so far [s]
  std::function<double()> seconds_left;  ///< by the clock, for all of it [s]; the first round takes longer if it must
};

/// Takes the time of rounds of realisations of `CostSample` on each thread, a round at all tolerances in turn. There are as
/// many in a round as fill the lanes for most of it, if a thread of the run has as many; in the first their horizons are cut to
/// a few periods, and while there is time for it, the next has twice as many. The last rounds of a length count. If it is
/// asked to stop before one is over, all times are 0.
[[nodiscard]] CostTiming time_cost(const Experiment& experiment, std::span<const double> tolerances,
                                   const TimingPlan& plan, const RunOptions& options);

}  // namespace rocking::experiment
