#pragma once

#include <cstddef>

#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/sticking_impulse.hpp"
#include "rocking/lanes/crossings.hpp"
#include "rocking/lanes/step_points.hpp"

namespace rocking::lanes {
namespace {

/// Which lanes end the coming step with an impact that can be computed here: it sticks, ends no chatter, and is the
/// only event.
template <class Form>
struct Rebounds {
  typename Form::Truth lands;
  typename Form::Real tilt_rate;  ///< after the impact, in the frame of the new side
};

template <class Real>
[[nodiscard]] inline dynamics::LandingRates<Real> landing_rates(const Real& tilt_rate) {
  return {.tilt_rate = tilt_rate, .slip_rate = Real(0.0)};
}

/// Of a rectangle.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline dynamics::LandingEdge<Real> landing_edge(const LaneAccess<Real>& lanes) {
  const auto constants = lanes.template constants<Form>();
  return {.restitution = lanes.load(lanes.state.restitution),
          .loss = lanes.load(lanes.state.impact_loss),
          .sine = constants.sine,
          .cosine = constants.cosine};
}

/// An impact at the end of a step.
template <class Real>
struct Impact {
  Real duration;  ///< of the step
  Real before;    ///< tilt rate
  Real after;     ///< tilt rate, in the frame of the new side
};

/// Whether friction holds the block during the impact and after it. False within 1 % of the limit: there the motion
/// decides, so that the rounding of the expressions below has no influence on results.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline auto sticks(const LaneAccess<Real>& lanes, const Step<Form>& step, const Impact<Real>& impact) {
  using base::fused, base::magnitude;
  const Real closest = Real(0.99) * lanes.load(lanes.state.static_friction);
  const auto edge = landing_edge<Form>(lanes);
  const auto impulse = dynamics::sticking_impulse(landing_rates(impact.before), edge);
  Real base = step.m.base[Form::order];
#pragma GCC unroll 20
  for (std::size_t k = Form::order; k > 0; --k) base = fused(base, impact.duration, step.m.base[k - 1]);
  // In the frame of the new side.
  const auto forces = dynamics::forces_without_slip<Real>(
      {.edge = {edge.sine, edge.cosine}, .omega = impact.after, .beta = -base, .weight = Real(1.0)},
      lanes.template constants<Form>());
  return base::at_most(magnitude(impulse.horizontal), closest * impulse.vertical) && Real(0.0) < forces.normal &&
         dynamics::friction_is_enough(forces, closest);
}

/// Of the lanes `fits`, those with such an impact, as in dynamics::land. `tilt_rate`: at the end of the step.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline Rebounds<Form> find_rebounds(const LaneAccess<Real>& lanes, const Step<Form>& step,
                                                  const Crossings<Form>& crossings, const Real& tilt_rate,
                                                  const typename Form::Truth& fits) {
  const Real resolution = lanes.load(lanes.state.resolution);
  const Real rebound = -dynamics::sticking_rate(landing_rates(tilt_rate), landing_edge<Form>(lanes));
  auto lands = fits && crossings.is_first(0, resolution) && step.now.time < step.now.time + crossings.duration &&
               tilt_rate < Real(0.0) && lanes.load(lanes.state.least_rebound) < rebound;
  for (std::size_t i = 1; i < Form::guards; ++i) lands = lands && !crossings.is_first(i, resolution);
  if constexpr (Form::tests_friction) {
    lands = lands && sticks(lanes, step, Impact<Real>{crossings.duration, tilt_rate, rebound});
  }
  return {lands, rebound};
}

}  // namespace
}  // namespace rocking::lanes
