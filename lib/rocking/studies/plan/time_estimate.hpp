#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "rocking/base/stop_request.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/plan/needs.hpp"

namespace rocking {

/// Longest time that a sample for an estimate takes [s].
inline constexpr double longest_sample_s = 2.0;

/// Measured speed of a run, from a sample of its realisations.
struct TimeEstimate {
  double seconds = 0.0;            ///< that the run will take, by wall clock
  std::uint64_t realisations = 0;  ///< of the sample
  double horizon_share = 1.0;      ///< share of their periods that the sample ran; 1: all
  /// Realisations of the sample that were unresolved; absent if it had shorter horizons.
  std::optional<std::uint64_t> unresolved = std::nullopt;
};

/// What a measurement of speed takes from its caller.
struct Sampling {
  std::function<double()> elapsed_seconds;  ///< wall-clock time since some instant [s]; called by two threads
  base::StopRequest stop = {};
};

/// Runs a sample of the pairs of realisations, with reruns and label checks, on as many threads as the run will have,
/// for at most `longest_sample_s`, and extrapolates by the number of periods. The sample is spread evenly over the
/// conditions. If full horizons take too long, the sample has shorter ones. Absent if not even the shortest sample was
/// finished in that time, or if it is asked to stop. With `until` the estimate is that of the largest number of
/// realisations; with `until_classified` it is that of the fixed horizon.
[[nodiscard]] std::optional<TimeEstimate> estimate_time(const Experiment& experiment, const Means& means,
                                                        const Sampling& sampling);

}  // namespace rocking
