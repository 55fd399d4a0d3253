#pragma once

#include <cstddef>

#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/integrate/step_length.hpp"
#include "rocking/lanes/grid_intervals.hpp"
#include "rocking/lanes/step_form.hpp"

namespace rocking::lanes {
namespace {

/// The coming step of the lanes.
///
/// The expressions are those of dynamics::BlockMotion and integrate::step, in the same order, so that a lane computes
/// the bits that the motion would compute alone.
template <class Form>
struct Step {
  using Real = typename Form::Real;
  using Truth = typename Form::Truth;

  dynamics::MotionSeries<Real> m;
  dynamics::Moment<Real> now;  ///< its start
  Real reach;                  ///< time to the next breakpoint
  Real length;
  Truth fits;                                ///< the order suffices for the step
  Truth presses;                             ///< N > 0; otherwise other guards would be armed
  dynamics::OutOfReach<Truth> out_of_reach;  ///< without slip
};

/// The state of the base and the block at the start.
template <class Form, class Real = typename Form::Real>
[[gnu::noinline]] void begin_step(const LaneAccess<Real>& lanes, Step<Form>& step) {
  using Shaking = typename Form::Shaking;
  const LaneState& state = lanes.state;
  step.now = {.period = lanes.load(state.period),
              .time = lanes.load(state.time),
              .period_length = lanes.load(state.period_length),
              .frequency = lanes.load(state.frequency)};
  dynamics::Piece<Shaking, Real> piece;
  for (std::size_t i = 0; i < Shaking::piece_numbers; ++i) piece[i] = lanes.load(state.piece[i]);
  Shaking::template expand<Form::order>(step.m, piece, lanes.load(state.amplitude), step.now);
  step.m.tilt[0] = lanes.load(state.tilt);
  step.m.tilt_rate[0] = lanes.load(state.tilt_rate);
  dynamics::begin_angle(step.m, lanes.template constants<Form>());
}

/// Kinetic friction of the coming step.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline Real kinetic_friction(const LaneAccess<Real>& lanes) {
  if constexpr (Form::on_grid) return friction_of_interval(lanes);
  return lanes.load(lanes.state.kinetic_friction);
}

/// The series of the motion; returns for how long the order suffices.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline Real expand_motion(const LaneAccess<Real>& lanes, Step<Form>& step) {
  using base::smaller;
  constexpr int order = Form::order;
  const LaneState& state = lanes.state;
  const auto length_of = [largest = lanes.load(state.largest)](const auto& row) {
    return integrate::step_length(row[order - 1], row[order], order, largest);
  };
  const auto within_weight = [&](const Real& own) {
    if constexpr (Form::Shaking::has_vertical && !Form::Shaking::has_knots) {
      return smaller(length_of(step.m.weight), own);
    } else {
      return own;
    }
  };
  if constexpr (Form::slips) {
    step.m.slip_rate[0] = lanes.load(state.slip_rate);
    step.m.slip[0] = lanes.load(state.slip);
    dynamics::expand_rock_slide<order, Form::Shaking::has_vertical>(
        step.m, lanes.template constants<Form>(),
        {.drag = lanes.load(state.slip_sign) * kinetic_friction<Form>(lanes), .first_rate_gate = Real(1.0)});
    return within_weight(smaller(length_of(step.m.slip_rate), length_of(step.m.tilt_rate)));
  } else {
    dynamics::expand_rock<order, Form::Shaking::has_vertical>(step.m, lanes.template constants<Form>(), Real(1.0));
    return within_weight(length_of(step.m.tilt_rate));
  }
}

/// The length of the step, given for how long the order suffices.
template <class Form, class Real = typename Form::Real>
inline void set_length(const LaneAccess<Real>& lanes, Step<Form>& step, const Real& sufficient) {
  using base::at_most, base::smaller;
  const Real& period = step.now.period_length;
  step.reach = step.now.until(lanes.load(lanes.state.break_period), lanes.load(lanes.state.break_time));
  if constexpr (Form::is_brief) {
    step.fits = at_most(step.reach, sufficient);
    if constexpr (!Form::on_grid) step.fits = step.fits && at_most(step.reach, Real(dynamics::brief_step) * period);
    step.length = step.reach;
  } else {
    step.fits = Real(dynamics::brief_step) * period < step.reach;
    step.length = smaller(period, smaller(step.reach, sufficient));
  }
}

/// After begin_step: the series, and the length of the step.
template <class Form, class Real = typename Form::Real>
[[gnu::noinline, gnu::flatten]] void expand_step(const LaneAccess<Real>& lanes, Step<Form>& step) {
  set_length<Form>(lanes, step, expand_motion<Form>(lanes, step));
  if constexpr (Form::knows_reach) {
    step.out_of_reach = dynamics::out_of_reach<Real>({.tilt = step.m.tilt[0],
                                                      .tilt_rate = step.m.tilt_rate[0],
                                                      .base_amplitude = lanes.load(lanes.state.amplitude),
                                                      .length = step.length},
                                                     lanes.template constants<Form>());
    step.presses = step.out_of_reach.normal;
    // Without a friction guard, the series of N is needed by its own guard only.
    if (!Form::tests_friction && bits_of(!step.presses) == 0) return;
  }
  if constexpr (!Form::slips)
    dynamics::expand_normal<Form::order, Form::Shaking::has_vertical>(step.m, lanes.template constants<Form>());
  step.presses = Real(0.0) < step.m.normal[0];
}

/// Whether the motion alone would compute this step with the same order and length, and end it later than it begins.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline auto is_ordinary(const Step<Form>& step, const Real& resolution, const Real& steps_since_strobe) {
  return step.fits && Real(dynamics::least_step) * resolution < step.length &&
         step.now.time < step.now.time + step.length &&
         steps_since_strobe < Real(static_cast<double>(dynamics::step_budget) + 0.5);
}

}  // namespace
}  // namespace rocking::lanes
