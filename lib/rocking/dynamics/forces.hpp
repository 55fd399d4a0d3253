#pragma once

#include <algorithm>
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

/// Bound of abs(w') of a block that rocks and sticks, on either side: w' = K (beta c - s) with s, c of at most r.
[[nodiscard]] inline double largest_acceleration(double largest_base_acceleration, const Geometry& block) {
  if (block.is_rectangle()) [[likely]]
    return largest_base_acceleration + 1.0;
  const auto& [left, right] = block.edges;
  return std::max(left.rocking_gain * left.radius, right.rocking_gain * right.radius) *
         (largest_base_acceleration + 1.0);
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
/// reached 0 <= phi <= psi, so that w' = K (beta c - s) lies between -K (A + s(0)) and K A, where A is a bound of r
/// abs(beta), and N = G + w' s - w^2 c is at least G - K (A + s(0)) s(0) - r w^2. A second K A length^2/2, and 15/16 of
/// G, leave room for the rounding and the tolerance of the series.
template <base::Lane Real, BlockForm form>
[[nodiscard]] auto out_of_reach(const ReachOfStep<Real>& step, const EquationConstants<Real, form>& constants) {
  using base::fused, base::magnitude;
  const Real zero(0.0);
  Real most = magnitude(step.base_amplitude);
  Real radius(1.0);
  if constexpr (form == BlockForm::general) {
    radius = constants.radius;
    most = radius * most;
  }
  const Real rate = magnitude(step.tilt_rate);
  using Truth = decltype(step.tilt < zero);
  const Truth below =
      fused(fused(constants.geared(most), step.length, rate), step.length, step.tilt) < constants.shape_angle;
  const Real acceleration = constants.geared(most + constants.sine);
  const Real fastest = fused(acceleration, step.length, rate);
  Real flattest = -fastest;
  if constexpr (form == BlockForm::general) flattest = flattest * radius;
  const Truth presses =
      zero < fused(flattest, fastest, fused(-acceleration, constants.sine, Real(0.9375) * Real(constants.load)));
  return OutOfReach<Truth>{.past_balance = below, .normal = below && presses};
}

/// Whether a block in full contact stays on both edges: abs(alpha) <= tan(psi_S) (1 + alpha_v), S the sign of alpha.
///
/// Written as w' of rocking, which must be > 0 after a lift. Another form could round to the opposite sign at the
/// threshold, and the block would lift and land endlessly at one instant.
[[nodiscard]] inline bool edges_hold(const BaseMotion& base, const Geometry& block) {
  if (base.horizontal * block.open_side < 0.0) return true;  // pressed against the wall
  const Edge& edge = block.edge(base.horizontal);
  return std::abs(base.horizontal) * edge.cosine <= base.weight * edge.sine;
}

/// Whether kinetic friction turns a sliding block over its leading edge: mu_k > tan(psi_S), written as w' of rock-slide.
[[nodiscard]] inline bool friction_tips(double kinetic_friction, const Edge& leading) {
  return kinetic_friction * leading.cosine > leading.sine;
}

/// How a rocking block moves at an instant, seen from its side: one motion or a pack.
template <base::Number Real>
struct EdgeMotion {
  base::SinCos<Real> edge;  ///< its levers s and c
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
template <base::Number Real, class Constants>
[[nodiscard]] inline SideForces<Real> forces_without_slip(const EdgeMotion<Real>& now, const Constants& constants) {
  using base::fused;
  const auto& [s, c] = now.edge;
  const Real rate = constants.geared(now.beta * c - now.weight * s);
  const Real load(constants.load);
  return {.normal = load * now.weight + fused(rate, s, -(now.omega * (now.omega * c))),
          .friction = load * now.beta - fused(rate, c, now.omega * (now.omega * s)),
          .acceleration = rate};
}

/// Whether friction of at most `coefficient` times N is enough for these forces; N > 0.
template <base::Lane Real>
[[nodiscard]] inline auto friction_is_enough(const SideForces<Real>& forces, const Real& coefficient) {
  using base::magnitude;
  return base::at_most(magnitude(forces.friction), coefficient * forces.normal);
}

/// Forces of rocking without slip, of a state.
template <BlockForm form>
[[nodiscard]] inline Forces rocking_forces(const State& state, const BaseMotion& base,
                                           const EquationConstants<double, form>& constants) {
  const auto [normal, friction, acceleration] = forces_without_slip<double>({.edge = edge_angle(state, constants),
                                                                             .omega = state.side * state.tilt_rate,
                                                                             .beta = state.side * base.horizontal,
                                                                             .weight = base.weight},
                                                                            constants);
  return {.normal = normal, .friction = state.side * friction, .acceleration = state.side * acceleration};
}

/// Rates of change while rocking with slip, and the normal force that goes with them.
struct SlippingRates {
  double tilt_acceleration;  ///< w' = -(G g - w^2 c) q/D
  double slip_acceleration;  ///< V' = -G alpha - s mu_k N + w' c + S w^2 s
  double normal;             ///< N = J (G g - w^2 c)/D
};

/// The rates of a state: bit for bit the first coefficients of the series that `expand_rock_slide` computes.
template <BlockForm form>
[[nodiscard]] inline SlippingRates slipping_rates(const State& state, const BaseMotion& base, double kinetic_friction,
                                                  const EquationConstants<double, form>& constants) {
  const auto [s, c] = edge_angle(state, constants);
  const double omega = state.side * state.tilt_rate;
  const double drag = state.side * state.slip_direction * kinetic_friction;
  const double arm = std::fma(drag, c, s);
  const double load = constants.load * base.weight - omega * (omega * c);
  const double rate = load * arm * (-1.0 / std::fma(s, arm, constants.inertia));
  const double normal = std::fma(rate, s, load);
  const double force = std::fma(drag, normal, constants.load * (state.side * base.horizontal));
  return {.tilt_acceleration = state.side * rate,
          .slip_acceleration = state.side * (std::fma(rate, c, omega * (omega * s)) - force),
          .normal = normal};
}

}  // namespace rocking::dynamics
