#pragma once

#include <array>
#include <cstddef>

#include "rocking/integrate/polynomial.hpp"
#include "rocking/integrate/refine.hpp"
#include "rocking/lanes/row.hpp"

/// integrate::first_zero_crossing in all lanes at once, for the polynomials that need at most one halving; with the
/// same expressions in the same order.
namespace rocking::lanes {
namespace {

template <class Real>
struct ZeroCrossings {
  Real instant;  ///< t in [0, 1], in the lanes with a crossing
  TruthOf<Real> crosses;
  TruthOf<Real> unclear;  ///< lanes that need more halvings: the motion must search alone
};

/// integrate::refine with few iterations: true in the lanes where they suffice.
template <class Real>
[[gnu::noinline]] TruthOf<Real> refine(const Real* c, std::size_t count, TruthOf<Real> active, Real low, Real high,
                                       Real& t) {
  constexpr int most_iterations = 20;
  return integrate::refine(c, count, active, low, high, t, most_iterations);
}

/// The signs of Bernstein coefficients.
template <class Real>
struct Signs {
  TruthOf<Real> starts_below;
  TruthOf<Real> any_zero;
  Real changes;  ///< of the sign, their number
  // At the last change to below:
  Real place;   ///< of the last coefficient before it
  Real before;  ///< its value
  Real after;   ///< value of the next one

  [[nodiscard]] TruthOf<Real> never() const { return !any_zero && !starts_below && changes == Real(0.0); }
  [[nodiscard]] TruthOf<Real> once() const { return !any_zero && !starts_below && changes == Real(1.0); }
  [[nodiscard]] TruthOf<Real> often() const { return !any_zero && !starts_below && Real(1.0) < changes; }
};

template <class Real, std::size_t count>
[[nodiscard]] Signs<Real> signs_of(const std::array<Real, count>& b) {
  using base::select;
  const Real zero(0.0);
  Signs<Real> signs{.starts_below = b[0] < zero,
                    .any_zero = b[0] == zero,
                    .changes = zero,
                    .place = zero,
                    .before = zero,
                    .after = zero};
#pragma GCC unroll 20
  for (std::size_t i = 1; i < count; ++i) {
    signs.any_zero = signs.any_zero || b[i] == zero;
    const auto was_below = b[i - 1] < zero;
    const auto is_below = b[i] < zero;
    const auto falls = is_below && !was_below;
    signs.changes = signs.changes + select(falls || (was_below && !is_below), Real(1.0), zero);
    signs.place = select(falls, Real(static_cast<double>(i - 1)), signs.place);
    signs.before = select(falls, b[i - 1], signs.before);
    signs.after = select(falls, b[i], signs.after);
  }
  return signs;
}

/// An interval with a polynomial's first zero crossing.
template <class Real>
struct Isolation {
  TruthOf<Real> at_once;  ///< lanes where it is negative at once after `left`
  TruthOf<Real> once;     ///< lanes with one crossing between `left` and `left + width`
  TruthOf<Real> clear;    ///< these, and those without a crossing
  Real left;
  Real width;
  Real guess;  ///< near the crossing
};

template <std::size_t count, class Real>
[[nodiscard]] Real crossing(const Signs<Real>& signs) {
  return (signs.place + signs.before / (signs.before - signs.after)) / Real(static_cast<double>(count - 1));
}

/// Halves the interval by de Casteljau's scheme in the lanes `often`, whose signs change several times: nearly all are
/// clear then. The arguments are values, so that the caller can keep them in registers.
template <std::size_t count, class Real>
[[gnu::noinline]] Isolation<Real> halved(std::array<Real, count> b, TruthOf<Real> often, Isolation<Real> isolation) {
  using base::select;
  const Real half(0.5);
  std::array<Real, count> right;
  right[count - 1] = b[count - 1];
#pragma GCC unroll 20
  for (std::size_t j = 1; j < count; ++j) {
#pragma GCC unroll 20
    for (std::size_t i = count - 1; i >= j; --i) b[i] = half * (b[i - 1] + b[i]);
    right[count - 1 - j] = b[count - 1];
  }
  const Signs<Real> first = signs_of(b);
  const Signs<Real> second = signs_of(right);
  const auto in_first = often && first.once();
  const auto later = often && first.never();
  const auto in_second = later && second.once();
  const auto at_half = later && second.starts_below && !second.any_zero;
  isolation.at_once = isolation.at_once || at_half;
  isolation.once = isolation.once || in_first || in_second;
  isolation.clear = isolation.clear || in_first || in_second || at_half || (later && second.never());
  isolation.left = select(later, half, isolation.left);
  isolation.width = select(often, half, isolation.width);
  isolation.guess = select(in_first, half * crossing<count>(first), isolation.guess);
  isolation.guess = select(in_second, half + half * crossing<count>(second), isolation.guess);
  return isolation;
}

/// In the lanes `wanted`, of sum c[k] t^k.
template <std::size_t count, class Real>
[[gnu::noinline]] void first_zero_crossings(const Real* c, const TruthOf<Real>& wanted, ZeroCrossings<Real>& found) {
  using base::fused, base::select;
  static constexpr auto weights = integrate::bernstein_weights<count - 1>();
  std::array<Real, count> b;
#pragma GCC unroll 20
  for (std::size_t i = 0; i < count; ++i) b[i] = Real(0.0);
#pragma GCC unroll 20
  for (std::size_t k = 0; k < count; ++k) {
#pragma GCC unroll 20
    for (std::size_t i = k; i < count; ++i) b[i] = fused(Real(weights.of[k][i]), c[k], b[i]);
  }
  const Signs<Real> signs = signs_of(b);
  const auto at_once = wanted && signs.starts_below && !signs.any_zero;
  const auto once = wanted && signs.once();
  Isolation<Real> isolation{.at_once = at_once,
                            .once = once,
                            .clear = at_once || once || (wanted && signs.never()),
                            .left = Real(0.0),
                            .width = Real(1.0),
                            .guess = crossing<count>(signs)};
  const auto often = wanted && signs.often();
  if (bits_of(often) != 0) isolation = halved<count>(b, often, isolation);
  Real t = isolation.guess;
  const auto is_refined = refine(c, count, isolation.once, isolation.left, isolation.left + isolation.width, t);
  found.instant = select(isolation.at_once, isolation.left, t);
  found.crosses = isolation.at_once || isolation.once;
  found.unclear = wanted && !(isolation.clear && is_refined);
}

}  // namespace
}  // namespace rocking::lanes
