// The least intensity that lifts the block, and which motion of a group it belongs to.

#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "rocking/studies/curves/stripes.hpp"
#include "rocking/studies/fragility/fragility.hpp"

namespace rocking {
namespace {

Scene scene_of(const Excitation& excitation) {
  Scene scene;
  scene.block = {.width = 0.35, .height = 1.6, .gravity = 9.81};
  scene.excitation = excitation;
  return scene;
}

Recorded recorded(double horizontal, double vertical, double scale) {
  Recorded motion;
  motion.ground_motion = std::make_shared<const GroundMotion>(
      GroundMotion{.samples = {{0.0, 0.0, 0.0}, {0.1, horizontal, vertical}, {0.2, 0.0, 0.0}}, .has_vertical = true});
  motion.scale = scale;
  return motion;
}

constexpr double tangent = 0.35 / 1.6;

TEST(LeastUplift, OfARecordIsWhereItsAccelerationReachesTheSlopeOfTheBlock) {
  // PGA 0.6 g at the scale 2 of a record with 0.3 g.
  EXPECT_NEAR(least_uplift(scene_of(recorded(-0.3, 0.0, 2.0)), 0.6).value(), tangent, 1e-15);
  // The same by the scale, with an upward acceleration that presses the block on the base: 0.3 s = tan (1 + 0.1 s).
  EXPECT_NEAR(least_uplift(scene_of(recorded(0.3, 0.1, 2.0)), 2.0).value(), tangent / (0.3 - 0.1 * tangent), 1e-14);
  EXPECT_EQ(least_uplift(scene_of(recorded(0.1, 1.0, 2.0)), 2.0), std::numeric_limits<double>::infinity());
}

TEST(LeastUplift, OfAnAmplitudeIsInItsUnit) {
  const dynamics::Geometry block = dynamics::geometry_of({.width = 0.35, .height = 1.6, .gravity = 9.81});
  Harmonic harmonic;
  harmonic.amplitude = 5.0;
  EXPECT_NEAR(least_uplift(scene_of(harmonic), 5.0).value(), tangent / block.shape_angle, 1e-14);
  Pulse pulse;
  pulse.physical_amplitude = PhysicalAmplitude{.value = 3.0, .unit = AccelerationUnit::m_s2};
  EXPECT_NEAR(least_uplift(scene_of(pulse), 3.0).value(), tangent * 9.81, 1e-13);
  pulse.physical_amplitude->unit = AccelerationUnit::gravity;
  EXPECT_NEAR(least_uplift(scene_of(pulse), 3.0).value(), tangent, 1e-14);
}

// Where the static friction is below tan(psi) it slides first; a record moves it at 0.15 g.
TEST(LeastSliding, IsWhereTheAccelerationReachesTheLeastFrictionOrLiftsTheBlock) {
  Scene scene = scene_of(recorded(-0.3, 0.0, 2.0));
  EXPECT_EQ(least_sliding(scene, 0.6), least_uplift(scene, 0.6));
  scene.friction = Friction{.static_coefficient = Uniform{.low = 0.15, .high = 0.4}, .kinetic_coefficient = 0.1};
  EXPECT_NEAR(least_sliding(scene, 0.6).value(), 0.15, 1e-15);
  EXPECT_NEAR(least_uplift(scene, 0.6).value(), tangent, 1e-15);
  scene.friction->static_coefficient = 0.5;
  EXPECT_EQ(least_sliding(scene, 0.6), least_uplift(scene, 0.6));
  scene.fluctuation.static_friction = 0.1;
  EXPECT_FALSE(least_sliding(scene, 0.6));
  Pulse pulse;
  pulse.physical_amplitude = PhysicalAmplitude{.value = 3.0, .unit = AccelerationUnit::m_s2};
  scene = scene_of(pulse);
  scene.friction = Friction{.static_coefficient = 0.1, .kinetic_coefficient = 0.1};
  EXPECT_NEAR(least_sliding(scene, 3.0).value(), 0.1 * 9.81, 1e-14);
}

TEST(LeastUplift, IsThatOfTheMostSlenderBlockThatMayBeDrawn) {
  Scene scene = scene_of(recorded(0.3, 0.0, 1.0));
  scene.block.width = Uniform{.low = 0.3, .high = 0.4};
  EXPECT_NEAR(least_uplift(scene, 0.3).value(), 0.3 / 1.6, 1e-15);
}

// The left edge comes nearest in one block, the right one in another; a record to either side lifts the most slender one.
TEST(LeastUplift, OfADrawnOffsetIsThatOfTheSideToWhichTheRecordPushes) {
  for (const double push : {0.5, -0.5}) {
    Scene scene = scene_of(recorded(push, 0.0, 1.0));
    scene.block = {.width = 0.8, .height = 2.0, .mass = GivenCentre{.offset = Uniform{.low = -0.1, .high = 0.2}}};
    EXPECT_NEAR(least_uplift(scene, 0.5).value(), push > 0.0 ? 0.3 : 0.2, 1e-15) << push;
  }
}

TEST(LeastUplift, IsNotKnownOfABlockThatDoesNotStartAtRestOrOfARandomAmplitude) {
  for (Quantity InitialState::*number : {&InitialState::tilt, &InitialState::tilt_rate, &InitialState::slip_rate}) {
    Scene scene = scene_of(recorded(0.3, 0.0, 1.0));
    scene.initial.*number = 0.1;
    EXPECT_FALSE(least_uplift(scene, 0.3));
    scene.initial.*number = Normal{.mean = 0.0, .sigma = 0.1};
    EXPECT_FALSE(least_uplift(scene, 0.3));
  }
  Scene scene = scene_of(Harmonic{});
  scene.fluctuation.amplitude = 0.1;
  EXPECT_FALSE(least_uplift(scene, 1.0));
}

TEST(LeastUplift, OfAGroupIsTheLeastOfItsMotions) {
  const double never = std::numeric_limits<double>::infinity();
  const auto of = [](const std::vector<std::optional<double>>& uplifts) {
    StripeGroup group;
    for (const auto& uplift : uplifts) group.stripes.emplace_back().uplift = uplift;
    return group.least_uplift({});
  };
  EXPECT_EQ(of({0.3, 0.2, never}), 0.2);
  EXPECT_EQ(of({0.3, std::nullopt}), std::nullopt);
  EXPECT_EQ(of({never, never}), std::nullopt);
}

}  // namespace
}  // namespace rocking
