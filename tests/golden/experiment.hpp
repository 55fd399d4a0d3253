#pragma once

#include "rocking/scene/experiment.hpp"
#include "support/excitation.hpp"

namespace rocking::golden {

inline Condition rocking_with_everything() {
  Condition condition;
  Scene& scene = condition.scene;
  support::harmonic(scene).amplitude = 6.6;
  support::harmonic(scene).frequency_ratio = 10.0;
  support::harmonic(scene).phase = Uniform{.low = 0.0, .high = 6.0};
  scene.friction = Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  scene.fluctuation = {.static_friction = 0.03,
                       .kinetic_friction = 0.03,
                       .refreshes_per_period = 200,
                       .restitution = 0.05,
                       .amplitude = 0.2};
  scene.initial.tilt = Normal{.mean = 0.1, .sigma = 0.05};
  condition.horizon = {.transient_periods = 40, .sampled_periods = 60};
  condition.realisations = 8;
  return condition;
}

inline Condition chattering_without_friction() {
  Condition condition;
  support::harmonic(condition.scene).amplitude = 1.03;
  support::harmonic(condition.scene).frequency_ratio = 2.0;
  condition.horizon = {.transient_periods = 4, .sampled_periods = 24};
  return condition;
}

inline Condition as_printed() {
  Condition condition = rocking_with_everything();
  condition.scene.slide_inertia = dynamics::SlideInertia::edge;
  condition.scene.impact_slip_rule = dynamics::ImpactSlipRule::signed_ratio;
  return condition;
}

/// A small experiment with all sources of random numbers, slip, impacts and chatter.
inline Experiment golden_experiment() {
  Experiment experiment;
  experiment.seed = 0x2012;
  experiment.conditions = {rocking_with_everything(), chattering_without_friction(), as_printed()};
  return experiment;
}

}  // namespace rocking::golden
