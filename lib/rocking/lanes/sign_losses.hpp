#pragma once

#include <cstddef>
#include <limits>

#include "rocking/integrate/bernstein.hpp"
#include "rocking/lanes/step.hpp"

/// integrate::first_sign_loss in all lanes at once, for the polynomials that need no halving; with its expressions, in their
/// order.
namespace rocking::lanes {
namespace {

template <class Real>
struct SignLosses {
  Real instant;  ///< t in [0, 1], in the lanes that lost their sign
  TruthOf<Real> lost;
  TruthOf<Real> unclear;  ///< to be looked at alone
};

template <class Real>
[[nodiscard]] Real magnitude(const Real& x) {
  using base::select;
  return select(x < Real(0.0), -x, x);
}

template <class Real>
[[nodiscard]] TruthOf<Real> at_most(const Real& a, const Real& b) {
  return a < b || a == b;
}

/// integrate::refine from t on within [0, 1], in the lanes where `active`; true where it has come to its end.
template <class Real>
[[gnu::noinline]] TruthOf<Real> refine(const Real* c, std::size_t count, TruthOf<Real> active, Real& t) {
  using base::fused, base::select;
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  constexpr int most_iterations = 20;
  const Real zero(0.0);
  const Real one(1.0);
  Real low(0.0);
  Real high(1.0);
  for (int iteration = 0; iteration < most_iterations && bits_of(active) != 0; ++iteration) {
    Real value = c[count - 1];
    Real first(0.0);
    Real second(0.0);
    Real third(0.0);
    for (std::size_t k = count - 1; k-- > 0;) {
      third = fused(third, t, second);
      second = fused(second, t, first);
      first = fused(first, t, value);
      value = fused(value, t, c[k]);
    }
    const auto is_past = value < zero;
    high = select(is_past, t, high);
    low = select(is_past, low, t);
    const Real scale = one / first;
    const Real newton = value * scale;
    second = second * scale * newton;
    third = third * scale * newton * newton;
    const Real next = t - newton * (one + second + (Real(2.0) * second * second - third));
    const auto inside = first < zero && at_most(low, next) && at_most(next, high);
    const Real chosen = select(inside, next, Real(0.5) * (low + high));
    const Real third_order = magnitude(newton) * (second * second + magnitude(third));
    const auto is_close = inside && at_most(magnitude(newton), Real(0.015625) * t) &&
                          at_most(third_order * Real(4.0) * magnitude(newton), Real(0.25 * epsilon) * t * t);
    const auto stands = at_most(magnitude(chosen - t), Real(epsilon) * t);
    t = select(active, chosen, t);
    active = active && !(is_close || stands);
  }
  return !active;
}

/// In the lanes where `wanted`, of sum c[k] t^k.
template <std::size_t count, class Real>
[[gnu::noinline]] void first_sign_losses(const Real* c, const TruthOf<Real>& wanted, SignLosses<Real>& found) {
  using base::fused, base::select;
  static constexpr auto weights = integrate::bernstein_weights<count - 1>();
  const Real zero(0.0);
  Real b[count];
#pragma GCC unroll 20
  for (std::size_t i = 0; i < count; ++i) b[i] = zero;
#pragma GCC unroll 20
  for (std::size_t k = 0; k < count; ++k) {
#pragma GCC unroll 20
    for (std::size_t i = k; i < count; ++i) b[i] = fused(Real(weights.of[k][i]), c[k], b[i]);
  }
  // The last coefficient before a change of sign, the first after it, and how many changes there are.
  auto any_zero = b[0] == zero;
  Real changes(0.0);
  Real place(0.0);
  Real before(0.0);
  Real after(0.0);
#pragma GCC unroll 20
  for (std::size_t i = 1; i < count; ++i) {
    any_zero = any_zero || b[i] == zero;
    const auto was_below = b[i - 1] < zero;
    const auto is_below = b[i] < zero;
    const auto falls = is_below && !was_below;
    changes = changes + select(falls || (was_below && !is_below), Real(1.0), zero);
    place = select(falls, Real(static_cast<double>(i - 1)), place);
    before = select(falls, b[i - 1], before);
    after = select(falls, b[i], after);
  }
  const auto starts_below = b[0] < zero;
  const auto changes_once = wanted && !any_zero && !starts_below && changes == Real(1.0);
  Real t = (place + before / (before - after)) / Real(static_cast<double>(count - 1));
  const auto is_refined = refine(c, count, changes_once, t);
  found.instant = select(starts_below, zero, t);
  found.lost = wanted && !any_zero && (starts_below || changes_once);
  found.unclear = wanted && (any_zero || (!starts_below && Real(1.5) < changes) || !is_refined);
}

}  // namespace
}  // namespace rocking::lanes
