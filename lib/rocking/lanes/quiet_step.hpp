#pragma once

#include <cstdint>

#include "rocking/lanes/moving_on.hpp"
#include "rocking/lanes/tangent_step.hpp"

namespace rocking::lanes {
namespace {

/// The end of a step.
template <class Form>
struct QuietStep {
  typename Form::Real steps_since_strobe;
  Point<typename Form::Real> end;
  NextStart<Form> next;
};

/// Whether in the lanes `occupied` nothing happens in the step, whose guards are cleared, but that an interval of the
/// friction grid ends with it.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline bool is_quiet(const LaneAccess<Real>& lanes, const Step<Form>& step, const QuietStep<Form>& quiet,
                                   const typename Form::Truth& occupied) {
  const LaneState& state = lanes.state;
  const Real resolution = lanes.load(state.resolution);
  const Real strobe = step.now.until(lanes.load(state.strobe_period), lanes.load(state.strobe_time));
  const auto strobes = strobe < step.length - resolution;
  auto is_quiet = !strobes && step.presses && is_finite<Form>(quiet.end) &&
                  is_ordinary(step, resolution, quiet.steps_since_strobe) && quiet.next.is_in_period;
  if constexpr (!Form::on_grid) is_quiet = is_quiet && !quiet.next.at_break;
  return bits_of(occupied && !is_quiet) == 0;
}

/// What follows on a step that may be quiet.
enum class QuietStepEnd : std::uint8_t {
  none,  ///< it is not quiet: the lanes have not moved
  to_next_step,
  to_unknown_interval,  ///< in some lanes the next interval of the friction grid must be drawn
};

/// If the step is quiet in all lanes, moves them on. That takes half of the operations of finding and moving the lanes
/// that can move on.
template <class Form, class Real = typename Form::Real>
[[nodiscard, gnu::noinline]] QuietStepEnd pass_quiet_step(const LaneAccess<Real>& lanes, const Step<Form>& step,
                                                          const UnclearedGuards<Form>& guards) {
  if (bits_of(guards.any) != 0) return QuietStepEnd::none;
  LaneState& state = lanes.state;
  const auto every_lane = Real(0.0) == Real(0.0);
  const QuietStep<Form> quiet{.steps_since_strobe = lanes.load(state.steps_since_strobe) + Real(1.0),
                              .end = point<Form>(step.m, step.length),
                              .next = next_start<Form>(lanes, step, step.length, every_lane)};
  if (!is_quiet(lanes, step, quiet, guards.occupied)) return QuietStepEnd::none;
  note_peaks(lanes, step, {step.length, quiet.end.tilt, quiet.end.tilt_rate}, guards.occupied);
  if constexpr (Form::has_tangents) {
    const TangentStep<Form> tangents(lanes, step);
    move_vectors(AllMoving<Real>{lanes}, tangents, tangents.at(step.length));
  }
  lanes.store(state.steps_since_strobe, quiet.steps_since_strobe);
  lanes.store(state.steps, lanes.load(state.steps) + Real(1.0));
  lanes.store(state.tilt, quiet.end.tilt);
  lanes.store(state.tilt_rate, quiet.end.tilt_rate);
  if constexpr (Form::slips) {
    lanes.store(state.slip, quiet.end.slip);
    lanes.store(state.slip_rate, quiet.end.slip_rate);
  }
  lanes.store(state.time, quiet.next.time);
  lanes.store(state.period, quiet.next.period);
  if constexpr (!Form::on_grid) return QuietStepEnd::to_next_step;
  pass_interval(AllMoving<Real>{lanes}, step.now.period_length);
  return lanes_at_unknown_interval(lanes, guards.occupied) == 0 ? QuietStepEnd::to_next_step
                                                                : QuietStepEnd::to_unknown_interval;
}

}  // namespace
}  // namespace rocking::lanes
