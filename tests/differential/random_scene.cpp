#include "differential/random_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "support/split_mix.hpp"

namespace rocking::differential {
namespace {

using support::SplitMix;

/// All orders of magnitude alike.
double spread(SplitMix& random, double low, double high) { return low * std::pow(high / low, random.uniform()); }

void choose_formulation(experiment::Scene& scene, SplitMix& random) {
  const int reading = random.below(3);  // consistent, as-printed, as-plotted
  if (reading != 0) {
    scene.slide_inertia = dynamics::SlideInertia::edge;
    scene.impact_slip_rule = dynamics::ImpactSlipRule::signed_ratio;
  }
  const double sine = std::sin(std::atan(scene.block.width / scene.block.height));
  scene.restitution = reading == 1 ? 1.0 - 1.5 * sine * sine : 0.0;
  if (random.below(2) == 0) scene.restitution = random.uniform(-0.5, 0.9);
}

void choose_friction(experiment::Scene& scene, SplitMix& random) {
  if (random.below(4) == 0) return;
  const double mu_s = random.uniform(0.05, 1.2);
  const double mu_k = random.below(4) == 0 ? mu_s : mu_s * random.uniform(0.3, 1.0);
  scene.friction = experiment::Friction{.static_coefficient = mu_s, .kinetic_coefficient = mu_k};
}

void choose_fluctuation(experiment::Scene& scene, SplitMix& random) {
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

void choose_start(experiment::Scene& scene, SplitMix& random) {
  const auto maybe = [&random](double low, double high) {
    return random.below(2) == 0 ? 0.0 : random.uniform(low, high);
  };
  if (random.below(3) == 0) return;
  scene.initial.tilt = maybe(-0.9, 0.9);
  scene.initial.tilt_rate = maybe(-1.0, 1.0);
  const double slip_rate = maybe(-0.5, 0.5);
  if (scene.friction) scene.initial.slip_rate = slip_rate;
}

}  // namespace

Question random_question(std::uint64_t number) {
  SplitMix random(number);
  Question question{.condition = {}, .seed = random.bits(), .realisation = number, .periods = 5 + random.below(6)};
  experiment::Scene& scene = question.condition.scene;
  scene.block = {.width = 1.0, .height = spread(random, 1.2, 12.0)};
  scene.excitation = {.amplitude = spread(random, 0.5, 12.0),
                      .frequency_ratio = spread(random, 2.0, 20.0),
                      .phase = random.below(4) == 0 ? 0.0 : random.uniform(-7.0, 14.0),
                      .record = nullptr};
  choose_formulation(scene, random);
  choose_friction(scene, random);
  choose_fluctuation(scene, random);
  choose_start(scene, random);
  return question;
}

peer::Scene peer_scene(const Question& question) {
  const experiment::Scene& scene = question.condition.scene;
  const double turn = 2.0 * std::numbers::pi;
  const double phase = std::get<double>(scene.excitation.phase);
  peer::Scene same{.slenderness = scene.block.height / scene.block.width,
                   .amplitude = scene.excitation.amplitude,
                   .frequency = scene.excitation.frequency_ratio,
                   .phase = phase - turn * std::floor(phase / turn),
                   .restitution = scene.restitution,
                   .friction = std::nullopt,
                   .edge_inertia = scene.slide_inertia == dynamics::SlideInertia::edge,
                   .signed_impact_rule = scene.impact_slip_rule == dynamics::ImpactSlipRule::signed_ratio,
                   .sigmas = {.at_rest = scene.fluctuation.static_friction,
                              .sliding = scene.fluctuation.kinetic_friction,
                              .restitution = scene.fluctuation.restitution,
                              .amplitude = scene.fluctuation.amplitude},
                   .refreshes_per_period = scene.fluctuation.refreshes_per_period,
                   .tilt = std::get<double>(scene.initial.tilt),
                   .tilt_rate = std::get<double>(scene.initial.tilt_rate),
                   .slip_rate = std::get<double>(scene.initial.slip_rate),
                   .seed = question.seed,
                   .realisation = question.realisation};
  if (scene.friction) same.friction = {scene.friction->static_coefficient, scene.friction->kinetic_coefficient};
  return same;
}

}  // namespace rocking::differential
