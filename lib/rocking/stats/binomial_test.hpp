#pragma once

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Exact two-sided p-value of a count, if each trial succeeds with `probability` in [0, 1]: the probability of all
/// counts that are no more probable than this one.
///
/// Counts whose probabilities differ by less than 1e-7 of themselves pass for equally probable, as in R's binom.test.
/// Cost: 2 log2(n) densities.
[[nodiscard]] double two_sided_binomial_p_value(const Proportion& observed, double probability);

}  // namespace rocking::stats
