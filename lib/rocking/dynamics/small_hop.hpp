#pragma once

#include <algorithm>
#include <cmath>

#include "rocking/dynamics/contact_rules.hpp"

/// When the hop after an impact is so small that the chatter ends with it.
namespace rocking::dynamics {

/// Durations of a hop, and heights over psi, up to which it is too small.
template <CoefficientSource Coefficients>
[[nodiscard]] inline double hop_limit(const MotionContext<Coefficients>& context) {
  return std::max(context.setting.tolerance, context.clock.resolution());
}

/// A hop without slip whose initial rate exceeds this bound is not too small, from the bound of abs(w'). It is below
/// the rate after nearly every impact, and does not need the base acceleration.
template <CoefficientSource Coefficients>
[[nodiscard]] inline double fastest_small_hop(MotionContext<Coefficients>& context) {
  return hop_limit(context) *
         largest_acceleration(context.excitation.most_horizontal(context.base_amplitude()), context.setting.block);
}

/// After an impact: whether the coming hop's duration 2 abs(w)/a and its height w^2/(2a) over psi are both below the
/// tolerance (or the resolution of time), where a is the acceleration that brings the block back. The hops that would
/// follow last abs(delta)/(1 - abs(delta)) times as long in all (with two edges, see lib/docs/model.md), and their energy is w^2/2 over p^2.
///
/// Full contact must be able to hold afterwards, unless every impact sends the block back over the same edge: then it
/// comes to rest before it lifts over the other one.
template <CoefficientSource Coefficients>
[[nodiscard]] inline bool hop_is_too_small(MotionContext<Coefficients>& context, bool over_same_edge) {
  const State& state = context.state;
  const Geometry& block = context.setting.block;
  const double rate = std::abs(state.tilt_rate);
  const bool slips = state.slip_rate != 0.0;
  if (!slips && rate > fastest_small_hop(context)) return false;
  if (slips && !over_same_edge && kinetic_friction_tips(context, state.slip_direction)) return false;
  if (!slips && !over_same_edge && !edges_hold(context.base_motion(), block)) return false;
  const double acceleration =
      slips ? rates_of_slip(context, state.slip_direction).tilt_acceleration : sticking_forces(context).acceleration;
  const double pull = -state.side * acceleration;
  const double limit = hop_limit(context);
  return pull >= 0.0 && 2.0 * rate <= limit * pull &&
         rate * rate <= 2.0 * limit * pull * block.edge(state.side).shape_angle;
}

}  // namespace rocking::dynamics
