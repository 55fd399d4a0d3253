#pragma once

#include <cstdint>

namespace rocking::stats {

/// Closed interval.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Successes out of trials.
struct Proportion {
  std::uint64_t successes = 0;
  std::uint64_t trials = 0;
};

}  // namespace rocking::stats
