#pragma once

#include <algorithm>

namespace rocking::stats {

/// Bisection between a number `in` an interval and a number `out` of it, both in [0, 1], until their distance is 2^-40
/// of the larger one. Returns the outer number, so that the interval is never too small.
template <class Predicate>
[[nodiscard]] double outer_end(double in, double out, Predicate contains) {
  while (std::max(in, out) - std::min(in, out) > 0x1p-40 * std::max(in, out)) {
    const double middle = 0.5 * (in + out);
    (contains(middle) ? in : out) = middle;
  }
  return out;
}

/// Used instead of 0 and 1 where a function must be finite.
inline constexpr double nearly_zero = 0x1p-100;
inline constexpr double nearly_one = 1.0 - 0x1p-53;

}  // namespace rocking::stats
