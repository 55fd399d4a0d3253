#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace rocking::support {

/// A block rocking about its left edge on a harmonic base, in long double: theta'' = factor (-sin(phi) + alpha cos(phi))
/// with phi = psi - theta and alpha = peak sin(frequency tau + phase), by Taylor series. Over a `step` the truncation error
/// is below 1e-25, the rounding 2000 times smaller than that of a double. There are no events: theta may fall below 0.
struct LongDoubleRock {
  using Real = long double;
  static constexpr std::size_t order = 24;
  static constexpr Real step = 1.0L / 64.0L;
  using Series = std::array<Real, order + 2>;

  Real psi;
  Real peak;
  Real frequency;
  Real phase;
  Real factor = 1.0L;  ///< K r of an edge (model.md, 11); 1 of a uniform rectangle

  /// The lowest point of the first fall from (tilt, rate), rate < 0, and the time at which it passes theta = 0 before.
  struct Dip {
    Real time;
    Real tilt;
    Real ground_time;  ///< meaningful if tilt < 0
    Real ground_rate;
  };

  [[nodiscard]] Dip dip(Real tilt, Real rate) const {
    Dip found{};
    bool is_below = false;
    for (Real tau = 0.0L;; tau += step) {
      Series theta{};
      Series omega{};
      expand(tau, tilt, rate, theta, omega);
      const bool turns = value(omega, step) > 0.0L;
      const Real end = turns ? zero(omega, step) : step;
      if (!is_below && value(theta, end) < 0.0L) {
        is_below = true;
        const Real x = zero(theta, end);
        found.ground_time = tau + x;
        found.ground_rate = value(omega, x);
      }
      tilt = value(theta, end);
      rate = value(omega, end);
      found.time = tau + end;
      found.tilt = tilt;
      if (turns) return found;
    }
  }

  void expand(Real tau, Real tilt, Real rate, Series& theta, Series& omega) const {
    Series s{};
    Series c{};
    Series alpha{};
    theta[0] = tilt;
    omega[0] = rate;
    s[0] = std::sin(psi - tilt);
    c[0] = std::cos(psi - tilt);
    alpha[0] = peak * std::sin(frequency * tau + phase);
    alpha[1] = peak * frequency * std::cos(frequency * tau + phase);
    for (std::size_t k = 0; k <= order; ++k) {
      const Real next = 1.0L / static_cast<Real>(k + 1);
      Real push = 0.0L;
      Real turn_sine = 0.0L;
      Real turn_cosine = 0.0L;
      for (std::size_t i = 0; i <= k; ++i) {
        push += alpha[i] * c[k - i];
        turn_sine += omega[i] * c[k - i];
        turn_cosine += omega[i] * s[k - i];
      }
      theta[k + 1] = omega[k] * next;
      omega[k + 1] = factor * (push - s[k]) * next;
      s[k + 1] = -turn_sine * next;
      c[k + 1] = turn_cosine * next;
      if (k + 2 <= order) alpha[k + 2] = -frequency * frequency * alpha[k] * next / static_cast<Real>(k + 2);
    }
  }

  [[nodiscard]] static Real value(const Series& series, Real x) {
    Real sum = 0.0L;
    for (std::size_t k = series.size(); k-- > 0;) sum = sum * x + series[k];
    return sum;
  }

  /// The sign change of the series between 0 and x, by bisection.
  [[nodiscard]] static Real zero(const Series& series, Real x) {
    const bool rises = value(series, x) > 0.0L;
    Real low = 0.0L;
    for (int i = 0; i < 160; ++i) {
      const Real middle = 0.5L * (low + x);
      ((value(series, middle) > 0.0L) == rises ? x : low) = middle;
    }
    return x;
  }
};

}  // namespace rocking::support
