#pragma once

#include "rocking/dynamics/guards.hpp"
#include "rocking/dynamics/motion_course.hpp"
#include "rocking/dynamics/motion_series.hpp"

/// What is decided once at the start of a step, from its series and length.
namespace rocking::dynamics {

/// Whether D can vanish while the block rocks and slips.
template <CoefficientSource Coefficients>
[[nodiscard]] inline bool nears_painleve(const MotionCourse<Coefficients>& course) {
  return course.context.state.contact == ContactState::rock_slide &&
         determinant_may_vanish(course.context.setting, course.progress.kinetic_friction());
}

/// Guards that a step of this length cannot reach.
template <CoefficientSource Coefficients>
[[nodiscard]] inline OutOfReach<bool> guards_out_of_reach(MotionCourse<Coefficients>& course, double length) {
  MotionContext<Coefficients>& context = course.context;
  const State& state = context.state;
  const bool may_hop = course.automaton.is_off_ground() || context.known.normal_is_zero;
  const bool is_excluded = state.contact != ContactState::rock || course.automaton.was_past_balance() || may_hop;
  if (is_excluded || context.excitation.has_vertical()) return {};
  const ReachOfStep<double> step{.tilt = state.side * state.tilt,
                                 .tilt_rate = state.side * state.tilt_rate,
                                 .base_amplitude = context.excitation.most_horizontal(context.base_amplitude()),
                                 .length = length};
  return with_constants(context.setting, state.side,
                        [&](const auto& constants) { return out_of_reach<double>(step, constants); });
}

/// A reset makes the forces jump: whether the block still presses on the base, and the equations still have a solution.
/// `rows`: the series of the step after it.
template <CoefficientSource Coefficients>
inline void check_validity(MotionCourse<Coefficients>& course, const MotionSeries<double>& rows) {
  MotionContext<Coefficients>& context = course.context;
  if (nears_painleve(course)) {
    const double determinant = context.setting.inertia + rows.sine[0] * rows.arm[0];
    if (determinant <= 0.0) context.end(Termination::painleve);
  }
  if (context.known.normal_is_zero) return;
  // In full contact N = G (1 + alpha_v).
  const bool has_no_weight = context.excitation.has_vertical() && rows.weight[0] <= 0.0;
  const bool rocks = is_rocking(context.state.contact);
  course.automaton.set_off_ground(context, rocks ? rows.normal[0] <= 0.0 : has_no_weight);
}

/// The series does not continue the motion: it diverges near D = 0, or a number in it is not finite.
template <CoefficientSource Coefficients>
inline void end_without_step(MotionCourse<Coefficients>& course) {
  course.context.end(nears_painleve(course) ? Termination::painleve : Termination::stopped);
}

}  // namespace rocking::dynamics
