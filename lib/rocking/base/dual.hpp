#pragma once

#include "rocking/base/lane.hpp"

namespace rocking::base {

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
