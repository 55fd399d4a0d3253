// The Lyapunov exponent from tangent vectors, compared with known values.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "rocking/realisation/exponent.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

constexpr std::int64_t transient = 300;
constexpr std::int64_t sampled_periods = 120;

class CountedImpacts final : public dynamics::Observer {
 public:
  void event(dynamics::EventKind kind, double, const dynamics::State&) override {
    if (kind == dynamics::EventKind::impact_stick) ++impacts_;
  }
  void strobe(const dynamics::State&) override {}
  [[nodiscard]] int impacts() const { return impacts_; }

 private:
  int impacts_ = 0;
};

Condition rocking_block(double amplitude) {
  Condition condition = support::shaken(amplitude);
  condition.scene.initial.tilt = 0.2;
  return condition;
}

Motion after_transient(const Condition& condition, dynamics::Observer& observer) {
  const random::Draws draws(0x2012, 0);
  const Beginning beginning =
      begin_realisation(condition, draws, start_of(condition.scene, draws), Strobe::poincare, transient);
  auto motion = motion_of(condition.scene, beginning, observer);
  integrate::advance(motion);
  return motion;
}

/// Of a window that is run `times` as long as it is, up to eight times.
ExponentRun exponent_run_of(Motion motion, std::int64_t times = 1) {
  const double shape_angle = motion.setting().block.shape_angle;
  TangentRun run(motion, shape_angle, sampled_periods);
  std::int64_t left = times;
  section::PendingClassification pending;
  pending.may_be_decided_later = [&left](const section::ExponentEstimate&) { return (left /= 2) > 0; };
  run_alone(run, pending);
  return run.result();
}

ExponentRun exponent_run_of(const Condition& condition, std::int64_t times = 1) {
  CountedImpacts impacts;
  return exponent_run_of(after_transient(condition, impacts), times);
}

/// Between impacts the motion preserves areas of (theta, w). An impact that changes w to r w contracts them by r^2: a
/// factor r from the map itself, another from the earlier arrival of faster motions. If the multipliers of an orbit are
/// a complex pair, each has half of the contraction.
class LyapunovExponent : public testing::TestWithParam<double> {};

TEST_P(LyapunovExponent, OfAPeriodicMotionIsTheContractionOfItsImpacts) {
  const Condition condition = rocking_block(GetParam());
  CountedImpacts impacts;
  Motion motion = after_transient(condition, impacts);
  const int before = impacts.impacts();
  motion.extend(sampled_periods);
  integrate::advance(motion);
  const double each_period = static_cast<double>(impacts.impacts() - before) / static_cast<double>(sampled_periods);
  const double kept = 1.0 - dynamics::impact_loss(0.0, dynamics::geometry_of(mean_block(condition.scene)));
  const auto exponent = exponent_run_of(condition, 8).exponent;
  ASSERT_TRUE(exponent.has_value());
  EXPECT_NEAR(exponent->exponent, each_period * std::log(kept), 2.0 * exponent->standard_error);
  EXPECT_LT(exponent->standard_error, 0.2 * std::abs(exponent->exponent));
}

INSTANTIATE_TEST_SUITE_P(LyapunovExponent, LyapunovExponent, testing::Values(2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0));

TEST(TangentRun, GoesOnForEightTimesAsLongWhereNothingMoves) {
  Condition condition = rocking_block(0.5);
  condition.scene.initial.tilt = 0.0;
  const ExponentRun run = exponent_run_of(condition);
  EXPECT_FALSE(run.exponent.has_value());
  EXPECT_TRUE(run.stayed_unclear);
  EXPECT_EQ(run.points.size(), 8U * sampled_periods);
}

// The points of more periods are wanted for another question than the sign.
TEST(TangentRun, KeepsTheExponentThatDecidedWhileItCollectsMorePoints) {
  CountedImpacts impacts;
  const Motion motion = after_transient(rocking_block(4.0), impacts);
  TangentRun run(motion, motion.setting().block.shape_angle, sampled_periods);
  section::PendingClassification pending;
  pending.may_be_decided_later = [](const section::ExponentEstimate&) { return false; };
  pending.wants_more_points = [](const section::LongSection&) { return true; };
  run_alone(run, pending);
  const ExponentRun found = run.result();
  const ExponentRun decided = exponent_run_of(motion, 1);
  EXPECT_EQ(found.points.size(), 8U * sampled_periods);
  EXPECT_FALSE(found.stayed_unclear);
  EXPECT_EQ(found.exponent->exponent, decided.exponent->exponent);
  EXPECT_EQ(found.exponent->standard_error, decided.exponent->standard_error);
  EXPECT_NE(found.over_all->exponent, decided.exponent->exponent);
}

TEST(TangentRun, GoesOnWhileTheExponentDecidesNothing) {
  CountedImpacts impacts;
  const Motion motion = after_transient(rocking_block(4.0), impacts);
  for (const std::int64_t times : {1, 2, 4, 8, 16}) {
    const ExponentRun run = exponent_run_of(motion, times);
    EXPECT_EQ(run.points.size(), static_cast<std::uint64_t>(std::min<std::int64_t>(times, 8)) * sampled_periods);
    EXPECT_EQ(run.stayed_unclear, times == 16);
  }
}

TEST(TangentRun, EndsWithTheMotion) {
  CountedImpacts impacts;
  Motion motion = after_transient(rocking_block(4.0), impacts);
  static_cast<void>(motion.displace({.tilt_rate = 5.0}));
  const ExponentRun run = exponent_run_of(motion);
  EXPECT_FALSE(run.exponent.has_value());
  EXPECT_LT(run.points.size(), sampled_periods);
}

/// A block that slides and never rocks.
Condition sliding_block(double amplitude, const Friction& friction) {
  Condition condition = rocking_block(amplitude);
  condition.scene.initial.tilt = 0.0;
  condition.scene.friction = friction;
  return condition;
}

// A block that stops in each period forgets where it was.
TEST(TangentRun, CountsALostMemoryAsTheLeastGrowth) {
  const auto exponent =
      exponent_run_of(sliding_block(0.8, {.static_coefficient = 0.15, .kinetic_coefficient = 0.13})).exponent;
  ASSERT_TRUE(exponent.has_value());
  EXPECT_NEAR(exponent->exponent, std::log(1e-9), 1e-9);
}

// A change of V is multiplied by (alpha - mu)/(alpha + mu) where V changes its sign: in 960 periods by less than the
// least double.
TEST(TangentRun, DoesNotRunOutOfTheRangeOfNumbers) {
  const Condition condition = sliding_block(1.2, {.static_coefficient = 0.13, .kinetic_coefficient = 0.11});
  const ExponentRun window = exponent_run_of(condition);
  const ExponentRun longest = exponent_run_of(condition, 8);
  ASSERT_TRUE(window.exponent && longest.exponent);
  EXPECT_LT(longest.exponent->exponent * static_cast<double>(longest.points.size()), -1000.0);
  EXPECT_NEAR(longest.exponent->exponent, window.exponent->exponent, 1e-10);
}

}  // namespace
}  // namespace rocking
