#pragma once

#include <cmath>
#include <concepts>

namespace rocking::base {

/// a b + c, rounded once.
[[nodiscard]] inline double fused(double a, double b, double c) { return std::fma(a, b, c); }

[[nodiscard]] inline double select(bool condition, double if_true, double if_false) {
  return condition ? if_true : if_false;
}

/// What a number must offer to be advanced by the stepping kernel: IEEE arithmetic, a fused multiply-add and a selection
/// without a branch. `double` is one lane; a pack of several models the same concept, so that one source serves all
/// widths and every lane gets the bits that it would get alone.
template <class Real>
concept Lane = requires(Real a, Real b, Real c) {
  { a + b } -> std::convertible_to<Real>;
  { a - b } -> std::convertible_to<Real>;
  { a * b } -> std::convertible_to<Real>;
  { a / b } -> std::convertible_to<Real>;
  { -a } -> std::convertible_to<Real>;
  { fused(a, b, c) } -> std::convertible_to<Real>;
  { select(a < b, a, b) } -> std::convertible_to<Real>;
};

}  // namespace rocking::base
