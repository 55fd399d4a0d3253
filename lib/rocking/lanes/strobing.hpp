#pragma once

#include "rocking/lanes/step_points.hpp"

namespace rocking::lanes {
namespace {

/// The strobe instant within a part of the coming step of the lanes.
template <class Form>
struct Strobing {
  using Real = typename Form::Real;
  using Truth = typename Form::Truth;

  Real instant;
  Truth strobes;    ///< there is one
  Truth is_last;    ///< the run ends with it
  Truth is_simple;  ///< there is no second one

  /// The time of the step at which the state is that of the strobe point.
  [[nodiscard]] Real time(const Real& resolution) const {
    using base::select;
    return select(resolution < instant, instant, Real(0.0));
  }
};

/// In the step up to its time `end`.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline Strobing<Form> strobing_before(const LaneAccess<Real>& lanes, const Step<Form>& step,
                                                    const Real& end) {
  const Real period = lanes.load(lanes.state.strobe_period);
  const Real time = lanes.load(lanes.state.strobe_time);
  const Real instant = step.now.until(period, time);
  const auto strobes = instant < end;
  if (bits_of(strobes) == 0) return {instant, strobes, strobes, !strobes};
  const auto is_last = lanes.load(lanes.state.strobes_left) < Real(1.5);
  const auto is_only = is_last || !(step.now.until(period + Real(1.0), time) < end);
  return {instant, strobes, is_last, is_only || !strobes};
}

/// Stores the state at the strobe instant; true in the lanes where it is finite.
template <class Form, class Real = typename Form::Real>
inline auto store_strobe(const LaneAccess<Real>& lanes, const Step<Form>& step, const Real& time) {
  LaneState& state = lanes.state;
  const Point<Real> p = point<Form>(step.m, time);
  lanes.store(state.strobe_tilt, p.tilt);
  lanes.store(state.strobe_tilt_rate, p.tilt_rate);
  if constexpr (Form::slips) {
    lanes.store(state.strobe_slip, p.slip);
    lanes.store(state.strobe_slip_rate, p.slip_rate);
  }
  return is_finite<Form>(p);
}

}  // namespace
}  // namespace rocking::lanes
