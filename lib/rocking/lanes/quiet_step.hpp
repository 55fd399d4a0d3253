#pragma once

#include <cstdint>

#include "rocking/lanes/moving_on.hpp"
#include "rocking/lanes/tangent_step.hpp"

namespace rocking::lanes {
namespace {

/// Of a step on the friction grid.
template <class Form>
struct QuietStep {
  typename Form::Real steps_since_strobe;
  Point<typename Form::Real> end;
  NextStart<Form> next;
};

/// Whether in the lanes `occupied` the step, whose guards are cleared, ends with its interval and nothing else happens in
/// it.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline bool is_quiet(const LaneAccess<Real>& lanes, const Step<Form>& step, const QuietStep<Form>& quiet,
                                   const typename Form::Truth& occupied) {
  const LaneState& state = lanes.state;
  const Real resolution = lanes.load(state.resolution);
  const Real strobe = step.now.until(lanes.load(state.strobe_period), lanes.load(state.strobe_time));
  const auto strobes = strobe < step.length - resolution;
  const auto is_quiet = !strobes && step.presses && is_finite<Form>(quiet.end) &&
                        is_ordinary(step, resolution, quiet.steps_since_strobe) && quiet.next.is_in_period;
  return bits_of(occupied && !is_quiet) == 0;
}

/// Where a step on the friction grid leads.
enum class Passage : std::uint8_t {
  none,  ///< it is not quiet: the lanes have not moved
  to_known_interval,
  to_unknown_interval,  ///< in some lanes the next interval must be drawn
};

/// If the step on the friction grid is quiet in all lanes, moves them on to the next interval. That takes half of the
/// operations of finding and moving the lanes that can move on.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline Passage pass_quiet_step(const LaneAccess<Real>& lanes, const Step<Form>& step,
                                             const UnclearedGuards<Form>& guards) {
  if (bits_of(guards.any) != 0) return Passage::none;
  LaneState& state = lanes.state;
  const auto every_lane = Real(0.0) == Real(0.0);
  const QuietStep<Form> quiet{.steps_since_strobe = lanes.load(state.steps_since_strobe) + Real(1.0),
                              .end = point<Form>(step.m, step.length),
                              .next = next_start<Form>(lanes, step, step.length, every_lane)};
  if (!is_quiet(lanes, step, quiet, guards.occupied)) return Passage::none;
  note_peaks(lanes, step, {step.length, quiet.end.tilt, quiet.end.tilt_rate}, guards.occupied);
  if constexpr (Form::has_tangents) {
    const TangentStep<Form> tangents(lanes, step);
    move_vectors(AllMoving<Real>{lanes}, tangents, tangents.at(step.length));
  }
  lanes.store(state.steps_since_strobe, quiet.steps_since_strobe);
  lanes.store(state.steps, lanes.load(state.steps) + Real(1.0));
  lanes.store(state.tilt, quiet.end.tilt);
  lanes.store(state.tilt_rate, quiet.end.tilt_rate);
  lanes.store(state.slip, quiet.end.slip);
  lanes.store(state.slip_rate, quiet.end.slip_rate);
  lanes.store(state.time, quiet.next.time);
  lanes.store(state.period, quiet.next.period);
  pass_interval(AllMoving<Real>{lanes}, step.now.period_length);
  return lanes_at_unknown_interval(lanes, guards.occupied) == 0 ? Passage::to_known_interval
                                                                : Passage::to_unknown_interval;
}

}  // namespace
}  // namespace rocking::lanes
