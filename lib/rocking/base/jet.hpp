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

}  // namespace rocking::base
