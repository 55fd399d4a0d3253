#pragma once

#include <cmath>

#include "rocking/scene/experiment.hpp"
#include "support/split_mix.hpp"

/// Random scenes under harmonic excitation: every formulation, with and without friction, every fluctuation, any
/// initial state.
namespace rocking::support {

/// A random number with uniform logarithm.
inline double spread(SplitMix& random, double low, double high) { return low * std::pow(high / low, random.uniform()); }

namespace scene {

inline void choose_formulation(Scene& scene, SplitMix& random) {
  const int reading = random.below(3);  // consistent, as-printed, as-plotted
  if (reading != 0) {
    scene.slide_inertia = dynamics::SlideInertia::edge;
    scene.impact_slip_rule = dynamics::ImpactSlipRule::signed_ratio;
  }
  const double sine = std::sin(std::atan(mean_block(scene).width / mean_block(scene).height));
  scene.restitution = reading == 1 ? 1.0 - 1.5 * sine * sine : 0.0;
  if (random.below(2) == 0) scene.restitution = random.uniform(-0.5, 0.9);
}

inline void choose_friction(Scene& scene, SplitMix& random) {
  if (random.below(4) == 0) return;
  const double mu_s = random.uniform(0.05, 1.2);
  const double mu_k = random.below(4) == 0 ? mu_s : mu_s * random.uniform(0.3, 1.0);
  scene.friction = Friction{.static_coefficient = mu_s, .kinetic_coefficient = mu_k};
}

inline void choose_fluctuation(Scene& scene, SplitMix& random) {
  if (random.below(2) == 0) return;
  const auto sigma = [&random] { return random.below(2) == 0 ? 0.0 : spread(random, 0.001, 0.1); };
  scene.fluctuation.restitution = sigma();
  scene.fluctuation.amplitude = sigma();
  const double static_friction = sigma();
  const double kinetic_friction = sigma();
  if (!scene.friction) return;
  scene.fluctuation.static_friction = static_friction;
  scene.fluctuation.kinetic_friction = kinetic_friction;
}

inline void choose_start(Scene& scene, SplitMix& random) {
  const auto maybe = [&random](double low, double high) {
    return random.below(2) == 0 ? 0.0 : random.uniform(low, high);
  };
  if (random.below(3) == 0) return;
  scene.initial.tilt = maybe(-0.9, 0.9);
  scene.initial.tilt_rate = maybe(-1.0, 1.0);
  const double slip_rate = maybe(-0.5, 0.5);
  if (scene.friction) scene.initial.slip_rate = slip_rate;
}

}  // namespace scene

/// A block with H/B between `squattest` and `tallest`.
inline Scene random_scene(SplitMix& random, double squattest = 1.2, double tallest = 12.0) {
  Scene scene;
  scene.block = {.width = 1.0, .height = spread(random, squattest, tallest)};
  auto& sine = scene.excitation.emplace<Harmonic>();
  sine.amplitude = spread(random, 0.5, 12.0);
  sine.frequency_ratio = spread(random, 2.0, 20.0);
  sine.phase = random.below(4) == 0 ? 0.0 : random.uniform(-7.0, 14.0);
  scene::choose_formulation(scene, random);
  scene::choose_friction(scene, random);
  scene::choose_fluctuation(scene, random);
  scene::choose_start(scene, random);
  return scene;
}

}  // namespace rocking::support
