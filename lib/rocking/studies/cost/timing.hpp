#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "rocking/scene/experiment.hpp"

namespace rocking {

struct RunOptions;

/// Processor time of realisations that run together in lanes, as in a run: with classification, without storage, reruns
/// and checks of labels.
struct CostTiming {
  std::vector<double> seconds_per_period;  ///< processor time, by tolerance [s]; 0 where no period was reached
  std::uint64_t realisations = 0;          ///< per round and thread
  int periods = 0;                         ///< of the longest horizon of a round
};

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

}  // namespace rocking
