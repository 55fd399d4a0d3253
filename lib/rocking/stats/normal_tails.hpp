#pragma once

#include <array>
#include <span>

#include "rocking/stats/interval.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {

/// Number of values of a sample farther from the mean than `sigmas` standard deviations.
struct TailCount {
  double sigmas = 0.0;
  Proportion beyond;      ///< abs(x - mean) > sigmas sigma, out of all
  double expected = 0.0;  ///< n erfc(sigmas/sqrt 2)
  double p_value = 1.0;   ///< exact, two-sided
};

/// Counts beyond 3, 4 and 5 sigma. Faults of samplers appear there first, and tests of the whole law are least
/// sensitive there.
[[nodiscard]] std::array<TailCount, 3> normal_tails(std::span<const double> sample, const NormalLaw& law);

}  // namespace rocking::stats
