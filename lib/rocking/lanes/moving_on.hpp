#pragma once

#include "rocking/dynamics/peaks.hpp"
#include "rocking/lanes/ending.hpp"
#include "rocking/lanes/grid_intervals.hpp"
#include "rocking/lanes/knots.hpp"
#include "rocking/lanes/rebounds.hpp"
#include "rocking/lanes/step.hpp"

namespace rocking::lanes {

namespace {

/// The instants at which the lanes begin their next step.
template <class Form>
struct NextStart {
  using Real = typename Form::Real;
  using Truth = typename Form::Truth;

  Real period;
  Real time;
  Truth at_break;      ///< the step ends at a breakpoint
  Truth is_in_period;  ///< otherwise the motion must find the period
};

template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline NextStart<Form> next_start(const LaneAccess<Real>& lanes, const Step<Form>& step,
                                                const Real& duration, const typename Form::Truth& without_crossing) {
  using base::select;
  auto at_break = !(duration < step.reach - lanes.load(lanes.state.resolution));
  if constexpr (Form::on_grid) at_break = without_crossing;
  Real later = step.now.time + duration;
  Real from = step.now.period;
  if constexpr (Form::passes_breakpoints) {
    later = select(at_break, lanes.load(lanes.state.break_time), later);
    from = select(at_break, lanes.load(lanes.state.break_period), from);
  }
  const auto wraps = !(later < step.now.period_length);
  const Real time = select(wraps, later - step.now.period_length, later);
  return {.period = select(wraps, from + Real(1.0), from),
          .time = time,
          .at_break = at_break,
          .is_in_period = time < step.now.period_length};
}

}  // namespace

namespace {

/// The lanes that may move on to the end of the coming step.
template <class Form>
struct Movable {
  using Truth = typename Form::Truth;

  Truth without_crossing;
  Rebounds<Form> rebounds;
  Truth strobed;
};

/// Counts the step, and the strobe point in the lanes `strobed`.
template <class Real>
inline void count_step(const MovingLanes<Real>& moving, const Real& steps_since_strobe, const TruthOf<Real>& strobed) {
  using base::select;
  const LaneAccess<Real>& lanes = moving.lanes;
  LaneState& state = lanes.state;
  const Real one(1.0);
  moving.store(state.steps_since_strobe, select(strobed, Real(0.0), steps_since_strobe),
               lanes.load(state.steps_since_strobe));
  moving.store(state.steps, lanes.load(state.steps) + one, lanes.load(state.steps));
  if (bits_of(strobed) == 0) return;
  const Real period = lanes.load(state.strobe_period);
  const Real left = lanes.load(state.strobes_left);
  lanes.store(state.strobe_period, select(strobed, period + one, period));
  lanes.store(state.strobes_left, select(strobed, left - one, left));
}

/// The state after the step. The lanes `landed` end it with a rebound.
template <class Form, class Real = typename Form::Real>
inline void move_state(const MovingLanes<Real>& moving, const Step<Form>& step, const Point<Real>& end,
                       const Rebounds<Form>& landed) {
  using base::magnitude, base::select;
  const LaneAccess<Real>& lanes = moving.lanes;
  LaneState& state = lanes.state;
  if (Form::may_land && bits_of(landed.lands) != 0) {
    moving.store(state.tilt, select(landed.lands, Real(0.0), end.tilt), step.m.tilt[0]);
    moving.store(state.tilt_rate, select(landed.lands, landed.tilt_rate, end.tilt_rate), step.m.tilt_rate[0]);
    const Real amplitude = lanes.load(state.amplitude);
    lanes.store(state.amplitude, select(landed.lands, -amplitude, amplitude));
    const Real peak = lanes.load(state.peak_tilt_rate);
    const Real larger = dynamics::peaks::larger(peak, magnitude(landed.tilt_rate));
    lanes.store(state.peak_tilt_rate, select(landed.lands, larger, peak));
  } else {
    moving.store(state.tilt, end.tilt, step.m.tilt[0]);
    moving.store(state.tilt_rate, end.tilt_rate, step.m.tilt_rate[0]);
  }
  if constexpr (Form::slips) {
    moving.store(state.slip, end.slip, step.m.slip[0]);
    moving.store(state.slip_rate, end.slip_rate, step.m.slip_rate[0]);
  }
}

/// Moves on the lanes without a crossing and those that land, unless they reach the end of what holds for them: a
/// breakpoint that is not passed here, or the end of the period. Returns the lanes that have moved.
template <class Form, class Real = typename Form::Real>
inline typename Form::Truth move_on(const LaneAccess<Real>& lanes, const Step<Form>& step, const Ending<Form>& end,
                                    const Movable<Form>& movable) {
  LaneState& state = lanes.state;
  const auto next = next_start<Form>(lanes, step, end.crossings.duration, movable.without_crossing);
  const auto& [lands, rebound] = movable.rebounds;
  auto no_event = (Form::may_land ? movable.without_crossing || lands : movable.without_crossing) && next.is_in_period;
  if constexpr (!Form::passes_breakpoints) no_event = no_event && !next.at_break;
  const auto landed = no_event && lands;
  lanes.mark(state.no_event, bits_of(no_event));
  lanes.mark(state.landed, bits_of(landed));
  const MovingLanes<Real> moving{lanes, no_event};
  count_step(moving, end.steps_since_strobe, no_event && movable.strobed);
  move_state<Form>(moving, step, end.point, {landed, rebound});
  moving.store(state.time, next.time, step.now.time);
  moving.store(state.period, next.period, step.now.period);
  if constexpr (Form::on_grid) {
    pass_interval(moving, step.now.period_length);
    lanes.mark(state.at_breakpoint, lanes_at_unknown_interval(lanes, no_event));
  }
  if constexpr (Form::Shaking::has_knots) {
    const auto occupied = lanes.load(state.occupied) == Real(1.0);
    pass_knots<Form>(lanes, bits_of(occupied && no_event), bits_of(no_event && next.at_break));
  }
  return no_event;
}

}  // namespace

}  // namespace rocking::lanes
