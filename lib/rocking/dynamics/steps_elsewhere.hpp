#pragma once

#include <cstdint>

#include "rocking/dynamics/motion_course.hpp"

namespace rocking::dynamics {

/// The end of steps without events that the lanes have computed instead of the motion.
struct StepsElsewhere {
  State state;
  Instant now;
  std::uint64_t count;
  std::int64_t since_strobe;  ///< steps since the last strobe point
};

/// Continues at the end of such steps. At the start of each, nothing was known but the state.
template <CoefficientSource Coefficients>
inline void take_over(MotionCourse<Coefficients>& course, const StepsElsewhere& steps) {
  MotionProgress& progress = course.progress;
  course.context.state = steps.state;
  course.context.clock.set(steps.now);
  progress.strobes.set_steps_since_last(steps.since_strobe);
  progress.count_segments(course.context.excitation, steps.count);
  if (steps.count == 0) return;
  progress.count_slip_steps(course.context, steps.count);
  progress.continuity = Continuity::after_a_step();
}

/// After take_over: those steps have ended with an impact, which does no more than change_edges.
template <CoefficientSource Coefficients>
inline void rebound(MotionCourse<Coefficients>& course, double tilt_rate) {
  change_edges(course.context, tilt_rate);
  course.progress.settle(course.context);
}

}  // namespace rocking::dynamics
