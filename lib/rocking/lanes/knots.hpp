#pragma once

#include <cstddef>
#include <cstdint>

#include "rocking/lanes/step.hpp"

/// What the lanes do at breakpoints of a base motion that consists of pieces.
namespace rocking::lanes {
namespace {

/// Lanes whose step begins at a breakpoint that was passed here and where sticking may fail: their motions must check
/// it. The expressions are those of dynamics::friction_holds.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline auto may_slip_at_breakpoint(const LaneAccess<Real>& lanes, const Step<Form>& step) {
  using base::magnitude;
  const Real most = lanes.load(lanes.state.static_friction) * step.m.normal[0];
  const Real friction = Real(lanes.template constants<Form>().load) * step.m.base[0] - step.m.rate_cosine[1];
  const auto holds = step.presses && base::at_most(magnitude(friction), most);
  return lanes.load(lanes.state.occupied) == Real(1.0) && lanes.load(lanes.state.fresh) == Real(1.0) && !holds;
}

/// The piece that begins at the next knot.
template <class Form>
inline void pass_knot(LaneState& state, std::size_t lane) {
  using Shaking = typename Form::Shaking;
  using Real = typename Form::Real;
  state.breakpoints[lane] += 1.0;
  const dynamics::Moment<double> now{.period = state.period[lane],
                                     .time = state.time[lane],
                                     .period_length = state.period_length[lane],
                                     .frequency = state.frequency[lane]};
  const dynamics::Knot* knot = Shaking::template follow<Real>(state.knot[lane], now, state.resolution[lane]);
  state.knot[lane] = knot;
  const auto piece = Shaking::template piece_from<Real>(knot, state.piece[Shaking::piece_numbers - 1][lane]);
  for (std::size_t i = 0; i < Shaking::piece_numbers; ++i) state.piece[i][lane] = piece[i];
  const double other_period = state.other_break_period[lane];
  const double other_time = state.other_break_time[lane];
  const double until_other = now.until(other_period, other_time);
  if (until_other <= state.resolution[lane]) state.at_breakpoint |= 1U << lane;
  const auto knot_period = static_cast<double>(knot[1].instant.period);
  const bool other_first = until_other < now.until(knot_period, knot[1].instant.time);
  state.break_period[lane] = other_first ? other_period : knot_period;
  state.break_time[lane] = other_first ? other_time : knot[1].instant.time;
}

/// Of the lanes that have `moved` on, those that `arrived` at a breakpoint continue with the piece that begins there.
/// Where a breakpoint that is not the base motion's is reached too, the motion continues alone.
template <class Form, class Real>
inline void pass_knots(const LaneAccess<Real>& lanes, std::uint32_t moved, std::uint32_t arrived) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(Row<Real>::lanes); ++i) {
    const std::size_t lane = lanes.first + i;
    if ((moved >> i & 1U) == 0) continue;
    const bool at_break = (arrived >> i & 1U) != 0;
    lanes.state.fresh[lane] = at_break ? 1.0 : 0.0;
    if (at_break) pass_knot<Form>(lanes.state, lane);
  }
}

}  // namespace
}  // namespace rocking::lanes
