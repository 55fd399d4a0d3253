// N <= 0 in full contact, where N = (4/3)(1 + alpha_v): the base accelerates downwards faster than the block can fall
// (lib/docs/model.md, 7).

#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "support/excitation.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using dynamics::ContactState;
using dynamics::EventKind;
using dynamics::Termination;

/// A sample at a normalised time; accelerations in g.
struct Knot {
  double tau;
  double vertical;
  double horizontal = 0.0;
};

/// The reference block on a base that moves as given by the knots; strobe points a time 1 apart.
Condition on_base(const std::vector<Knot>& knots) {
  Condition condition;
  const double p = dynamics::geometry_of(mean_block(condition.scene)).frequency_parameter;
  GroundMotion motion{.samples = {}, .has_vertical = true};
  for (const Knot& knot : knots) motion.samples.push_back({knot.tau / p, knot.horizontal, knot.vertical});
  condition.scene.excitation = support::recorded_by(std::move(motion), 2.0 * 3.141592653589793);
  condition.horizon = {.transient_periods = 0, .sampled_periods = 10};
  return condition;
}

Condition with_friction(Condition condition, double mu_s, double mu_k) {
  condition.scene.friction = Friction{.static_coefficient = mu_s, .kinetic_coefficient = mu_k};
  return condition;
}

std::vector<EventKind> kinds_of(const Trajectory& trajectory) {
  std::vector<EventKind> kinds;
  for (const TrajectoryEvent& event : trajectory.events) kinds.push_back(event.kind);
  return kinds;
}

/// 1 + alpha_v = 1, then down to 1 + depth at 2, up to 1 at 3, down to 1 + depth at 4, up to 1 at 5.
std::vector<Knot> two_dips(double depth) {
  return {{0.0, 0.0}, {1.0, 0.0}, {2.0, depth}, {3.0, 0.0}, {4.0, depth}, {5.0, 0.0}};
}

// With mu_s = 0 and alpha = 0 there is no friction to exceed and no horizontal force, so that full contact persists for
// any weight.
TEST(LossOfContactAtRest, IsCountedAtEachDownwardCrossingThoughTheBlockStaysAtRest) {
  const Condition condition = with_friction(on_base(two_dips(-2.0)), 0.0, 0.0);
  const RealisationResult result = realise(condition, 0, 0);
  EXPECT_EQ(result.losses_of_contact, 2U);
  EXPECT_NEAR(result.first_loss_of_contact, 1.5, 1e-14) << "1 + alpha_v = 1 - 2 (tau - 1)";
  EXPECT_EQ(result.termination, Termination::reached_horizon);
  const Trajectory trajectory = trajectory_of(condition, 0, 0, 10);
  EXPECT_TRUE(trajectory.events.empty());
  EXPECT_EQ(trajectory.strobe.back().contact, ContactState::rest);
}

/// Released on a base at rest. With cos(phi) = c it has N = 1/3 - 2 c + 3 c^2 - c E, E the kinetic energy w^2 that it
/// would have at phi = 0: N falls below 0 at c near 1/3 if E > 0.
Condition released(double tilt, double tilt_rate) {
  Condition condition = support::shaken(0.0);
  condition.scene.initial = {.tilt = tilt, .tilt_rate = tilt_rate, .slip_rate = 0.0};
  condition.horizon = {.transient_periods = 0, .sampled_periods = 40};
  return condition;
}

TEST(LossOfContactInAFall, IsToldFromOneBefore) {
  const RealisationResult fall = realise(released(1.1, 1.0), 0, 0);
  ASSERT_EQ(fall.termination, Termination::overturned);
  EXPECT_EQ(fall.losses_of_contact, 1U);
  EXPECT_EQ(fall.losses_before_fall, 0U);
  const RealisationResult thrown = realise(released(0.0, 5.0), 0, 0);  // w^2 cos(psi) = 1.45 > 4/3
  ASSERT_EQ(thrown.termination, Termination::overturned);
  EXPECT_GE(thrown.losses_of_contact, 1U);
  EXPECT_GE(thrown.losses_before_fall, 1U) << "within balance";
  const RealisationResult stands = realise(with_friction(on_base(two_dips(-2.0)), 0.0, 0.0), 0, 0);
  EXPECT_EQ(stands.losses_before_fall, stands.losses_of_contact) << "no fall follows";
}

// The same loss beyond balance counts if the horizon comes before the fall: whether the block falls is not known.
TEST(LossOfContactInAFall, CountsWhereTheRunEndsBeforeTheFall) {
  Condition condition = released(1.1, 1.0);
  const double loss = realise(condition, 0, 0).first_loss_of_contact;
  support::harmonic(condition.scene).frequency_ratio = 6.283185307179586 / (loss * 1.001);
  condition.horizon.sampled_periods = 1;
  const RealisationResult cut = realise(condition, 0, 0);
  ASSERT_EQ(cut.termination, Termination::reached_horizon);
  EXPECT_EQ(cut.losses_before_fall, cut.losses_of_contact);
  EXPECT_EQ(cut.losses_of_contact, 1U);
}

