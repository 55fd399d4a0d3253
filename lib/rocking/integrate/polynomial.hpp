#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "rocking/base/jet.hpp"
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

using base::Jet;
using base::jet_at;
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

/// C(i,k)/C(n,k), by k and i: the weight of coefficient k of a polynomial of degree n in its Bernstein coefficient i on
/// [0, 1]; 0 where i < k.
/// Source: Farouki & Rajan (1987), CAGD 4, 191-216.
template <std::size_t n>
struct BernsteinWeights {
  double of[n + 1][n + 1];
};

template <std::size_t n>
[[nodiscard]] consteval BernsteinWeights<n> bernstein_weights() {
  const auto binomial = [](std::size_t from, std::size_t k) {
    double value = 1.0;  // an integer below 2^53
    for (std::size_t m = 0; m < k; ++m) value = value * static_cast<double>(from - m) / static_cast<double>(m + 1);
    return value;
  };
  BernsteinWeights<n> weights{};
  for (std::size_t k = 0; k <= n; ++k) {
    for (std::size_t i = k; i <= n; ++i) weights.of[k][i] = binomial(i, k) / binomial(n, k);
  }
  return weights;
}

}  // namespace rocking::integrate
