#pragma once

#include "rocking/base/jet.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/impact.hpp"
#include "rocking/dynamics/sticking_impulse.hpp"
#include "rocking/dynamics/tangent.hpp"

/// What the saltation matrix of an event is made of.
///
///     S = DzR + (f+ - DzR f-) (grad g)^T/(grad g . f- + dg/dtau)
///
/// with the guard g, the reset R (which does not depend on time), and the rates f- before and f+ after the event.
/// Applied to a tangent vector dz in two parts: the event is later by dtau = -(grad g . dz)/(grad g . f- + dg/dtau), so
/// that the state at the event changes by dz + f- dtau; this change passes the reset; and f+ dtau is subtracted. The
/// second part can wait until the contact state is decided in which time goes on.
/// Source: Leine & Nijmeijer (2004), Dynamics and Bifurcations of Non-smooth Mechanical Systems, section 7.
namespace rocking::dynamics {

/// dz/dtau of a state.
[[nodiscard]] inline Tangent<double> rates_of(const State& state, const BaseMotion& base, double kinetic_friction,
                                              const AnyConstants& constants) {
  switch (state.contact) {
    case ContactState::rest:
    case ContactState::overturned: return {};
    case ContactState::slide: {
      const double drag = state.slip_direction * kinetic_friction;
      return {.slip = state.slip_rate, .slip_rate = -constants.load * (base.horizontal + drag * base.weight)};
    }
    case ContactState::rock:
      return {.tilt = state.tilt_rate, .tilt_rate = rocking_forces(state, base, constants).acceleration};
    case ContactState::rock_slide: break;
  }
  const SlippingRates rates = slipping_rates(state, base, kinetic_friction, constants);
  return {.tilt = state.tilt_rate,
          .tilt_rate = rates.tilt_acceleration,
          .slip = state.slip_rate,
          .slip_rate = rates.slip_acceleration};
}

/// A guard at the instant at which it becomes 0.
struct GuardSlope {
  Tangent<double> gradient;  ///< grad g
  double rate;               ///< grad g . f- + dg/dtau

  /// By how much the guard is reached later after this change of the state. A guard that does not depend on X ignores
  /// the part along X, which may have left the range of numbers.
  [[nodiscard]] double delay(const Tangent<double>& change) const {
    double rise = gradient.tilt * change.tilt + gradient.tilt_rate * change.tilt_rate;
    if (gradient.slip != 0.0) rise += gradient.slip * change.slip;
    return -(rise + gradient.slip_rate * change.slip_rate) / rate;
  }
};

/// Base accelerations over g and their rates of change.
struct MovingBase {
  BaseMotion now;
  BaseMotion slope;
};

/// g = by_normal N + by_friction S F of a block that rocks without slip. N and S F are those of forces_without_slip,
/// evaluated with dual numbers.
[[nodiscard]] inline GuardSlope slope_of_forces(const State& state, const MovingBase& base,
                                                const AnyConstants& constants, double by_normal, double by_friction) {
  const base::SinCos<double> angle = edge_angle(state, constants);
  const double omega = state.side * state.tilt_rate;
  struct Direction {
    double tilt = 0.0, omega = 0.0, beta = 0.0, weight = 0.0;
  };
  const auto forces_along = [&](const Direction& d) {  // phi = psi - S theta
    return forces_without_slip<base::Dual>(
        {.edge = {{angle.sine, -angle.cosine * d.tilt}, {angle.cosine, angle.sine * d.tilt}},
         .omega = {omega, d.omega},
         .beta = {state.side * base.now.horizontal, d.beta},
         .weight = {base.now.weight, d.weight}},
        constants);
  };
  const auto slope = [&](const Direction& d) {
    const auto forces = forces_along(d);
    return by_normal * forces.normal.slope + by_friction * forces.friction.slope;
  };
  const double acceleration = forces_along({}).acceleration.value;
  return {.gradient = {.tilt = state.side * slope({.tilt = 1.0}), .tilt_rate = state.side * slope({.omega = 1.0})},
          .rate = slope({.tilt = omega,
                         .omega = acceleration,
                         .beta = state.side * base.slope.horizontal,
                         .weight = base.slope.weight})};
}

/// g = w^2 c - G g of a block that rocks with these rates.
[[nodiscard]] inline GuardSlope slope_of_pressing(const State& state, const MovingBase& base,
                                                  const AnyConstants& constants, const Tangent<double>& rates) {
  const auto [sine, cosine] = edge_angle(state, constants);
  const double rate = state.tilt_rate;
  const Tangent<double> gradient{.tilt = state.side * rate * rate * sine, .tilt_rate = 2.0 * rate * cosine};
  return {
      .gradient = gradient,
      .rate = gradient.tilt * rates.tilt + gradient.tilt_rate * rates.tilt_rate - constants.load * base.slope.weight};
}

/// Derivative of the rates after an impact with respect to the rates before it: w2 and V2 by w1 and V1. An impact is
/// linear in them as long as it slips in the same direction, or sticks.
struct ImpactDerivative {
  double tilt_rate_by_tilt_rate;
  double tilt_rate_by_slip_rate;
  double slip_rate_by_tilt_rate;
  double slip_rate_by_slip_rate;
};

/// Of sticking_impact.
[[nodiscard]] inline ImpactDerivative sticking_derivative(double restitution, const Edge& landing) {
  return {.tilt_rate_by_tilt_rate = 1.0 - impact_loss(restitution, landing),
          .tilt_rate_by_slip_rate = -0.5 * landing.impact_gain * landing.cosine,
          .slip_rate_by_tilt_rate = 0.0,
          .slip_rate_by_slip_rate = 0.0};
}

/// Of slipping_impact that has a solution.
[[nodiscard]] inline ImpactDerivative slipping_derivative(const ImpactConditions& before, double kinetic_friction,
                                                          const Geometry& block) {
  const auto edge = landing_edge(before.restitution, block.edge(before.tilt_rate));
  const LandingRates<double> rates{.tilt_rate = before.tilt_rate, .slip_rate = before.slip_rate};
  const double direction = sticking_impulse(rates, edge).horizontal > 0.0 ? -1.0 : 1.0;
  const double along = before.tilt_rate < 0.0 ? -1.0 : 1.0;
  const double friction = direction * kinetic_friction;
  const double ratio = slipping_rate_ratio(edge, along * friction, block).value_or(1.0);
  const double impulse = edge.sine * (edge.rebound() + ratio) * along;
  return {.tilt_rate_by_tilt_rate = ratio,
          .tilt_rate_by_slip_rate = 0.0,
          .slip_rate_by_tilt_rate = edge.cosine * (ratio - 1.0) - friction * impulse,
          .slip_rate_by_slip_rate = 1.0};
}

}  // namespace rocking::dynamics