TEST(LossOfContactAtRest, IsNoneWhereTheBaseFallsALittleMoreSlowlyThanTheBlock) {
  const double depth = -1.0 + 0x1p-50;
  EXPECT_EQ(realise(with_friction(on_base(two_dips(depth)), 0.0, 0.0), 0, 0).losses_of_contact, 0U);
}

TEST(LossOfContactAtRest, IsCountedWhereTheWeightVanishesForAnInstant) {
  const RealisationResult result = realise(with_friction(on_base(two_dips(-1.0)), 0.0, 0.0), 0, 0);
  EXPECT_EQ(result.losses_of_contact, 2U) << "N <= 0, not N < 0";
  EXPECT_NEAR(result.first_loss_of_contact, 2.0, 1e-14);
}

TEST(LossOfContactAtRest, IsCountedAtTheInstantOfAJump) {
  const RealisationResult result =
      realise(with_friction(on_base({{0.0, 0.0}, {1.25, 0.0}, {1.25, -1.5}, {1.5, -1.5}, {1.5, 0.0}}), 0.0, 0.0), 0, 0);
  EXPECT_EQ(result.losses_of_contact, 1U);
  EXPECT_NEAR(result.first_loss_of_contact, 1.25, 1e-15);
}

TEST(LossOfContactAtRest, IsCountedAtTheStart) {
  const RealisationResult result = realise(with_friction(on_base({{0.0, -1.5}, {1.0, -1.5}}), 0.0, 0.0), 0, 0);
  EXPECT_EQ(result.losses_of_contact, 1U);
  EXPECT_EQ(result.first_loss_of_contact, 0.0);
}

// From 1 + alpha_v = 0 on, abs(alpha) > min(tan(psi), mu_s)(1 + alpha_v): rest ends there, by a lift or by a slide,
// also without a horizontal force. The crossing is counted once, in whichever of the two states it is detected.
TEST(LossOfContactAtRest, EndsTheRestOfABlockThatNothingPushesSideways) {
  support::SplitMix random(20121104);
  for (int dip = 0; dip < 200; ++dip) {
    const double depth = random.uniform(-3.0, -1.1);
    const double instant = 1.0 - 1.0 / depth;
    const Condition falling = on_base({{0.0, 0.0}, {1.0, 0.0}, {2.0, depth}, {2.0, 0.0}});
    const struct {
      Condition condition;
      EventKind kind;
    } cases[]{{falling, EventKind::lift},
              {with_friction(falling, 0.4, 0.3), EventKind::lift},
              {with_friction(falling, 0.2, 0.2), EventKind::slide_start},
              {with_friction(falling, 0.2, 0.1), EventKind::slide_start}};
    for (const auto& [condition, kind] : cases) {
      const Trajectory trajectory = trajectory_of(condition, 0, 0, 10);
      ASSERT_FALSE(trajectory.events.empty()) << depth;
      EXPECT_EQ(trajectory.events[0].kind, kind) << depth;
      EXPECT_NEAR(trajectory.events[0].tau, instant, 1e-14) << depth;
      if (trajectory.events.size() > 1) {
        EXPECT_GT(trajectory.events[1].tau, 2.0 - 1e-12) << depth << ": it does not come back before the jump";
      }
      const RealisationResult result = realise(condition, 0, 0);
      EXPECT_EQ(result.losses_of_contact, 1U) << depth;
      EXPECT_NEAR(result.first_loss_of_contact, instant, 1e-14) << depth;
      EXPECT_NE(result.termination, Termination::stopped) << depth;
    }
  }
}

// V' = -s mu_k (4/3)(1 + alpha_v): by this equation friction accelerates the slip while N < 0. If 1 + alpha_v decreases
// to 1 + depth and returns within a time of 2, V changes by -(4/3) mu_k (2 + depth).
TEST(LossOfContactInSlide, IsCountedAndTheRunGoesOnWithTheEquationAsItStands) {
  constexpr double mu = 0.15;
  for (const double depth : {-0.5, -1.5, -4.0}) {
    Condition condition = with_friction(on_base(two_dips(depth)), 0.2, mu);
    condition.scene.initial.slip_rate = 9.0;
    const RealisationResult result = realise(condition, 0, 0);
    EXPECT_EQ(result.losses_of_contact, depth < -1.0 ? 2U : 0U) << depth;
    if (depth < -1.0) {
      EXPECT_NEAR(result.first_loss_of_contact, 1.0 - 1.0 / depth, 1e-14) << depth;
    }
    // A dozen roundings of numbers below 16.
    EXPECT_NEAR(result.strobe.at(9).slip_rate, 9.0 - 4.0 / 3.0 * mu * (10.0 + 2.0 * depth), 2e-14) << depth;
  }
}

