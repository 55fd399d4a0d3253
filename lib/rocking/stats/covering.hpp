#pragma once

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

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
