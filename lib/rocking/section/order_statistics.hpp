#pragma once

#include <cstddef>
#include <limits>
#include <span>

namespace rocking::section {

/// Memory for as many numbers as there are values.
using Scratch = std::span<double>;

inline constexpr double no_guess = std::numeric_limits<double>::quiet_NaN();

/// The value that is at index `rank` after sorting; `rank` < number of values. O(N) on average. `guess` is a value that
/// it may be near.
///
/// The same value as of std::nth_element, also if values are NaN, without unpredictable branches: values are compared
/// with pivots, found by interpolation, in a loop that has none, and few values are ranked by comparing all pairs.
[[nodiscard]] double value_of_rank(std::span<const double> values, std::size_t rank, Scratch scratch,
                                   double guess = no_guess);

/// The median; the mean of the two middle values if their number is even; 0 of no values.
[[nodiscard]] double median_of(std::span<const double> values, Scratch scratch);

}  // namespace rocking::section
