#pragma once

#include <cstddef>
#include <span>

#include "rocking/stats/normal_check.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {

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

}  // namespace rocking::stats
