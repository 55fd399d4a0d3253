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

/// A broken line of so many excitation periods, with jumps.
GroundMotion random_line(support::SplitMix& random, const dynamics::Geometry& block, double period, double periods) {
  GroundMotion motion;
  motion.has_vertical = random.below(2) == 0;
  const double size = support::spread(random, 0.5, 6.0) * block.shape_angle;
  double tau = random.uniform(0.0, 0.5) * period;
  while (tau < periods * period) {
    const double vertical = motion.has_vertical ? random.uniform(-0.6, 0.6) : 0.0;
    motion.samples.push_back({tau / block.frequency_parameter, random.uniform(-size, size), vertical});
    if (random.below(5) != 0) tau += random.uniform(0.05, 0.6) * period;
  }
  return motion;
}

/// A sine, half of them with a vertical sine.
void shake(support::SplitMix& random, double psi, double frequency, Harmonic& sine) {
  sine.amplitude = support::spread(random, 0.5, 12.0);
  sine.frequency_ratio = frequency;
  sine.phase = random.below(4) == 0 ? 0.0 : random.uniform(0.0, 6.0);
  if (random.below(2) != 0) return;
  VerticalHarmonic& vertical = sine.vertical.emplace();
  vertical.amplitude = random.uniform(0.1, 0.6) / psi;
  vertical.frequency_ratio = frequency * static_cast<double>(1 + random.below(3));
  vertical.phase = random.uniform(0.0, 6.0);
}

/// The base moves in a sine, in one cycle of a sine, or along a broken line.
void shake(support::SplitMix& random, std::int64_t periods, Scene& scene) {
  const double frequency = support::spread(random, 2.0, 20.0);
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  const int kind = random.below(3);
  if (kind == 0) return shake(random, block.shape_angle, frequency, scene.excitation.emplace<Harmonic>());
  if (kind == 1) {
    auto& pulse = scene.excitation.emplace<Pulse>();
    pulse.amplitude = support::spread(random, 1.0 + frequency, 2.0 + 2.0 * frequency * frequency);
    pulse.frequency_ratio = frequency;
    return;
  }
  const double period = 2.0 * std::numbers::pi / frequency;
  scene.excitation = support::recorded_by(random_line(random, block, period, static_cast<double>(periods)), frequency);
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

Question random_wall_question(std::uint64_t number) {
  support::SplitMix random(number);
  Question question{.condition = {}, .seed = random.bits(), .realisation = number, .periods = 5 + random.below(6)};
  Scene& scene = question.condition.scene;
  scene.block = {.width = 1.0, .height = support::spread(random, 1.2, 12.0)};
  if (random.below(2) == 0) scene.block.mass = random_mass(random);
  scene.block.wall = random.below(2) == 0 ? dynamics::Side::left : dynamics::Side::right;
  scene.restitution = WallRatio{random.below(8) == 0 ? 0.0 : random.uniform(0.05, 0.95)};
  if (random.below(3) == 0) scene.fluctuation.restitution = support::spread(random, 0.001, 0.1);
  shake(random, question.periods, scene);
  if (std::holds_alternative<Harmonic>(scene.excitation) && random.below(3) == 0)
    scene.fluctuation.amplitude = support::spread(random, 0.001, 0.1);
  const double open_side = mean_block(scene).open_side;
  if (random.below(3) != 0) {
    scene.initial.tilt = open_side * random.uniform(0.0, 0.9);
    scene.initial.tilt_rate = random.uniform(-1.0, 1.0);
  }
  return question;
}

Quantity& amplitude_of(Scene& scene) {
  if (auto* recorded = std::get_if<Recorded>(&scene.excitation)) return recorded->scale;
  if (auto* pulse = std::get_if<Pulse>(&scene.excitation)) return pulse->amplitude;
  return support::harmonic(scene).amplitude;
}

peer::Scene peer_scene(const Question& question) {
  Scene scene = question.condition.scene;
  const double turn = 2.0 * std::numbers::pi;
  const auto* harmonic = std::get_if<Harmonic>(&scene.excitation);
  const double phase = harmonic != nullptr ? std::get<double>(harmonic->phase) : 0.0;
  const auto* wall = std::get_if<WallRatio>(&scene.restitution);
  const double restitution = mean_of(wall != nullptr ? wall->value : std::get<Quantity>(scene.restitution));
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
                   .pulse = std::holds_alternative<Pulse>(scene.excitation),
                   .restitution = restitution,
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
                   .realisation = question.realisation,
                   .open_side = block.open_side,
                   .gravity = block.gravity};
  if (const VerticalHarmonic* vertical = vertical_of(scene.excitation)) {
    same.vertical = {.amplitude = mean_of(vertical->amplitude),
                     .frequency = mean_of(vertical->frequency_ratio),
                     .phase = mean_of(vertical->phase)};
  }
  if (const auto* recorded = std::get_if<Recorded>(&scene.excitation)) {
    for (const auto& [time, horizontal, up] : recorded->ground_motion->samples) {
      same.record.push_back({time, horizontal, up});
    }
  }
  if (scene.friction) same.friction = {mean_static(*scene.friction), mean_kinetic(*scene.friction)};
  return same;
}

}  // namespace rocking::differential
