#pragma once

#include <cstddef>

#include "rocking/base/lane.hpp"

namespace rocking::base {

/// The Taylor coefficients p(x), p'(x), p''(x)/2, p'''(x)/6.
template <Lane Real>
struct Jet {
  Real value;
  Real first;
  Real second;
  Real third;
};

/// The jet of sum c[k] x^k, k < count, by Horner's rule, all four coefficients in one loop.
template <Lane Real>
[[nodiscard]] inline Jet<Real> jet_at(const Real* c, std::size_t count, const Real& x) {
  Jet<Real> jet{c[count - 1], Real(0.0), Real(0.0), Real(0.0)};
  for (std::size_t k = count - 1; k-- > 0;) {
    jet.third = fused(jet.third, x, jet.second);
    jet.second = fused(jet.second, x, jet.first);
    jet.first = fused(jet.first, x, jet.value);
    jet.value = fused(jet.value, x, c[k]);
  }
  return jet;
}

/// A number and its derivative in one direction. A function over base::Number that is evaluated with it gives its own
/// directional derivative, exact but for rounding.
struct Dual {
  double value = 0.0;
  double slope = 0.0;

  Dual() = default;
  explicit Dual(double constant) : value(constant) {}
  Dual(double value_, double slope_) : value(value_), slope(slope_) {}
};

[[nodiscard]] inline Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.slope + b.slope}; }
[[nodiscard]] inline Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.slope - b.slope}; }
[[nodiscard]] inline Dual operator-(const Dual& a) { return {-a.value, -a.slope}; }
[[nodiscard]] inline Dual operator*(const Dual& a, const Dual& b) {
  return {a.value * b.value, a.slope * b.value + a.value * b.slope};
}
[[nodiscard]] inline Dual operator/(const Dual& a, const Dual& b) {
  const double ratio = a.value / b.value;
  return {ratio, (a.slope - ratio * b.slope) / b.value};
}
[[nodiscard]] inline Dual fused(const Dual& a, const Dual& b, const Dual& c) {
  return {fused(a.value, b.value, c.value), fused(a.slope, b.value, fused(a.value, b.slope, c.slope))};
}

}  // namespace rocking::base
