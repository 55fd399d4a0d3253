#pragma once

#include <cstddef>
#include <span>

#include "rocking/stats/moments.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {

/// Correlation of draws that should be independent: the mean of the products of their scores under the given law.
///
/// The law is given, not estimated. Therefore the mean of the statistic is 0 and its standard error is exactly
/// 1/sqrt(products); z tends to a normal law as the number of products grows.

/// Correlation of each number with the number `lag` places later; lag >= 1. Needs more than `lag` numbers.
[[nodiscard]] Moment lag_correlation(std::span<const double> sample, const NormalLaw& law, std::size_t lag);

/// Correlation within the pairs (0, 1), (2, 3), ..., each of which is computed from one Box-Muller block. A last number
/// without a partner is omitted. Needs two numbers.
[[nodiscard]] Moment pair_correlation(std::span<const double> sample, const NormalLaw& law);

/// As pair_correlation, for (score^2 - 1)/sqrt(2), whose mean is 0 and whose variance is 1. The two members of a pair
/// have the same radius. They are independent only if the law of the radius is right; this test can detect that it is
/// not.
///
/// z tends to a normal law slowly: for 20000 numbers, z > 4.9 is 2.4 times as frequent as its normal p-value says.
[[nodiscard]] Moment pair_correlation_of_squares(std::span<const double> sample, const NormalLaw& law);

/// Correlation of the numbers of two samples at equal places. Both samples have the same length >= 1.
[[nodiscard]] Moment cross_correlation(std::span<const double> sample, std::span<const double> other,
                                       const NormalLaw& law);

}  // namespace rocking::stats
