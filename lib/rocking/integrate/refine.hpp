#pragma once

#include <cstddef>
#include <limits>

#include "rocking/base/lane.hpp"
#include "rocking/integrate/polynomial.hpp"

namespace rocking::integrate {

/// The only downward zero crossing of sum c[k] t^k, k < count, in [low, high], found from the initial value `t` within
/// a shrinking bracket: of one polynomial, or of a pack of polynomials in the lanes `active`. An iteration inverts the
/// first four terms of the Taylor series, so that the error is of the fourth order. Returns whether, or in which lanes,
/// `most_iterations` sufficed.
/// Source: Householder (1970), The Numerical Treatment of a Single Nonlinear Equation, chapter 4.
template <base::Lane Real, class Truth>
[[nodiscard]] inline Truth refine(const Real* c, std::size_t count, Truth active, Real low, Real high, Real& t,
                                  int most_iterations) {
  using base::at_most, base::in_any, base::magnitude, base::select;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const Real zero(0.0);
  const Real one(1.0);
  for (int iteration = 0; iteration < most_iterations && in_any(active); ++iteration) {
    const Jet<Real> p = jet_at(c, count, t);
    const Truth is_past = p.value < zero;
    high = select(is_past, t, high);
    low = select(is_past, low, t);
    const Real scale = one / p.first;
    const Real newton = p.value * scale;
    const Real second = p.second * scale * newton;
    const Real third = p.third * scale * newton * newton;
    const Real next = t - newton * (one + second + (Real(2.0) * second * second - third));
    // p falls at the crossing. Where it rises the method would converge to a zero at the left end.
    const Truth inside = p.first < zero && at_most(low, next) && at_most(next, high);
    const Real chosen = select(inside, next, Real(0.5) * (low + high));
    // Close to the root, where p is like a power of t, the fourth-order term is at most about 4 newton/t times the
    // third-order one.
    const Real third_order = magnitude(newton) * (second * second + magnitude(third));
    const Truth is_close = inside && at_most(magnitude(newton), Real(0.015625) * t) &&
                           at_most(third_order * Real(4.0) * magnitude(newton), Real(0.25 * epsilon) * t * t);
    const Truth stands = at_most(magnitude(chosen - t), Real(epsilon) * t);
    t = select(active, chosen, t);
    active = active && !(is_close || stands);
  }
  return !active;
}

}  // namespace rocking::integrate
