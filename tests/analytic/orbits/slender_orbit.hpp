#pragma once

#include <cmath>
#include <string>

#include "analytic/motion.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/classification.hpp"
#include "support/excitation.hpp"

/// The slender-block limit under harmonic excitation: symmetric (1,n) orbits in closed form. Derived in
/// reports/evidence/closed-forms.md, whose symbols are used here.
namespace rocking::slender_limit {

/// Orbits with a period of n excitation periods and the rate ratio r of each impact.
struct Family {
  double r;
  double omega;
  int n;

  [[nodiscard]] double h() const { return n * pi / omega; }
  [[nodiscard]] double t() const { return std::tanh(0.5 * h()); }
  [[nodiscard]] double rho() const { return (1.0 + r) / (1.0 - r); }
  [[nodiscard]] double x_fold() const { return rho() / (omega * omega + rho() * rho() / (t() * t())); }
  [[nodiscard]] double x_symmetry() const { return rho() / (rho() * rho() + omega * omega + 1.0 - 1.0 / (t() * t())); }
  [[nodiscard]] double amplitude(double x) const {
    return (1.0 + omega * omega) * std::hypot(x, (t() - rho() * x / t()) / omega);
  }
};

struct State {
  double tilt;
  double rate;
};

/// The orbit of the family with Gamma sin(phi) = x.
struct Orbit {
  Family family;
  double x;

  [[nodiscard]] double y() const { return family.t() - family.rho() * x / family.t(); }
  [[nodiscard]] double v() const { return (family.rho() - 1.0) * x / family.t(); }
  [[nodiscard]] double phase() const { return std::atan2(x, y() / family.omega); }

  /// State at a time u in [0, h] after the impact that put the block on its left edge.
  [[nodiscard]] State at(double u) const {
    const double c = x - 1.0;
    const double d = v() + y();
    const double gamma = std::hypot(x, y() / family.omega);
    const double angle = family.omega * u + phase();
    return {1.0 + c * std::cosh(u) + d * std::sinh(u) - gamma * std::sin(angle),
            c * std::sinh(u) + d * std::cosh(u) - gamma * family.omega * std::cos(angle)};
  }

  /// State at any time: the second half of the orbit mirrors the first.
  [[nodiscard]] State later(double u) const {
    const double within = std::fmod(u, 2.0 * family.h());
    if (within <= family.h()) return at(within);
    const State mirrored = at(within - family.h());
    return {-mirrored.tilt, -mirrored.rate};
  }

  /// Time of the largest Theta: the best of many instants, refined by bisection of the slope.
  [[nodiscard]] double peak() const {
    double best = 0.5 * family.h();
    for (int i = 1; i < 200; ++i) {
      const double u = family.h() * i / 200.0;
      if (at(u).tilt > at(best).tilt) best = u;
    }
    double low = best - family.h() / 200.0;
    double high = best + family.h() / 200.0;
    while (high - low > 1e-15) {
      const double middle = 0.5 * (low + high);
      (at(middle).rate > 0.0 ? low : high) = middle;
    }
    return low;
  }

  /// Trace of the linearised map from one impact to the next; the determinant is r^2.
  [[nodiscard]] double trace() const {
    const double r = family.r;
    return 1.0 + r * r + 0.5 * (1.0 - r * r) * (std::cosh(family.h()) - 1.0) * (1.0 / x - 1.0 / family.x_fold());
  }
};

/// The orbit at this share of the range between the fold and the loss of symmetry.
inline Orbit stable(const Family& family, double share) {
  return {family, family.x_fold() * (1.0 - share) + family.x_symmetry() * share};
}

/// A block of height `height` times its width with the initial state `start` and impacts of ratio r. e is chosen such
/// that delta = r; it may lie outside the range allowed in experiments.
inline Condition slender(const Orbit& orbit, double height, const State& start, double phase) {
  Condition condition;
  Scene& scene = condition.scene;
  scene.block.height = height;
  const double sine = dynamics::geometry_of(mean_block(scene)).sine;
  scene.restitution = (1.0 - orbit.family.r) / (1.5 * sine * sine) - 1.0;
  support::harmonic(scene).amplitude = orbit.family.amplitude(orbit.x);
  support::harmonic(scene).frequency_ratio = orbit.family.omega;
  support::harmonic(scene).phase = phase;
  scene.initial = {.tilt = start.tilt, .tilt_rate = start.rate, .slip_rate = 0.0};
  return condition;
}

inline std::string name_of(const Orbit& orbit) {
  return "r = " + std::to_string(orbit.family.r) + ", Omega = " + std::to_string(orbit.family.omega) +
         ", n = " + std::to_string(orbit.family.n);
}

/// The orbit of the family whose larger eigenvalue is `multiplier`.
inline Orbit with_multiplier(const Family& family, double multiplier) {
  const double square = family.r * family.r;
  const double trace = multiplier + square / multiplier;
  const double excess = 2.0 * (trace - 1.0 - square) / ((1.0 - square) * (std::cosh(family.h()) - 1.0));
  return {family, 1.0 / (excess + 1.0 / family.x_fold())};
}

/// The state of the orbit where the argument of its excitation is a multiple of 2 pi.
inline section::StrobePoint on_section(const Orbit& orbit) {
  double time = -orbit.phase() / orbit.family.omega;
  while (time < 0.0) time += 2.0 * pi / orbit.family.omega;
  const State state = orbit.later(time);
  return {.tilt = state.tilt, .tilt_rate = state.rate, .slip_rate = 0.0};
}

}  // namespace rocking::slender_limit
