#pragma once

#include <cstdint>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Sums over independent clusters, each of which has the same number of trials. Within a cluster the trials may depend
/// on each other in any way.
struct ClusteredProportion {
  std::uint64_t clusters = 0;
  std::uint64_t trials_each = 1;  ///< at least 1
  double successes = 0.0;         ///< a whole number
  double squares = 0.0;           ///< sum of the squares of the successes of each cluster

  void add(std::uint64_t its_successes) {
    const auto count = static_cast<double>(its_successes);
    ++clusters;
    successes += count;
    squares += count * count;
  }
  /// The mean share of successes; 0 without clusters.
  [[nodiscard]] double share() const;
};

/// Confidence interval for the expected share of successes of a cluster: Clopper-Pearson's with an effective number of
/// trials.
///
///     n* = p (1 - p)/v [z/t(n - 1)]^2,   v: variance of the mean of the n clusters' shares,   n <= n* <= n trials_each
///
/// z and t(n - 1) are two-sided quantiles of the normal law and of Student's. Below n it is n, because no law of a share
/// has a larger variance than that of whole clusters; so it is if all clusters are equal, where v says nothing. Its
/// coverage is measured, not proven (reports/evidence/intervals.md). Without clusters [0, 1].
/// Source: Korn & Graubard (1998), Surv. Methodol. 24, 193-201.
[[nodiscard]] Interval korn_graubard(const ClusteredProportion& proportion, double confidence);

/// Of the expected share of a cluster where those of all clusters are `share`: nothing is known of their scatter, and
/// each counts as one trial. [0, 0.308] for 0 of 10 at 95 %.
[[nodiscard]] Interval interval_of_equal_shares(double share, std::uint64_t clusters, double confidence);

/// What a count of successes may be where the outcome of some trials is not known.
struct CountBounds {
  Proportion least;  ///< none of them is a success
  Proportion most;   ///< all of them are
};

/// The bounds of `counted`, among whose failures `unresolved` may be successes.
[[nodiscard]] inline CountBounds bounds_of(const Proportion& counted, std::uint64_t unresolved) {
  return {.least = counted, .most = {.successes = counted.successes + unresolved, .trials = counted.trials}};
}

/// Covers at least as often as the intervals of `interval_of`, whatever the outcomes are that are not known: its lower
/// end is that of the least count, the upper end that of the largest.
template <class Method>
[[nodiscard]] Interval covering(const CountBounds& bounds, Method&& interval_of) {
  const Interval least = interval_of(bounds.least);
  if (bounds.most.successes == bounds.least.successes) return least;
  return {.low = least.low, .high = interval_of(bounds.most).high};
}

}  // namespace rocking::stats
