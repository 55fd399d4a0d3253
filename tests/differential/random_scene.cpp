#include "differential/random_scene.hpp"

#include <cmath>
#include <numbers>
#include <variant>

#include "support/excitation.hpp"
#include "support/random_scene.hpp"
#include "support/split_mix.hpp"

namespace rocking::differential {
namespace {

/// Edges from 0.2 to 0.8 m, slender to squat, and I from a fifth to three fifths of m R^2.
GivenEdges random_mass(support::SplitMix& random) {
  const double left = random.uniform(0.2, 0.8);
  const double right = random.uniform(0.2, 0.8);
  const double height = support::spread(random, 0.6, 5.0);
  return {.edges = {left, right},
          .centre_height = height,
          .radius_of_gyration = std::sqrt(random.uniform(0.2, 0.6)) * std::hypot(0.5 * (left + right), height)};
}

}  // namespace

Question random_question(std::uint64_t number) {
  support::SplitMix random(number);
  Question question{.condition = {}, .seed = random.bits(), .realisation = number, .periods = 5 + random.below(6)};
  question.condition.scene = support::random_scene(random);
  return question;
}

Question random_general_question(std::uint64_t number) {
  Question question = random_question(number);
  Scene& scene = question.condition.scene;
  support::SplitMix random(~number);
  scene.block.mass = random_mass(random);
  scene.slide_inertia = dynamics::SlideInertia::centroidal;
  scene.impact_slip_rule = dynamics::ImpactSlipRule::absolute;
  if (scene.friction) {  // below 0.6: less than what leaves the equations of sliding without a solution
    scene.friction = Friction{.static_coefficient = 0.5 * mean_static(*scene.friction),
                              .kinetic_coefficient = 0.5 * mean_kinetic(*scene.friction)};
  }
  return question;
}

Question random_pulse_question(std::uint64_t number) {
  support::SplitMix random(~number);
  Question question{.condition = {}, .seed = 0, .realisation = number, .periods = 8};
  Scene& scene = question.condition.scene;
  scene.block.mass = random_mass(random);
  const double frequency = support::spread(random, 1.0, 6.0);
  scene.excitation = Pulse{.amplitude = support::spread(random, 1.0 + frequency, 2.0 + 2.0 * frequency * frequency),
                           .frequency_ratio = frequency};
  return question;
}

Quantity& amplitude_of(Scene& scene) {
  if (auto* pulse = std::get_if<Pulse>(&scene.excitation)) return pulse->amplitude;
  return support::harmonic(scene).amplitude;
}

peer::Scene peer_scene(const Question& question) {
  Scene scene = question.condition.scene;
  const double turn = 2.0 * std::numbers::pi;
  const auto* harmonic = std::get_if<Harmonic>(&scene.excitation);
  const double phase = harmonic != nullptr ? std::get<double>(harmonic->phase) : 0.0;
  const dynamics::Block block = mean_block(scene);
  const auto [left, right, height, gyration] = block.mass.value_or(
      dynamics::MassLayout{.left_edge = 0.5 * block.width,
                           .right_edge = 0.5 * block.width,
                           .centre_height = 0.5 * block.height,
                           .radius_of_gyration = std::hypot(block.width, block.height) / std::sqrt(12.0)});
  peer::Scene same{.edges = {left, right},
                   .height = height,
                   .gyration_squared = gyration * gyration,
                   .amplitude = mean_of(amplitude_of(scene)),
                   .frequency = support::mean_frequency_ratio(scene),
                   .phase = phase - turn * std::floor(phase / turn),
                   .pulse = harmonic == nullptr,
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
