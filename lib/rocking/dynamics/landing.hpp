#pragma once

#include "rocking/dynamics/contact_changes.hpp"
#include "rocking/dynamics/impact.hpp"
#include "rocking/dynamics/slip_end.hpp"
#include "rocking/dynamics/small_hop.hpp"

/// What happens when theta becomes 0: the impact, the end of a chatter, the contact state afterwards.
namespace rocking::dynamics {

template <CoefficientSource Coefficients>
[[nodiscard]] inline ImpactOutcome impact_with_friction(MotionContext<Coefficients>& context, double restitution) {
  const Setting& setting = context.setting;
  const ImpactConditions before{.tilt_rate = context.state.tilt_rate,
                                .slip_rate = context.state.slip_rate,
                                .restitution = restitution,
                                .static_friction = context.coefficients.static_friction()};
  const auto sticks = sticking_impact(before, setting.block, setting.impact_slip_rule);
  return sticks ? *sticks : slipping_impact(before, context.kinetic_friction(), setting.block);
}

/// The impulse. False if the model has no answer.
template <CoefficientSource Coefficients>
[[nodiscard]] inline bool apply_impulse(MotionContext<Coefficients>& context) {
  State& state = context.state;
  const double restitution = context.coefficients.restitution(state.tilt_rate);
  ImpactKind kind = ImpactKind::stick;
  if (context.coefficients.has_friction()) {
    const ImpactOutcome after = impact_with_friction(context, restitution);
    if (after.kind == ImpactKind::painleve) {
      context.end(Termination::painleve);
      return false;
    }
    kind = after.kind;
    state.tilt_rate = after.tilt_rate;
    state.slip_rate = after.slip_rate;
  } else {
    const double before = state.tilt_rate;
    state.tilt_rate = sticking_tilt_rate({.tilt_rate = before, .slip_rate = 0.0}, restitution, context.setting.block);
    const double open_side = context.setting.block.open_side;  // at a wall a ratio of 0 is one of some roundings
    if (open_side * state.tilt_rate < 0x1p-48 * std::abs(open_side * before)) state.tilt_rate = 0.0;
  }
  if (state.tilt_rate != 0.0) state.side = sign(state.tilt_rate);
  if (state.slip_rate != 0.0) state.slip_direction = sign(state.slip_rate);
  context.record(kind == ImpactKind::stick ? EventKind::impact_stick : EventKind::impact_slip);
  return true;
}

template <CoefficientSource Coefficients>
inline void end_chatter(MotionContext<Coefficients>& context) {
  State& state = context.state;
  context.coefficients.chatter_ended();
  state.tilt_rate = 0.0;
  if (state.slip_rate != 0.0) {
    state.contact = ContactState::slide;
    context.record(EventKind::to_slide);
    return check_tipping(context);
  }
  state.contact = ContactState::rest;
  context.record(EventKind::to_rest);
  check_full_contact(context);
}

/// theta has become 0. `slip_ended`: V has become 0 at the same instant.
template <CoefficientSource Coefficients>
inline void land(MotionContext<Coefficients>& context, bool slip_ended) {
  State& state = context.state;
  state.tilt = 0.0;
  note_slip(context);
  if (slip_ended) state.slip_rate = 0.0;
  bool is_stop = slip_ended;
  const double side_before = state.side;
  if (state.side * state.tilt_rate < 0.0) {
    const double slip_before = state.slip_rate;
    if (!apply_impulse(context)) return;
    is_stop = is_stop || (slip_before != 0.0 && state.slip_rate == 0.0);
  } else {
    state.tilt_rate = 0.0;  // a touch: no impulse
  }
  if (is_stop) context.coefficients.stop();
  if (hop_is_too_small(context, state.side == side_before)) return end_chatter(context);
  if (state.tilt_rate == 0.0 && state.slip_rate == 0.0) {
    return leave_full_contact(context, sign(context.base_acceleration()), false);
  }
  state.contact = state.slip_rate == 0.0 ? ContactState::rock : ContactState::rock_slide;
  check_contact(context);
}

/// A sticking impact after which the block rocks about its other edge at `tilt_rate`: what `land` does where the caller
/// has shown that the impact sticks, that no chatter ends and that friction holds afterwards.
template <CoefficientSource Coefficients>
inline void change_edges(MotionContext<Coefficients>& context, double tilt_rate) {
  context.state.tilt = 0.0;
  context.state.tilt_rate = tilt_rate;
  context.state.side = sign(tilt_rate);
  context.record(EventKind::impact_stick);
}

}  // namespace rocking::dynamics
