// In normalised quantities neither the size of a block nor gravity has an effect: blocks of one shape move alike.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "rocking/realisation/trajectory.hpp"
#include "support/excitation.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using support::SplitMix;

/// How the base of a scene moves.
enum class Base { harmonic, recorded, recorded_with_vertical };

Condition random_condition(std::uint64_t number, std::int64_t periods) {
  SplitMix draw(number + 5'000'000);
  Condition condition;
  Scene& scene = condition.scene;
  scene.block = {.width = draw.uniform(0.2, 2.0), .height = 0.0, .gravity = draw.uniform(1.0, 10.0)};
  scene.block.height = mean_block(scene).width * std::exp2(draw.uniform(-0.5, 3.5));
  support::harmonic(scene).amplitude = draw.uniform(0.5, 7.0);
  support::harmonic(scene).frequency_ratio = draw.uniform(2.0, 12.0);
  support::harmonic(scene).phase = draw.uniform(0.0, 2.0 * std::numbers::pi);
  if (draw.below(4) != 0) {
    const double mu_s = draw.uniform(0.05, 0.9);
    scene.friction = Friction{.static_coefficient = mu_s, .kinetic_coefficient = mu_s * draw.uniform(0.3, 1.0)};
    scene.fluctuation = {.static_friction = 0.05 * mu_s, .kinetic_friction = 0.05 * mu_s};
    scene.initial.slip_rate = draw.uniform(-0.2, 0.2);
  }
  scene.fluctuation.restitution = 0.05;
  scene.initial.tilt = draw.uniform(-0.8, 0.8);
  const auto base = static_cast<Base>(number % 3);
  if (base == Base::harmonic) return condition;
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  GroundMotion motion{.samples = {}, .has_vertical = base == Base::recorded_with_vertical};
  const double period = 2.0 * std::numbers::pi / support::mean_frequency_ratio(scene);
  for (double tau = 0.0; tau < period * static_cast<double>(periods); tau += draw.uniform(0.05, 0.4) * period) {
    motion.samples.push_back(
        {tau / block.frequency_parameter, 5.0 * block.shape_angle * draw.uniform(-1.0, 1.0), draw.uniform(-0.6, 0.6)});
  }
  scene.excitation = support::recorded_by(std::move(motion), support::mean_frequency_ratio(scene));
  return condition;
}

/// Lengths times `size`, accelerations times `gravity`, times accordingly.
Condition scaled(Condition condition, double size, double gravity) {
  const dynamics::Block block = mean_block(condition.scene);
  condition.scene.block = {
      .width = block.width * size, .height = block.height * size, .gravity = block.gravity * gravity};
  auto* recorded = std::get_if<Recorded>(&condition.scene.excitation);
  if (recorded == nullptr) return condition;
  GroundMotion motion = *recorded->ground_motion;
  for (auto& sample : motion.samples) sample.time *= std::sqrt(size / gravity);
  recorded->ground_motion = std::make_shared<const GroundMotion>(std::move(motion));
  return condition;
}

/// Largest difference of two trajectories; 1e9 if their events differ.
double distance(const Trajectory& a, const Trajectory& b) {
  if (a.events.size() != b.events.size() || a.strobe.size() != b.strobe.size()) return 1e9;
  double largest = 0.0;
  const auto compare = [&largest](const auto& x, const auto& y) {
    for (const double difference :
         {x.tilt - y.tilt, x.tilt_rate - y.tilt_rate, x.slip - y.slip, x.slip_rate - y.slip_rate}) {
      largest = std::max(largest, std::abs(difference));
    }
  };
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    if (a.events[i].kind != b.events[i].kind) return 1e9;
    largest = std::max(largest, std::abs(a.events[i].tau - b.events[i].tau));
    compare(a.events[i], b.events[i]);
  }
  for (std::size_t i = 0; i < a.strobe.size(); ++i) compare(a.strobe[i], b.strobe[i]);
  return largest;
}

// For scales that are powers of 4 all products and roots are exact, so that no bit changes.
// Unchecked, since the scaled blocks are beyond the range of an experiment file.
TEST(Scaling, OfSizeAndGravityByPowersOfFourLeavesEveryBit) {
  for (std::uint64_t number = 0; number < 300; ++number) {
    const Condition condition = random_condition(number, 21);
    const Trajectory trajectory = trajectory_of(condition, 1, number, 20);
    for (const auto& [size, gravity] : {std::pair{4.0, 1.0}, {1.0, 16.0}, {0x1p-20, 64.0}, {0x1p40, 0x1p-10}}) {
      ASSERT_EQ(distance(trajectory, trajectory_of_unchecked(scaled(condition, size, gravity), 1, number, 20)), 0.0)
          << "scene " << number << ", size " << size << ", gravity " << gravity;
    }
  }
}

// Other scales round the shape angle and the times of the ground motion, each with a relative error of about 2^-53. The
// effect of such errors is measured by changing width and gravity by 1e-10 in both directions. Scenes in which this
// already changes the events, or the length of a chatter, are left out.
TEST(Scaling, ByAnyNumberChangesNoMoreThanRounding) {
  int compared = 0;
  for (std::uint64_t number = 0; number < 300; ++number) {
    const Condition condition = random_condition(number, 4);
    const Trajectory trajectory = trajectory_of(condition, 1, number, 3);
    double growth = 1.0;
    for (const double change : {1e-10, -1e-10}) {
      for (double dynamics::Block::*quantity : {&dynamics::Block::width, &dynamics::Block::gravity}) {
        Condition other = condition;
        dynamics::Block block = mean_block(condition.scene);
        block.*quantity *= 1.0 + change;
        other.scene.block = {.width = block.width, .height = block.height, .gravity = block.gravity};
        growth = std::max(growth, distance(trajectory, trajectory_of(other, 1, number, 3)) / 1e-10);
      }
    }
    if (growth > 1e6) continue;
    ++compared;
    for (const auto& [size, gravity] : {std::pair{3.7, 1.0}, {1.0, 1.62 / 9.81}, {0.01, 11.0}}) {
      ASSERT_LE(distance(trajectory, trajectory_of(scaled(condition, size, gravity), 1, number, 3)),
                growth * 200.0 * 0x1p-53)
          << "scene " << number << ", size " << size << ", gravity " << gravity << ", growth " << growth;
    }
  }
  EXPECT_GT(compared, 200);
}

}  // namespace
}  // namespace rocking
