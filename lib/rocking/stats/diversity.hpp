#pragma once

#include <cstdint>
#include <span>

namespace rocking::stats {

/// How far a set of classified outcomes is from being all alike. `counts` holds the outcomes of each class; classes
/// with none change nothing.

/// Probability that two outcomes differ in class, estimated without bias from n of them.
///
///     1 - sum k (k - 1)/(n (n - 1))
///
/// Needs 2 <= n < 2^32. Exact but for one division.
/// Source: Simpson (1949), Nature 163, 688.
[[nodiscard]] double probability_of_difference(std::span<const std::uint64_t> counts);

/// Shannon's entropy of the observed fractions, sum (k/n) ln(n/k) [nat]; needs n >= 1.
///
/// The plug-in estimate: too low on the average, by (classes - 1)/(2n) to first order (Miller 1955), uncorrected.
[[nodiscard]] double entropy(std::span<const std::uint64_t> counts);

}  // namespace rocking::stats
