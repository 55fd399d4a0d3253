#pragma once

#include <array>
#include <span>

#include "rocking/stats/interval.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {

/// How many of a sample lie farther from the mean than so many sigmas.
struct TailCount {
  double sigmas = 0.0;
  Proportion beyond;       ///< abs(x - mean) > sigmas sigma, out of all
  double expected = 0.0;   ///< n erfc(sigmas/sqrt 2)
  double p_value = 1.0;    ///< exact, two-sided
};

/// Beyond 3, 4 and 5 sigma: where samplers go wrong first, and where tests of the whole law look least.
[[nodiscard]] std::array<TailCount, 3> normal_tails(std::span<const double> sample, const NormalLaw& law);

}  // namespace rocking::stats
