#pragma once

#include <cmath>

#include "rocking/dynamics/contact_changes.hpp"
#include "rocking/dynamics/peaks.hpp"

/// What follows where the slip rate becomes 0.
namespace rocking::dynamics {

/// V may have changed its sign: abs(X) is largest where it does, or at the end of the motion.
template <CoefficientSource Coefficients>
inline void note_slip(MotionContext<Coefficients>& context) {
  context.peaks.slip = peaks::larger(context.peaks.slip, std::abs(context.state.slip));
}

/// V of a block in full contact has become 0.
template <CoefficientSource Coefficients>
inline void stop_sliding(MotionContext<Coefficients>& context) {
  if (!full_contact_holds(context)) return leave_full_contact(context, sign(context.base_acceleration()), false);
  context.state.contact = ContactState::rest;
  context.record(EventKind::slide_stop);
}

/// V has become 0.
template <CoefficientSource Coefficients>
inline void stop_slipping(MotionContext<Coefficients>& context) {
  State& state = context.state;
  state.slip_rate = 0.0;
  note_slip(context);
  context.coefficients.stop();
  if (state.contact == ContactState::slide) return stop_sliding(context);
  const Forces forces = sticking_forces(context);
  const double direction = -sign(forces.friction);
  if (!friction_holds(context, forces) && slip_would_last(context, direction)) {
    state.slip_direction = direction;
    context.record(EventKind::slip_reverse);
    return;
  }
  if (!friction_holds(context, forces)) {
    if (is_centroidal(context.setting)) {
      context.known.limit_sign = -state.side * direction;
    } else {
      stick_beyond_friction(context);
    }
  }
  state.contact = ContactState::rock;
  context.record(EventKind::slip_stop);
}

}  // namespace rocking::dynamics
