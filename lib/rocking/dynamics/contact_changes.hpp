#pragma once

#include "rocking/dynamics/contact_rules.hpp"
#include "rocking/dynamics/slip_onset.hpp"

/// The contact state of a start, and what follows where a contact state cannot stay, since friction or the base
/// acceleration has changed.
namespace rocking::dynamics {

/// Full contact cannot hold. `push`: sign of the base acceleration; `at_threshold`: found as a root, so that nothing
/// is compared again and the accelerations that vanish at the threshold are exactly 0.
template <CoefficientSource Coefficients>
inline void leave_full_contact(MotionContext<Coefficients>& context, double push, bool at_threshold) {
  State& state = context.state;
  const bool was_sliding = state.contact == ContactState::slide;
  const double open_side = context.setting.block.open_side;
  state.slip_rate = 0.0;
  state.side = open_side != 0.0 ? open_side : push;
  const Forces forces = sticking_forces(context);
  if (context.coefficients.has_friction()) {
    const double mu_s = context.coefficients.static_friction();
    if (mu_s <= context.setting.block.edge(push).tangent)
      return start_sliding(context, push, at_threshold, was_sliding);
    if (!friction_holds(context, forces)) {
      if (!kinetic_friction_tips(context, -push)) return start_sliding(context, push, at_threshold, was_sliding);
      state.contact = ContactState::rock;
      context.record(EventKind::lift);
      return start_slipping(context, -sign(forces.friction), false);
    }
  }
  state.contact = ContactState::rock;
  context.known.lift_is_flat = at_threshold || forces.acceleration == 0.0;
  context.record(EventKind::lift);
}

template <CoefficientSource Coefficients>
inline void check_full_contact(MotionContext<Coefficients>& context) {
  if (!full_contact_holds(context)) leave_full_contact(context, sign(context.base_acceleration()), false);
}

/// A sliding block turns over its leading edge.
template <CoefficientSource Coefficients>
inline void tip(MotionContext<Coefficients>& context) {
  context.state.side = -context.state.slip_direction;
  context.state.contact = ContactState::rock_slide;
  context.record(EventKind::tip);
}

template <CoefficientSource Coefficients>
inline void check_tipping(MotionContext<Coefficients>& context) {
  if (kinetic_friction_tips(context, context.state.slip_direction)) tip(context);
}

/// A rocking block without slip: whether friction suffices.
template <CoefficientSource Coefficients>
inline void check_friction(MotionContext<Coefficients>& context) {
  if (!context.coefficients.has_friction()) return;
  const Forces forces = sticking_forces(context);
  if (!friction_holds(context, forces)) start_slipping(context, -sign(forces.friction), false);
}

/// Leaves the contact state if it cannot stay: after the start, and wherever friction or the base acceleration jumps.
template <CoefficientSource Coefficients>
inline void check_contact(MotionContext<Coefficients>& context) {
  switch (context.state.contact) {
    case ContactState::rest: return check_full_contact(context);
    case ContactState::slide: return check_tipping(context);
    case ContactState::rock: return check_friction(context);
    case ContactState::rock_slide:
    case ContactState::overturned: return;
  }
}

/// Starts in this state; the contact state follows from the others.
template <CoefficientSource Coefficients>
inline void enter(MotionContext<Coefficients>& context, const State& initial) {
  State& state = context.state;
  state = initial;
  context.find_cell();
  context.peaks.slip = peaks::larger(context.peaks.slip, std::abs(state.slip));
  const bool flat = state.tilt == 0.0 && state.tilt_rate == 0.0;
  state.slip_direction = sign(state.slip_rate);
  state.side = sign(state.tilt != 0.0 ? state.tilt : state.tilt_rate);
  const bool slips = state.slip_rate != 0.0;
  state.contact = flat ? (slips ? ContactState::slide : ContactState::rest)
                       : (slips ? ContactState::rock_slide : ContactState::rock);
  check_contact(context);
}

/// N has risen through 0. A sliding block whose friction exceeds tan(psi) tips now; at the threshold its w' is exactly
/// 0.
template <CoefficientSource Coefficients>
inline void press_again(MotionContext<Coefficients>& context) {
  const State& state = context.state;
  if (state.contact != ContactState::slide || !friction_is_above_tangent(context, state.slip_direction)) return;
  tip(context);
  context.known.lift_is_flat = true;
}

}  // namespace rocking::dynamics
