#pragma once

#include <cstdint>

#include "rocking/dynamics/automaton.hpp"
#include "rocking/dynamics/motion_context.hpp"
#include "rocking/dynamics/motion_progress.hpp"

namespace rocking::dynamics {

/// A motion without the series of its coming step. The functions below are the parts of what follows from a step; they
/// compute none.
template <CoefficientSource Coefficients>
struct MotionCourse {
  MotionContext<Coefficients> context;
  Automaton automaton;
  MotionProgress progress;
};

/// Whether the contact state may have to change at a breakpoint.
enum class Contact : std::uint8_t { stays, to_be_checked };

/// One step begins: counts it and the piece of the ground motion that it expands.
template <CoefficientSource Coefficients>
inline void begin_step(MotionCourse<Coefficients>& course) {
  course.progress.count_step(course.context);
  course.progress.count_segments(course.context.excitation, 1);
}

/// The step ends `duration` later in the state `next`.
template <CoefficientSource Coefficients>
inline void end_step(MotionCourse<Coefficients>& course, double duration, const State& next) {
  MotionContext<Coefficients>& context = course.context;
  if (!(duration > 0.0)) return course.progress.stand_still(context);
  context.state = next;
  context.clock.advance(duration);
  course.progress.continuity = Continuity::after_a_step();
  context.known = context.known.after_a_step();
  course.automaton.note_balance(context);
}

/// What follows at the end of a step. `fired` is indexed by Guard.
template <CoefficientSource Coefficients, class Fired>
inline void reset(MotionCourse<Coefficients>& course, const Fired& fired, bool at_breakpoint) {
  if (fired.none() && !at_breakpoint) return;
  course.context.known = {};
  if (at_breakpoint) course.context.clock.set(*course.progress.breakpoint());
  course.automaton.respond(course.context, Firing<Fired>{.fired = fired,
                                                         .at_breakpoint = at_breakpoint,
                                                         .time_went_on = course.progress.continuity.time_went_on()});
  course.progress.settle(course.context);
}

/// After steps that have passed breakpoints.
template <CoefficientSource Coefficients>
inline void pass_breakpoints(MotionCourse<Coefficients>& course, Contact contact) {
  if (contact == Contact::to_be_checked) check_contact(course.context);
  course.progress.settle(course.context);
}

/// Continues for `more` strobe points under other circumstances, in the same state.
template <CoefficientSource Coefficients>
inline void go_on_under(MotionCourse<Coefficients>& course, const Setting& setting, const Clock& clock,
                        const Coefficients& coefficients, const Excitation& excitation, std::int64_t more) {
  course.context.replace(setting, clock, coefficients, excitation);
  course.context.find_cell();
  course.progress.strobes.extend(more);
  course.context.go_on();
  pass_breakpoints(course, Contact::to_be_checked);
}

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
