#pragma once

#include "rocking/scene/experiment.hpp"

/// Conditions in which a large tilt is rare.
namespace rocking::support::rare {

/// Friction, restitution and amplitude are drawn along the way.
inline Condition fluctuating() {
  Condition condition;
  Harmonic shaking;
  shaking.amplitude = 4.2;
  shaking.frequency_ratio = 6.0;
  condition.scene.excitation = shaking;
  condition.scene.friction = {.static_coefficient = 0.35, .kinetic_coefficient = 0.30};
  condition.scene.fluctuation = {.static_friction = 0.03,
                                 .kinetic_friction = 0.03,
                                 .refreshes_per_period = 20,
                                 .restitution = 0.02,
                                 .amplitude = 0.6};
  condition.horizon = {.transient_periods = 5, .sampled_periods = 10};
  return condition;
}

/// Size and initial tilt are drawn, and nothing else.
inline Condition drawn_once() {
  Condition condition = fluctuating();
  condition.scene.friction.reset();
  condition.scene.fluctuation = {};
  condition.scene.block.width = Normal{.mean = 1.0, .sigma = 0.05};
  condition.scene.initial.tilt = Uniform{.low = -0.3, .high = 0.3};
  return condition;
}

}  // namespace rocking::support::rare
