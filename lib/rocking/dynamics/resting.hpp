#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "rocking/dynamics/motion_course.hpp"

/// Steps in which a block at rest stays so, since the base acceleration between two samples of a ground motion is far
/// below its threshold. They have the effects of other steps.
namespace rocking::dynamics {

/// A base acceleration, over g, below which a block at rest certainly stays so. The margin is far above the rounding of
/// the base acceleration between two samples.
template <CoefficientSource Coefficients>
[[nodiscard]] inline double threshold_at_rest(const MotionContext<Coefficients>& context) {
  constexpr double margin = 1e-6;
  return (1.0 - margin) *
         std::min(context.coefficients.static_friction(), context.setting.block.tangent);  // of the nearer edge
}

/// Whether one step leads to the next breakpoint and a block at rest certainly stays so until then.
template <CoefficientSource Coefficients>
[[nodiscard]] inline bool stays_at_rest(MotionCourse<Coefficients>& course) {
  MotionContext<Coefficients>& context = course.context;
  const Clock& clock = context.clock;
  if (context.state.contact != ContactState::rest || context.ended() || !course.progress.breakpoint()) return false;
  const double reach = course.progress.time_to_breakpoint(clock);
  if (!(reach > clock.resolution()) || reach > clock.period_length()) return false;
  return context.excitation.largest_before_change(clock, context.base_amplitude()) < threshold_at_rest(context);
}

template <CoefficientSource Coefficients>
inline void arrive_at_rest(MotionCourse<Coefficients>& course, const Instant& instant, Contact contact) {
  course.context.clock.set(instant);
  course.context.known = {};
  course.progress.continuity = Continuity::after_a_step();
  pass_breakpoints(course, contact);
}

/// A step up to the next breakpoint.
template <CoefficientSource Coefficients>
inline void rest_until_breakpoint(MotionCourse<Coefficients>& course) {
  MotionContext<Coefficients>& context = course.context;
  MotionProgress& progress = course.progress;
  begin_step(course);
  const double last_strobe = progress.time_to_breakpoint(context.clock) - context.clock.resolution();
  while (!context.ended() && progress.time_to_strobe(context.clock) < last_strobe) {
    progress.pass_strobe(context, context.state);
  }
  if (context.ended()) return;
  // The base acceleration may jump there.
  arrive_at_rest(course, *progress.breakpoint(), Contact::to_be_checked);
}

/// As many steps as there are samples, none of which the block leaves full contact at or passes a strobe instant
/// before.
template <CoefficientSource Coefficients>
inline void rest_over(MotionCourse<Coefficients>& course, const SamplesPassed& samples) {
  StrobeSchedule& strobes = course.progress.strobes;
  strobes.set_steps_since_last(strobes.steps_since_last() + static_cast<std::int64_t>(samples.count));
  course.progress.count_segments(course.context.excitation, samples.count);
  arrive_at_rest(course, samples.last, Contact::stays);
}

/// Makes the coming steps of this kind; returns their number.
template <CoefficientSource Coefficients>
inline std::uint64_t rest_below_threshold(MotionCourse<Coefficients>& course) {
  MotionContext<Coefficients>& context = course.context;
  std::uint64_t steps = 0;
  while (stays_at_rest(course)) {
    const SamplesPassed samples = context.excitation.samples_below(threshold_at_rest(context), context.base_amplitude(),
                                                                   course.progress.next_interruption(context),
                                                                   course.progress.steps_left(), context.clock);
    if (samples.count > 0) {
      rest_over(course, samples);
    } else {
      rest_until_breakpoint(course);
    }
    steps += std::max<std::size_t>(1, samples.count);
  }
  return steps;
}

}  // namespace rocking::dynamics
