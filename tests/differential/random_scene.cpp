#include "differential/random_scene.hpp"

#include <cmath>
#include <numbers>
#include <variant>

#include "support/excitation.hpp"
#include "support/random_scene.hpp"
#include "support/split_mix.hpp"

namespace rocking::differential {

Question random_question(std::uint64_t number) {
  support::SplitMix random(number);
  Question question{.condition = {}, .seed = random.bits(), .realisation = number, .periods = 5 + random.below(6)};
  question.condition.scene = support::random_scene(random);
  return question;
}

peer::Scene peer_scene(const Question& question) {
  const Scene& scene = question.condition.scene;
  const double turn = 2.0 * std::numbers::pi;
  const double phase = std::get<double>(support::harmonic(scene).phase);
  peer::Scene same{.slenderness = mean_block(scene).height / mean_block(scene).width,
                   .amplitude = mean_of(support::harmonic(scene).amplitude),
                   .frequency = mean_of(support::harmonic(scene).frequency_ratio),
                   .phase = phase - turn * std::floor(phase / turn),
                   .restitution = mean_of(std::get<Quantity>(scene.restitution)),
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
  if (scene.friction) same.friction = {mean_static(*scene.friction), mean_kinetic(*scene.friction)};
  return same;
}

}  // namespace rocking::differential
