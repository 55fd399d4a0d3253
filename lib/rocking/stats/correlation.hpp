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

/// The same of (score^2 - 1)/sqrt(2), whose mean is 0 and whose variance is 1 as well. The two members of a pair share
/// their radius: they are independent only if its law is right, which shows here.
///
/// z tends to a normal law slowly: of 20000 numbers, a z above 4.9 is 2.4 times as frequent as its normal p-value says.
[[nodiscard]] Moment pair_correlation_of_squares(std::span<const double> sample, const NormalLaw& law);

/// Of the numbers of two samples at equal places. Both of equal length, not empty.
[[nodiscard]] Moment cross_correlation(std::span<const double> sample, std::span<const double> other,
                                       const NormalLaw& law);

}  // namespace rocking::stats
