#pragma once

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
}  // namespace rocking::lanes
