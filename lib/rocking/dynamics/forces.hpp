#pragma once

#include <cmath>

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/setting.hpp"

namespace rocking::dynamics {

/// Base accelerations over g.
struct BaseMotion {
  double horizontal;  ///< alpha
  double weight;      ///< 1 + alpha_v
};

/// Contact forces over m R p^2 and the acceleration that goes with them.
struct Forces {
  double normal;        ///< N
  double friction;      ///< F that rocking without slip needs; > 0 pushes the block towards +x
  double acceleration;  ///< w'
};

/// Bound of abs(w') of a block that rocks and sticks, whatever its shape: w' = beta c - s.
[[nodiscard]] inline double largest_acceleration(double largest_base_acceleration) {
  return largest_base_acceleration + 1.0;
}

/// Which guards of a block that rocks and sticks cannot fire over a step, whatever its series are.
template <class Truth>
struct OutOfReach {
  Truth past_balance;
  Truth normal;
};

/// What bounds the guards of a block that rocks and sticks over a step.
template <base::Lane Real>
struct ReachOfStep {
  Real tilt;            ///< S theta
  Real tilt_rate;       ///< S w
  Real base_amplitude;  ///< a bound of abs(beta) is its magnitude
  Real length;          ///< of the step
};

/// Over a step without vertical base motion that begins at a tilt between contact and balance. Until one of the two is
/// reached 0 <= phi <= psi, so that w' = beta c - s lies between -(A + sin(psi)) and A, a bound of abs(beta), and N =
/// 4/3 + w' s - w^2 c is at least 4/3 - (A + sin(psi)) sin(psi) - w^2. A second A length^2/2, and 5/4 for 4/3, leave
/// room for the rounding and the tolerance of the series.
template <base::Lane Real>
[[nodiscard]] auto out_of_reach(const ReachOfStep<Real>& step, const EquationConstants<Real>& constants) {
  using base::fused, base::magnitude;
  const Real zero(0.0);
  const Real most = magnitude(step.base_amplitude);
  const Real rate = magnitude(step.tilt_rate);
  using Truth = decltype(step.tilt < zero);
  const Truth below = fused(fused(most, step.length, rate), step.length, step.tilt) < constants.shape_angle;
  const Real acceleration = most + constants.sine;
  const Real fastest = fused(acceleration, step.length, rate);
  const Truth presses = zero < fused(-fastest, fastest, fused(-acceleration, constants.sine, Real(1.25)));
  return OutOfReach<Truth>{.past_balance = below, .normal = below && presses};
}

/// Whether a block in full contact stays on both edges: abs(alpha) <= tan(psi) (1 + alpha_v).
///
/// Written as w' of rocking, which must be > 0 after a lift. Another form could round to the opposite sign at the
/// threshold, and the block would lift and land endlessly at one instant.
[[nodiscard]] inline bool edges_hold(const BaseMotion& base, const Geometry& block) {
  return std::abs(base.horizontal) * block.cosine <= base.weight * block.sine;
}

/// Whether kinetic friction turns a sliding block over its leading edge: mu_k > tan(psi), written as w' of rock-slide.
[[nodiscard]] inline bool friction_tips(double kinetic_friction, const Geometry& block) {
  return kinetic_friction * block.cosine > block.sine;
}

/// How a rocking block moves at an instant, seen from its side: one motion or a pack.
template <base::Number Real>
struct EdgeMotion {
  base::SinCos<Real> edge;  ///< of phi
  Real omega;               ///< S w
  Real beta;                ///< S alpha
  Real weight;              ///< 1 + alpha_v
};

/// Contact forces and acceleration, seen from the block's side.
template <base::Number Real>
struct SideForces {
  Real normal;        ///< N
  Real friction;      ///< S F
  Real acceleration;  ///< S w'
};

/// Forces of rocking without slip: bit for bit the first coefficients of the series that `expand_rock` computes. The
/// comparison after an event and the guard of the coming step must agree where friction is exactly at its limit.
template <base::Number Real>
[[nodiscard]] inline SideForces<Real> forces_without_slip(const EdgeMotion<Real>& now) {
  using base::fused;
  const auto& [s, c] = now.edge;
  const Real rate = now.beta * c - now.weight * s;
  return {.normal = Real(4.0 / 3.0) * now.weight + fused(rate, s, -(now.omega * (now.omega * c))),
          .friction = Real(4.0 / 3.0) * now.beta - fused(rate, c, now.omega * (now.omega * s)),
          .acceleration = rate};
}

/// Whether friction of at most `coefficient` times N is enough for these forces; N > 0.
template <base::Lane Real>
[[nodiscard]] inline auto friction_is_enough(const SideForces<Real>& forces, const Real& coefficient) {
  using base::magnitude;
  return base::at_most(magnitude(forces.friction), coefficient * forces.normal);
}

/// Forces of rocking without slip, of a state.
[[nodiscard]] inline Forces rocking_forces(const State& state, const BaseMotion& base,
                                           const EquationConstants<double>& constants) {
  const auto [normal, friction, acceleration] = forces_without_slip<double>({.edge = edge_angle(state, constants),
                                                                             .omega = state.side * state.tilt_rate,
                                                                             .beta = state.side * base.horizontal,
                                                                             .weight = base.weight});
  return {.normal = normal, .friction = state.side * friction, .acceleration = state.side * acceleration};
}

/// Rates of change while rocking with slip, and the normal force that goes with them.
struct SlippingRates {
  double tilt_acceleration;  ///< w' = -(G - w^2 cos(phi)) q/D
  double slip_acceleration;  ///< V' = -(4/3) alpha - s mu_k N + w' cos(phi) + S w^2 sin(phi)
  double normal;             ///< N = J (G - w^2 cos(phi))/D
};

/// The rates of a state: bit for bit the first coefficients of the series that `expand_rock_slide` computes.
[[nodiscard]] inline SlippingRates slipping_rates(const State& state, const BaseMotion& base, double kinetic_friction,
                                                  const EquationConstants<double>& constants) {
  const auto [s, c] = edge_angle(state, constants);
  const double omega = state.side * state.tilt_rate;
  const double drag = state.side * state.slip_direction * kinetic_friction;
  const double arm = std::fma(drag, c, s);
  const double load = 4.0 / 3.0 * base.weight - omega * (omega * c);
  const double rate = load * arm * (-1.0 / std::fma(s, arm, constants.inertia));
  const double normal = std::fma(rate, s, load);
  const double force = std::fma(drag, normal, 4.0 / 3.0 * (state.side * base.horizontal));
  return {.tilt_acceleration = state.side * rate,
          .slip_acceleration = state.side * (std::fma(rate, c, omega * (omega * s)) - force),
          .normal = normal};
}

}  // namespace rocking::dynamics
