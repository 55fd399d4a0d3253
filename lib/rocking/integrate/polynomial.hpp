#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "rocking/base/lane.hpp"

namespace rocking::integrate {

/// At least the number of coefficients of any step's polynomial or guard.
inline constexpr std::size_t max_coefficients = 20;

/// sum c[k] x^k by Horner's rule, each step fused.
template <base::Lane Real>
[[nodiscard]] Real evaluate(std::span<const Real> c, Real x) {
  using base::fused;
  Real value = c.back();
  for (std::size_t k = c.size() - 1; k-- > 0;) value = fused(value, x, c[k]);
  return value;
}

/// The Taylor coefficients p(x), p'(x), p''(x)/2, p'''(x)/6.
template <base::Lane Real>
struct Jet {
  Real value;
  Real first;
  Real second;
  Real third;
};

/// The jet of sum c[k] x^k, k < count, by Horner's rule, all four coefficients in one loop.
template <base::Lane Real>
[[nodiscard]] inline Jet<Real> jet_at(const Real* c, std::size_t count, const Real& x) {
  using base::fused;
  Jet<Real> jet{c[count - 1], Real(0.0), Real(0.0), Real(0.0)};
  for (std::size_t k = count - 1; k-- > 0;) {
    jet.third = fused(jet.third, x, jet.second);
    jet.second = fused(jet.second, x, jet.first);
    jet.first = fused(jet.first, x, jet.value);
    jet.value = fused(jet.value, x, c[k]);
  }
  return jet;
}
[[nodiscard]] inline Jet<double> jet_at(std::span<const double> c, double x) { return jet_at(c.data(), c.size(), x); }

/// The same polynomial in t = x/length: coefficients c[k] length^k, so that the step is t in [0, 1].
inline std::span<const double> scale_to_unit(std::span<const double> c, double length,
                                             std::array<double, max_coefficients>& scaled) {
  // Even and odd powers separately, which halves the chain of dependent products.
  const double square = length * length;
  double even = 1.0;
  double odd = length;
  for (std::size_t k = 0; k < c.size(); k += 2) {
    scaled[k] = c[k] * even;
    if (k + 1 < c.size()) scaled[k + 1] = c[k + 1] * odd;
    even *= square;
    odd *= square;
  }
  return {scaled.data(), c.size()};
}

}  // namespace rocking::integrate
