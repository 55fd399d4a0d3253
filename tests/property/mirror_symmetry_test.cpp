// Left and right are alike: the mirror image of a motion is the motion of the mirror image, to the bit.

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"
#include "support/split_mix.hpp"

namespace rocking::dynamics {
namespace {

using support::ScriptedCoefficients;
using support::SplitMix;
using support::Stage;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

struct Scene {
  Stage stage;
  ScriptedCoefficients coefficients;
};

Scene random_scene(std::uint64_t number) {
  SplitMix draw(number + 1'000'000);
  Scene scene;
  scene.stage.block.height = std::exp2(draw.uniform(-0.5, 3.5));
  scene.stage.phase = draw.uniform(0.0, 2.0 * std::numbers::pi);
  scene.stage.periods = 20;
  scene.stage.inertia = draw.below(2) == 0 ? 1.0 / 3.0 : 4.0 / 3.0;
  scene.stage.rule = draw.below(2) == 0 ? ImpactSlipRule::absolute : ImpactSlipRule::signed_ratio;
  scene.coefficients.amplitude_value = draw.uniform(0.5, 10.0);
  const double mu_s = draw.uniform(0.05, 0.6);
  scene.coefficients.statics = {mu_s, mu_s * draw.uniform(0.5, 1.5), mu_s};
  // With the inertia about the edge a block near mu_k = mu_s can neither stick nor slip: not this test's business.
  const double share = scene.stage.inertia > 1.0 ? 0.3 : 1.0;
  scene.coefficients.kinetics = {share * 0.9 * mu_s, share * 0.7 * mu_s, share * 0.95 * mu_s};
  scene.coefficients.changes = {{.period = 2, .time = 0.1}, {.period = 3, .time = 0.0}};
  scene.coefficients.restitutions = {0.0, 0.1, -0.1};
  if (draw.below(2) == 0) return scene;
  const double psi = scene.stage.geometry().shape_angle;
  scene.stage.start = {.tilt = draw.uniform(-0.9, 0.9) * psi,
                       .tilt_rate = draw.uniform(-0.9, 0.9) * psi,
                       .slip_rate = draw.uniform(-0.2, 0.2)};
  return scene;
}

Scene mirrored(Scene scene) {
  scene.coefficients.amplitude_value = -scene.coefficients.amplitude_value;
  scene.stage.start.tilt = -scene.stage.start.tilt;
  scene.stage.start.tilt_rate = -scene.stage.start.tilt_rate;
  scene.stage.start.slip_rate = -scene.stage.start.slip_rate;
  return scene;
}

void expect_opposite(const State& one, const State& other) {
  ASSERT_EQ(one.tilt, -other.tilt);
  ASSERT_EQ(one.tilt_rate, -other.tilt_rate);
  ASSERT_EQ(one.slip, -other.slip);
  ASSERT_EQ(one.slip_rate, -other.slip_rate);
  ASSERT_EQ(one.contact, other.contact);
}

TEST(MirrorImage, OfAMotionIsTheMotionOfTheMirrorImageToTheBit) {
  for (std::uint64_t number = 0; number < 300; ++number) {
    const testing::ScopedTrace trace(__FILE__, __LINE__, "scene " + std::to_string(number));
    const Scene scene = random_scene(number);
    const Scene other_scene = mirrored(scene);
    ScriptedRun one(scene.stage, scene.coefficients);
    ScriptedRun other(other_scene.stage, other_scene.coefficients);
    one.run();
    other.run();
    ASSERT_EQ(one.log.story(), other.log.story());
    for (std::size_t k = 0; k < one.log.events.size(); ++k) {
      ASSERT_EQ(one.log.events[k].tau, other.log.events[k].tau) << "event " << k;
      expect_opposite(one.log.events[k].state, other.log.events[k].state);
      if (HasFatalFailure()) return;
    }
    ASSERT_EQ(one.log.strobes.size(), other.log.strobes.size());
    for (std::size_t k = 0; k < one.log.strobes.size(); ++k) {
      expect_opposite(one.log.strobes[k], other.log.strobes[k]);
      if (HasFatalFailure()) return;
    }
    ASSERT_EQ(one.counts.steps, other.counts.steps);
    ASSERT_EQ(one.motion.coefficients().stops, other.motion.coefficients().stops);
  }
}

}  // namespace
}  // namespace rocking::dynamics
