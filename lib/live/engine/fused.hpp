#pragma once

#include <cstdint>

#include "rocking/base/lane.hpp"

namespace rocking::live {

/// a b + c, rounded once, for processors without such an instruction.
///
/// Boldo & Melquiond (2008), IEEE Trans. Comput. 57(4) 462-471, algorithm Fmac: the product and the sums without error (Dekker,
/// Knuth), the last but one rounded to odd. Proven there without underflow and overflow. `slow` is called where a number
/// that is neither 0 nor within 2^-900 and 2^900 could lead to either; it must give the same.
template <class Slow>
[[nodiscard]] inline double fused_in_software(double a, double b, double c, Slow slow) {
  using base::bits_of;
  constexpr std::uint64_t least = 1023 - 900;
  constexpr std::uint64_t range = 1800;
  const auto exponent = [](double x) { return bits_of(x) >> 52U & 0x7ffU; };
  const std::uint64_t of_a = exponent(a), of_b = exponent(b), of_c = exponent(c);
  if (of_a - least > range || of_b - least > range || of_c - least > range || of_a + of_b - (1023 + least) > range) {
    // A product with a 0, or of numbers that are not finite, needs no rounding.
    if (a == 0.0 || b == 0.0) return a * b + c;
    const bool is_moderate = of_a - least <= range && of_b - least <= range && of_a + of_b - (1023 + least) <= range;
    if (c == 0.0 && is_moderate) return a * b + c;
    return slow(a, b, c);
  }
  constexpr double splitter = 0x1p27 + 1.0;
  const double ca = splitter * a, cb = splitter * b;
  const double a_high = ca - (ca - a), b_high = cb - (cb - b);
  const double a_low = a - a_high, b_low = b - b_high;
  const double product = a * b;
  const double product_error = a_low * b_low - (((product - a_high * b_high) - a_low * b_high) - a_high * b_low);
  const auto error_of_sum = [](double x, double y, double sum) {
    const double other = sum - x;
    return (x - (sum - other)) + (y - other);
  };
  const double t = c + product_error;
  const double t_error = error_of_sum(c, product_error, t);
  const double v = product + t;
  const double v_error = error_of_sum(product, t, v);
  double rest = t_error + v_error;
  const double lost = error_of_sum(t_error, v_error, rest);
  // To odd: of the two neighbours of a sum that is not exact, the one with an odd last bit.
  if (lost != 0.0 && (bits_of(rest) & 1U) == 0) {
    rest = base::number_of((lost > 0.0) == (rest > 0.0) ? bits_of(rest) + 1 : bits_of(rest) - 1);
  }
  return v + rest;
}

}  // namespace rocking::live
