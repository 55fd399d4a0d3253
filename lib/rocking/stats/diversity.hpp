#pragma once

#include <cstdint>
#include <span>

namespace rocking::stats {

/// Measures of the diversity of classified outcomes. `counts` holds the number of outcomes of each class; classes with
/// count 0 have no effect.

/// Probability that two outcomes differ in class, estimated without bias from n of them.
///
///     1 - sum k (k - 1)/(n (n - 1))
///
/// Needs 2 <= n < 2^32. Integer arithmetic, exact except for one division.
/// Source: Simpson (1949), Nature 163, 688.
[[nodiscard]] double probability_of_difference(std::span<const std::uint64_t> counts);

/// Shannon's entropy of the observed fractions, sum (k/n) ln(n/k) [nat]; needs n >= 1.
///
/// Plug-in estimate. Its bias, -(classes - 1)/(2n) to first order (Miller 1955), is not corrected.
[[nodiscard]] double entropy(std::span<const std::uint64_t> counts);

}  // namespace rocking::stats
