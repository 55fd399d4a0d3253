#pragma once

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Exact two-sided p-value of a count if each trial succeeds with `probability` in [0, 1]: the probability of all
/// counts that are at most as probable as the observed one.
///
/// Counts whose probabilities differ by a relative amount below 1e-7 are treated as equally probable, as in binom.test
/// of R. Cost: 2 log2(n) densities.
[[nodiscard]] double two_sided_binomial_p_value(const Proportion& observed, double probability);

}  // namespace rocking::stats