// In full contact with N < 0, friction acts in the other direction and does not tip the block, however large mu_k is.
// The block tips as soon as it presses on the base: 1 + alpha_v = -1/2 until 1, then increases to 1 + height at 4.
TEST(LossOfContactInSlide, EndsInATipWhereKineticFrictionIsAboveTanPsi) {
  support::SplitMix random(20121105);
  for (int rise = 0; rise < 200; ++rise) {
    const double height = random.uniform(-0.5, 1.0);
    const double direction = rise % 2 == 0 ? 1.0 : -1.0;
    Condition condition = with_friction(on_base({{0.0, -1.5}, {1.0, -1.5}, {4.0, height}}), 0.6, 0.5);
    condition.scene.initial.slip_rate = direction * 9.0;
    condition.horizon.sampled_periods = 4;
    const Trajectory trajectory = trajectory_of(condition, 0, 0, 4);
    ASSERT_FALSE(trajectory.events.empty());
    EXPECT_EQ(trajectory.events[0].kind, EventKind::tip);
    EXPECT_NEAR(trajectory.events[0].tau, 1.0 + 1.5 / (1.5 + height), 1e-14) << height;
    EXPECT_LT(direction * trajectory.strobe.at(2).tilt, 0.0) << "over the leading edge";
    if (trajectory.events.size() > 1) {
      EXPECT_GT(trajectory.events[1].tau, trajectory.events[0].tau + 0.1) << height << ": it does not fall back";
    }
    const RealisationResult result = realise(condition, 0, 0);
    EXPECT_EQ(result.losses_of_contact, trajectory.losses_of_contact);
    EXPECT_EQ(result.first_loss_of_contact, 0.0);
  }
}

// Under a sufficiently large push, rocking would press on its edge although full contact does not (N = G + S w'
// sin(psi) > 0 > G), and would need more friction than is available; but slip could not tip the block. It slides,
// whatever mu_k is.
TEST(LossOfContactInSlide, FollowsAJumpInWhichNeitherLiftNorTipIsPossible) {
  for (const double mu_k : {0.1, 0.5}) {
    Condition condition =
        with_friction(on_base({{0.0, 0.0}, {1.0, 0.0}, {1.0, -1.1, 3.0}, {2.0, -1.1, 3.0}}), 0.5, mu_k);
    condition.horizon.sampled_periods = 2;
    const Trajectory trajectory = trajectory_of(condition, 0, 0, 2);
    EXPECT_EQ(trajectory.termination, Termination::reached_horizon) << mu_k;
    EXPECT_EQ(kinds_of(trajectory).at(0), EventKind::slide_start) << mu_k;
    EXPECT_NEAR(realise(condition, 0, 0).first_loss_of_contact, 1.0, 1e-15) << mu_k;
    // V' = -(4/3)(3 - mu_k (-0.1) (-1)): s = -1, G = (4/3)(-0.1).
    EXPECT_NEAR(trajectory.strobe.at(1).slip_rate, -4.0 / 3.0 * (3.0 + 0.1 * mu_k), 2e-15 * 4.0) << mu_k;
  }
}

// Whatever the base does, time advances and all numbers are finite.
TEST(LossOfContact, UnderRandomVerticalMotionNeverStopsARun) {
  support::SplitMix random(20121103);
  int lost = 0;
  for (int scene = 0; scene < 400; ++scene) {
    std::vector<Knot> knots{{0.0, 0.0, 0.0}};
    while (knots.back().tau < 6.0) {
      const double after = random.below(4) == 0 ? 0.0 : random.uniform(0.05, 1.0);
      const double push = random.below(3) == 0 ? 0.0 : random.uniform(-1.0, 1.0);
      knots.push_back({knots.back().tau + after, random.uniform(-2.5, 2.0), push});
    }
    Condition condition = on_base(knots);
    const double mu_s = random.below(5) == 0 ? 0.0 : random.uniform(0.0, 1.2);
    const double mu_k = random.below(3) == 0 ? mu_s : random.uniform(0.0, mu_s);
    if (random.below(5) != 0) condition = with_friction(condition, mu_s, mu_k);
    if (condition.scene.friction && random.below(2) == 0) condition.scene.initial.slip_rate = random.uniform(-2.0, 2.0);
    const RealisationResult result = realise(condition, 0, 0);
    EXPECT_NE(result.termination, Termination::stopped) << scene;
    EXPECT_LT(result.operations.steps, 20'000U) << scene;
    lost += result.losses_of_contact > 0 ? 1 : 0;
  }
  EXPECT_GT(lost, 200) << "the scenes are those that are meant";
}

}  // namespace
}  // namespace rocking
