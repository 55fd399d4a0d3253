#pragma once

#include <cstddef>
#include <span>

#include "rocking/stats/normal_check.hpp"

namespace rocking::stats {

/// The skewness g1 of n normal numbers, transformed to a standard normal number. Odd; needs n >= 8.
///
/// Source: D'Agostino (1970), Biometrika 57, 679-681.
[[nodiscard]] double skewness_score(double skewness, std::size_t n);

/// Kurtosis b2 of n normal numbers, transformed to a standard normal number. Needs n >= 20.
///
/// Source: Anscombe & Glynn (1983), Biometrika 70, 227-234.
[[nodiscard]] double kurtosis_score(double kurtosis, std::size_t n);

/// Test for a normal law with any mean and sigma: n/6 (g1^2 + (b2 - 3)^2/4), compared with chi-squared of 2 degrees.
///
/// Needs n >= 4, not all equal. The p-value is that of the limit n = infinity, which is approached slowly: the error is
/// 0.003 at n = 20000 and 0.016 at 1000, and small p-values are wrong by factors (table in
/// reports/evidence/intervals.md). Source: Jarque & Bera (1987), Int. Stat. Rev. 55, 163-172.
[[nodiscard]] TestOfFit jarque_bera(std::span<const double> sample);

/// Test for a normal law with any mean and sigma: K^2 = Z(g1)^2 + Z(b2)^2, compared with chi-squared of 2 degrees. The
/// transformed moments are close to normal also for small n.
///
/// Needs n >= 20 (recommended; at least 8), not all equal.
/// Source: D'Agostino & Pearson (1973), Biometrika 60, 613-622.
[[nodiscard]] TestOfFit dagostino_pearson(std::span<const double> sample);

}  // namespace rocking::stats
