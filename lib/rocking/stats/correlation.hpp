#pragma once

#include <cstddef>
#include <span>

#include "rocking/stats/moments.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {

/// Correlation of draws that should be independent: the mean of the products of their scores under the given law.
///
/// Since the law is given, not estimated, its mean is 0 and its standard error 1/sqrt(products), exactly; z tends to
/// a normal law as their number grows.

/// Of each number with the one `lag` places later; lag >= 1. Needs more than `lag` numbers.
[[nodiscard]] Moment lag_correlation(std::span<const double> sample, const NormalLaw& law, std::size_t lag);

/// Within the pairs (0, 1), (2, 3), ... that one Box-Muller block makes. A last number without a partner is left
/// out. Needs two.
[[nodiscard]] Moment pair_correlation(std::span<const double> sample, const NormalLaw& law);

}  // namespace rocking::stats
