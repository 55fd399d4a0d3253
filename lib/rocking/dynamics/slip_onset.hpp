#pragma once

#include "rocking/dynamics/contact_rules.hpp"

/// How slip starts: from rest, from rocking, and where friction and the equations contradict each other.
namespace rocking::dynamics {

/// Full contact: friction is exhausted. `push`: sign of the base acceleration; `at_threshold`: see leave_full_contact.
template <CoefficientSource Coefficients>
inline void start_sliding(MotionContext<Coefficients>& context, double push, bool at_threshold, bool was_sliding) {
  context.state.contact = ContactState::slide;
  context.state.slip_direction = -push;
  // abs(alpha) >= mu_k (1 + alpha_v) up to rounding at the threshold. Where 1 + alpha_v = 0 no force acts.
  const double alpha = context.base_acceleration();
  const bool lags = push * alpha <= context.kinetic_friction() * context.weight();
  context.known.slip_is_flat = lags || (at_threshold && (kinetic_equals_static(context) || alpha == 0.0));
  context.record(was_sliding ? EventKind::slip_reverse : EventKind::slide_start);
}

/// The block sticks although friction does not suffice; see start_slipping.
template <CoefficientSource Coefficients>
inline void stick_beyond_friction(MotionContext<Coefficients>& context) {
  context.known.sticks_beyond_friction = true;
  ++context.contradictions;
}

/// Rocking: friction is exhausted; the block starts to slip in `direction`. `at_threshold`: found as a root.
///
/// Where the slip would be reversed at once, no motion agrees with the equations (this occurs with the inertia about
/// the edge): the block sticks, and friction is not tested again before the next event.
template <CoefficientSource Coefficients>
inline void start_slipping(MotionContext<Coefficients>& context, double direction, bool at_threshold) {
  State& state = context.state;
  const bool is_full_contact = state.tilt == 0.0 && state.tilt_rate == 0.0;
  if (is_full_contact && !kinetic_friction_tips(context, direction)) {
    return start_sliding(context, -direction, at_threshold, false);
  }
  // With the centroidal inertia s V' >= c (abs(F) - mu_s N) for some c > 0: a value that is not > 0 is 0 up to
  // rounding.
  const bool lasts = slip_would_last(context, direction);
  const bool starts_flat =
      is_centroidal(context.setting) && (!lasts || (at_threshold && kinetic_equals_static(context)));
  if (!starts_flat && !lasts) return stick_beyond_friction(context);
  state.contact = ContactState::rock_slide;
  state.slip_direction = direction;
  context.known.slip_is_flat = starts_flat;
  context.record(EventKind::slip_start);
}

/// N of a block that sticks beyond friction has fallen to 0. If slip keeps the block on the base, it slips from now on
/// and the result is true.
template <CoefficientSource Coefficients>
[[nodiscard]] inline bool slips_rather_than_lose_contact(MotionContext<Coefficients>& context) {
  if (context.state.contact != ContactState::rock || !context.coefficients.has_friction()) return false;
  const double direction = -sign(sticking_forces(context).friction);
  if (!slip_keeps_contact(context, direction)) return false;
  start_slipping(context, direction, false);
  return true;
}

}  // namespace rocking::dynamics
