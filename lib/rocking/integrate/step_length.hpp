#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rocking::integrate {

/// Root of y of the given degree to a few per cent, from the bits of y: a double's bits, read as an integer, are its
/// logarithm, linear between powers of two. The error of log2(y) is at most 0.0861 and is divided by the degree; that of
/// the way back is at most 0.0861, or 6 %. IEEE and integer operations only, so the bits are the same everywhere.
[[nodiscard]] inline double rough_root(double y, int degree) {
  constexpr std::int64_t one = 1023LL << 52;
  const auto bits = std::bit_cast<std::int64_t>(y);
  return std::bit_cast<double>((bits - one) / degree + one);
}

/// Length h at which the larger of two successive last terms, last_but_one h^(order - 1) and last h^order, has grown to
/// `largest`. Two terms, since every second coefficient may vanish (a sine about its zero). Infinite if both do.
[[nodiscard]] inline double step_length(double last_but_one, double last, int order, double largest) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto reach = [largest](double term, int degree) {
    const double ratio = largest / std::abs(term);
    return ratio < 0x1p1000 ? rough_root(ratio, degree) : infinite;
  };
  const double a = reach(last_but_one, order - 1);
  const double b = reach(last, order);
  return a < b ? a : b;
}

}  // namespace rocking::integrate
