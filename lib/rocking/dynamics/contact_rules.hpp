#pragma once

#include <cmath>

#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/motion_context.hpp"
#include "rocking/dynamics/setting.hpp"

/// Which contact states the forces of an instant allow. These functions change no state; the changes are in
/// slip_onset.hpp, contact_changes.hpp, slip_end.hpp and landing.hpp. Every rule is in lib/docs/model.md, section 3.
namespace rocking::dynamics {

[[nodiscard]] inline double sign(double value) { return value < 0.0 ? -1.0 : 1.0; }

[[nodiscard]] inline bool is_centroidal(const Setting& setting) { return setting.inertia == setting.block.inertia; }

/// Whether D can vanish at some tilt on one of the sides: the smallest D over all phi is J + r^2/2 - (r^2/2) sqrt(1 +
/// mu_k^2).
[[nodiscard]] inline bool determinant_may_vanish(const Setting& setting, double kinetic_friction) {
  const double limit = 2.0 * setting.inertia * setting.block.over_square + 1.0;
  return 1.0 + kinetic_friction * kinetic_friction >= limit * limit;
}

template <CoefficientSource Coefficients>
[[nodiscard]] inline bool kinetic_equals_static(MotionContext<Coefficients>& context) {
  return context.kinetic_friction() == context.coefficients.static_friction();
}

/// Forces of rocking without slip.
template <CoefficientSource Coefficients>
[[nodiscard]] inline Forces sticking_forces(MotionContext<Coefficients>& context) {
  const BaseMotion base = context.base_motion();
  return with_constants(context.setting, context.state.side,
                        [&](const auto& constants) { return rocking_forces(context.state, base, constants); });
}

/// Rates of slip in `direction`.
template <CoefficientSource Coefficients>
[[nodiscard]] inline SlippingRates rates_of_slip(MotionContext<Coefficients>& context, double direction) {
  State slipping = context.state;
  slipping.slip_direction = direction;
  const BaseMotion base = context.base_motion();
  const double mu_k = context.kinetic_friction();
  return with_constants(context.setting, slipping.side,
                        [&](const auto& constants) { return slipping_rates(slipping, base, mu_k, constants); });
}

/// Whether slip that starts from V = 0 in `direction` is accelerated in that direction.
template <CoefficientSource Coefficients>
[[nodiscard]] inline bool slip_would_last(MotionContext<Coefficients>& context, double direction) {
  return direction * rates_of_slip(context, direction).slip_acceleration > 0.0;
}

/// The same, with N > 0.
template <CoefficientSource Coefficients>
[[nodiscard]] inline bool slip_keeps_contact(MotionContext<Coefficients>& context, double direction) {
  const SlippingRates rates = rates_of_slip(context, direction);
  return rates.normal > 0.0 && direction * rates.slip_acceleration > 0.0;
}

/// Whether a rocking block sticks, given the forces that sticking needs. Where sticking needs N <= 0, the block sticks
/// unless slip keeps it on the base.
template <CoefficientSource Coefficients>
[[nodiscard]] inline bool friction_holds(MotionContext<Coefficients>& context, const Forces& forces) {
  if (forces.normal <= 0.0) return !slip_keeps_contact(context, -sign(forces.friction));
  return std::abs(forces.friction) <= context.coefficients.static_friction() * forces.normal;
}

/// Whether a block in full contact stays at rest.
template <CoefficientSource Coefficients>
[[nodiscard]] inline bool full_contact_holds(MotionContext<Coefficients>& context) {
  const BaseMotion base = context.base_motion();
  const Geometry& block = context.setting.block;
  const double mu_s = context.coefficients.static_friction();
  return mu_s <= block.edge(base.horizontal).tangent ? std::abs(base.horizontal) <= mu_s * base.weight
                                                     : edges_hold(base, block);
}

template <CoefficientSource Coefficients>
[[nodiscard]] inline bool friction_is_above_tangent(MotionContext<Coefficients>& context, double slip_direction) {
  return friction_tips(context.kinetic_friction(), context.setting.block.edge(-slip_direction));
}

/// Whether kinetic friction turns a block that slides in this direction over its leading edge, that of side S = -s. It has
/// no torque where N = G (1 + alpha_v) <= 0.
template <CoefficientSource Coefficients>
[[nodiscard]] inline bool kinetic_friction_tips(MotionContext<Coefficients>& context, double slip_direction) {
  return friction_is_above_tangent(context, slip_direction) && context.weight() > 0.0;
}

}  // namespace rocking::dynamics
