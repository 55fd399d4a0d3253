#pragma once

#include <cstddef>
#include <span>

#include "rocking/stats/interval.hpp"
#include "rocking/stats/normal_check.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {

/// The skewness g1 of n normal numbers, transformed to a standard normal number. Odd; needs n >= 8.
///
/// Source: D'Agostino (1970), Biometrika 57, 679-681.
[[nodiscard]] double skewness_score(double skewness, std::size_t n);

/// Kurtosis b2 of n normal numbers, transformed to a standard normal number. Needs n >= 20.
///
/// Source: Anscombe & Glynn (1983), Biometrika 70, 227-234.
[[nodiscard]] double kurtosis_score(double kurtosis, std::size_t n);

/// Test for a normal law with any mean and sigma: K^2 = Z(g1)^2 + Z(b2)^2, compared with chi-squared of 2 degrees. The
/// transformed moments are close to normal also for small n.
///
/// Needs n >= 20 (recommended; at least 8), not all equal.
/// Source: D'Agostino & Pearson (1973), Biometrika 60, 613-622.
[[nodiscard]] TestOfFit dagostino_pearson(std::span<const double> sample);

/// This very law? Anderson & Darling's A^2, which weighs both tails up. Needs n >= 1.
///
/// Source: Anderson & Darling (1954), J. Am. Stat. Assoc. 49, 765-769; Marsaglia & Marsaglia (2004), J. Stat. Softw.
/// 9(2); Smirnov (1937), Mat. Sbornik 2, 973-993, for the far tail.
[[nodiscard]] TestOfFit anderson_darling(std::span<const double> sample, const NormalLaw& law);

/// Probability that the A^2 of n independent numbers, from whatever continuous law they are compared with, is at
/// least `statistic`.
///
/// Absolute error about 1e-3/n for n of ten or more, and 2e-6 where the statistic is below 2. No smaller than 6e-4/n
/// for statistics however large.
[[nodiscard]] double anderson_darling_p_value(double statistic, std::size_t n);

/// This very law? The largest distance D between the empirical and the law's distribution function. Needs n >= 1.
[[nodiscard]] TestOfFit kolmogorov_smirnov(std::span<const double> sample, const NormalLaw& law);

/// Probability that the D of n independent numbers, from whatever continuous law they are compared with, is at least
/// `distance`.
///
/// Kolmogorov's limit law at x + 1/(6 sqrt n) + (x - 1)/(4n), x = sqrt(n) D. Absolute error below 0.03/n for n >= 20
/// (1.1e-6 at n = 20000), as found by comparison with the exact law.
/// Source: Vrbik (2018), Pioneer J. Theor. Appl. Stat. 15, 15-23.
[[nodiscard]] double kolmogorov_p_value(double distance, std::size_t n);

/// The same two probabilities where mean and sigma of the law are those of the numbers, sigma with n - 1. Approximations,
/// good to about 0.01 and, of small probabilities, to a tenth. Need n >= 20.
///
/// Source: D'Agostino & Stephens (1986), Goodness-of-Fit Techniques, table 4.9; Dallal & Wilkinson (1986), Am. Stat. 40,
/// 294-296, and above 0.1 Stephens (1974), J. Am. Stat. Assoc. 69, 730-737, as fitted in R's nortest.
[[nodiscard]] double anderson_darling_p_value_of_own_law(double statistic, std::size_t n);
[[nodiscard]] double lilliefors_p_value(double distance, std::size_t n);

/// Exact two-sided p-value of a count if each trial succeeds with `probability` in [0, 1]: the probability of all
/// counts that are at most as probable as the observed one.
///
/// Counts whose probabilities differ by a relative amount below 1e-7 are treated as equally probable, as in binom.test
/// of R. Cost: 2 log2(n) densities.
[[nodiscard]] double two_sided_binomial_p_value(const Proportion& observed, double probability);

}  // namespace rocking::stats
