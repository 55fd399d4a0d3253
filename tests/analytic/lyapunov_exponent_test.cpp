// The Lyapunov exponent from a reference and a perturbed trajectory, compared with known values.

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
  Condition condition;
  support::harmonic(condition.scene).amplitude = amplitude;
  support::harmonic(condition.scene).frequency_ratio = 10.0;
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

ExponentRun perturbed_pair_of(const Condition& condition) {
  CountedImpacts impacts;
  PerturbedPair pair(after_transient(condition, impacts),
                     dynamics::geometry_of(mean_block(condition.scene)).shape_angle, sampled_periods);
  run_alone(pair);
  return pair.result();
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
  const auto exponent = perturbed_pair_of(condition).exponent;
  ASSERT_TRUE(exponent.has_value());
  EXPECT_NEAR(exponent->exponent, each_period * std::log(kept), 2.0 * exponent->standard_error);
  EXPECT_LT(exponent->standard_error, 0.2 * std::abs(exponent->exponent));
}

INSTANTIATE_TEST_SUITE_P(LyapunovExponent, LyapunovExponent, testing::Values(2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0));

TEST(PerturbedPair, GoOnForEightTimesAsLongWhereNothingMoves) {
  Condition condition = rocking_block(0.5);
  condition.scene.initial.tilt = 0.0;
  const ExponentRun run = perturbed_pair_of(condition);
  EXPECT_FALSE(run.exponent.has_value());
  EXPECT_EQ(run.periods, 2U * 8U * sampled_periods);
}

TEST(PerturbedPair, EndWithTheMotion) {
  Condition condition = rocking_block(4.0);
  CountedImpacts impacts;
  Motion motion = after_transient(condition, impacts);
  const double shape_angle = dynamics::geometry_of(mean_block(condition.scene)).shape_angle;
  static_cast<void>(motion.displace({.tilt_rate = 5.0}));
  PerturbedPair pair(motion, shape_angle, sampled_periods);
  run_alone(pair);
  EXPECT_EQ(pair.reference().termination(), dynamics::Termination::overturned);
  EXPECT_FALSE(pair.result().exponent.has_value());
  EXPECT_LT(pair.result().periods, 2U * sampled_periods);
}

}  // namespace
}  // namespace rocking
