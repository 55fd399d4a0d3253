// Left and right are equivalent: the mirror image of a motion is the motion of the mirror image, to the bit. The mirror
// image of a block with unequal edges has them exchanged.

#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "property/scene.hpp"
#include "support/event_log.hpp"
#include "support/split_mix.hpp"

namespace rocking::dynamics {
namespace {

using property::Base;
using property::random_mass;
using property::random_record;
using property::Scene;
using property::with_simulation;
using support::SplitMix;

Scene random_setting(std::uint64_t number) {
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
  // With the inertia about the edge, a block near mu_k = mu_s can neither stick nor slip; that is not tested here.
  const double share = scene.stage.inertia > 1.0 ? 0.3 : 1.0;
  scene.coefficients.kinetics = {share * 0.9 * mu_s, share * 0.7 * mu_s, share * 0.95 * mu_s};
  scene.coefficients.changes = {{.period = 2, .time = 0.1}, {.period = 3, .time = 0.0}};
  scene.coefficients.restitutions = {0.0, 0.1, -0.1};
  if (number % 2 == 1) {
    scene.stage.block.mass = random_mass(draw);
    scene.stage.rule = ImpactSlipRule::absolute;
  }
  scene.base = static_cast<Base>(number % 3);
  if (scene.base != Base::harmonic) scene.knots = random_record(scene.stage, 21.0, draw);
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
  if (scene.stage.block.mass) std::swap(scene.stage.block.mass->left_edge, scene.stage.block.mass->right_edge);
  return scene;
}

void expect_opposite(const State& one, const State& other) {
  ASSERT_EQ(one.tilt, -other.tilt);
  ASSERT_EQ(one.tilt_rate, -other.tilt_rate);
  ASSERT_EQ(one.slip, -other.slip);
  ASSERT_EQ(one.slip_rate, -other.slip_rate);
  ASSERT_EQ(one.contact, other.contact);
}

struct Account {
  support::EventLog log;
  std::uint64_t steps;
  std::size_t stops;
};

Account account_of(const Scene& scene) {
  Account account{};
  with_simulation(scene, [&account](auto& run) {
    run.run();
    account = {run.log, run.counts.steps, run.motion.coefficients().stops};
  });
  return account;
}

// Under reflection the vertical base motion is unchanged and the amplitude of the horizontal one changes its sign.
TEST(MirrorImage, OfAMotionIsTheMotionOfTheMirrorImageToTheBit) {
  for (std::uint64_t number = 0; number < 600; ++number) {
    const testing::ScopedTrace trace(__FILE__, __LINE__, "scene " + std::to_string(number));
    const Scene scene = random_setting(number);
    const Account one = account_of(scene);
    const Account other = account_of(mirrored(scene));
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
    ASSERT_EQ(one.steps, other.steps);
    ASSERT_EQ(one.stops, other.stops);
  }
}

}  // namespace
}  // namespace rocking::dynamics
