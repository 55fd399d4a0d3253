#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>

namespace rocking::base {

/// a b + c, rounded once.
[[nodiscard]] inline double fused(double a, double b, double c) { return std::fma(a, b, c); }

[[nodiscard]] inline double select(bool condition, double if_true, double if_false) {
  return condition ? if_true : if_false;
}

/// a where a < b, else b.
[[nodiscard]] inline double smaller(double a, double b) { return a < b ? a : b; }

[[nodiscard]] inline double magnitude(double x) { return std::abs(x); }

/// a <= b.
template <class Real>
[[nodiscard]] inline auto at_most(const Real& a, const Real& b) {
  return a < b || a == b;
}

/// Whether the condition is true in any lane.
[[nodiscard]] inline bool in_any(bool truth) { return truth; }

/// The upper 32 bits of abs(y), as a number below 2^31: exponent and the first 20 bits of the mantissa.
[[nodiscard]] inline double upper_word(double y) {
  return static_cast<double>(std::bit_cast<std::uint64_t>(y) << 1U >> 33U);
}

/// The number whose upper 32 bits are `word`, rounded to an integer, and whose lower 32 bits are 0. Adding 2^52 rounds
/// `word` and leaves the integer in the lower half of the bits of the sum.
[[nodiscard]] inline double from_upper_word(double word) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(word + 0x1p52) << 32U);
}

/// The 64 bits of a number, and the inverse.
[[nodiscard]] constexpr std::uint64_t bits_of(double y) { return std::bit_cast<std::uint64_t>(y); }
[[nodiscard]] constexpr double number_of(std::uint64_t bits) { return std::bit_cast<double>(bits); }

/// IEEE arithmetic and a fused multiply-add: sufficient to evaluate a polynomial.
template <class Real>
concept Number = requires(Real a, Real b, Real c) {
  { a + b } -> std::convertible_to<Real>;
  { a - b } -> std::convertible_to<Real>;
  { a* b } -> std::convertible_to<Real>;
  { a / b } -> std::convertible_to<Real>;
  { -a } -> std::convertible_to<Real>;
  { fused(a, b, c) } -> std::convertible_to<Real>;
};

/// What the stepping kernel requires of a number: arithmetic and selection without a branch. `double` is one lane; a
/// pack of several numbers models the same concept. One source therefore serves all widths, and each lane gets the same
/// bits as it would get alone.
template <class Real>
concept Lane = Number<Real> && requires(Real a, Real b) {
  { select(a < b, a, b) } -> std::convertible_to<Real>;
  { smaller(a, b) } -> std::convertible_to<Real>;
  { from_upper_word(upper_word(a)) } -> std::convertible_to<Real>;
};

}  // namespace rocking::base
