#pragma once

#include <cstddef>

#include "rocking/dynamics/peaks.hpp"
#include "rocking/lanes/crossings.hpp"
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

/// How the coming step of the lanes ends.
template <class Form>
struct Ending {
  using Real = typename Form::Real;

  Crossings<Form> crossings;
  Point<Real> point;  ///< the state
  Real steps_since_strobe;
  Strobing<Form> strobing;
};

/// The steps of the lanes `computed` go to their ends, or to the last strobe instant.
template <class Form, class Truth = typename Form::Truth>
inline void note_peaks(const LaneAccess<typename Form::Real>& lanes, const Step<Form>& step,
                       const dynamics::StepFinish<typename Form::Real>& end, const Truth& computed) {
  using base::in_any, base::select;
  using Real = typename Form::Real;
  LaneState& state = lanes.state;
  const auto constants = lanes.template constants<Form>();
  const dynamics::TiltPeaks<Real> kept{.tilt = lanes.load(state.peak_tilt),
                                       .tilt_rate = lanes.load(state.peak_tilt_rate)};
  const dynamics::TiltPeaks<Real> before = dynamics::peaks_on_side(kept, constants);
  if (!in_any(dynamics::may_raise<Real>(step.m, end, before))) return;
  const dynamics::TiltPeaks<Real> after = dynamics::peaks_to_keep(
      kept, before, dynamics::peaks_after<Real>(step.m, static_cast<std::size_t>(Form::order), end, before), constants);
  lanes.store(state.peak_tilt, select(computed, after.tilt, kept.tilt));
  lanes.store(state.peak_tilt_rate, select(computed, after.tilt_rate, kept.tilt_rate));
}

/// How far the steps go: to their ends, or to the last strobe instant.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline dynamics::StepFinish<Real> finish_of(const LaneAccess<Real>& lanes, const Ending<Form>& end,
                                                          const typename Form::Truth& at_last_strobe) {
  using base::select;
  const Real& duration = end.crossings.duration;
  if (bits_of(at_last_strobe) == 0) return {duration, end.point.tilt, end.point.tilt_rate};
  const LaneState& state = lanes.state;
  const Real last_strobe = end.strobing.time(lanes.load(state.resolution));
  return {.length = select(at_last_strobe, last_strobe, duration),
          .tilt = select(at_last_strobe, lanes.load(state.strobe_tilt), end.point.tilt),
          .tilt_rate = select(at_last_strobe, lanes.load(state.strobe_tilt_rate), end.point.tilt_rate)};
}

/// Says in the lane state how the step ends: for the lanes that were not moved on.
template <class Form, class Real = typename Form::Real>
inline void store_end(const LaneAccess<Real>& lanes, const Step<Form>& step, const Ending<Form>& end) {
  using base::select;
  LaneState& state = lanes.state;
  lanes.store(state.duration, end.crossings.duration);
  lanes.store(state.end_tilt, end.point.tilt);
  lanes.store(state.end_tilt_rate, end.point.tilt_rate);
  if constexpr (Form::slips) {
    lanes.store(state.end_slip, end.point.slip);
    lanes.store(state.end_slip_rate, end.point.slip_rate);
  }
  const Real resolution = lanes.load(state.resolution);
  Real fired(0.0);
  std::size_t i = 0;
  for_each_guard(lanes, step, [&](const auto& row, auto) {
    constexpr auto bit = [](dynamics::Guard guard) { return static_cast<double>(1U << static_cast<unsigned>(guard)); };
    fired = fired + select(end.crossings.is_first(i++, resolution), Real(bit(row.guard)), Real(0.0));
  });
  lanes.store(state.fired, fired);
}

}  // namespace
}  // namespace rocking::lanes
