// Fluctuations so large that most draws are clamped: their number follows the binomial law, and the run remains valid.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <boost/math/distributions/normal.hpp>
#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/stats/normality.hpp"
#include "support/excitation.hpp"
#include "support/false_alarms.hpp"

namespace rocking {
namespace {

using dynamics::Termination;

/// P(N(mean, sigma^2) < bound).
double below(double bound, double mean, double sigma) {
  return boost::math::cdf(boost::math::normal_distribution<double>(mean, sigma), bound);
}

double p_value(std::uint64_t count, std::uint64_t trials, double probability) {
  return stats::two_sided_binomial_p_value({.successes = count, .trials = trials}, probability);
}

bool is_finite(const RealisationResult& result) {
  return std::all_of(result.strobe.begin(), result.strobe.end(), [](const section::StrobePoint& point) {
    return std::isfinite(point.tilt) && std::isfinite(point.tilt_rate) && std::isfinite(point.slip_rate);
  });
}

/// A block that slides to the end; its speed is too high to stop.
Condition sliding(double sigma) {
  Condition condition;
  support::harmonic(condition.scene).frequency_ratio = 10.0;
  condition.scene.friction = Friction{.static_coefficient = 0.2, .kinetic_coefficient = 0.1};
  condition.scene.fluctuation.kinetic_friction = sigma;
  condition.scene.fluctuation.refreshes_per_period = 50;
  condition.scene.initial.slip_rate = 1e4;
  condition.horizon = {.transient_periods = 0, .sampled_periods = 400};
  return condition;
}

// Half of the draws are below 0 and nearly half above mu_s. V' = -(4/3) mu_k: the decrease of V shows the friction in
// force, clamped or not. It lies between that with all unclamped draws at 0 and that with all at mu_s.
TEST(ClampedKineticFriction, IsClampedAsOftenAsTheNormalLawSaysAndBrakesAccordingly) {
  support::FalseAlarms alarms;
  for (const double sigma : {0.3, 10.0, 1e6}) {
    const RealisationResult result = realise(sliding(sigma), 3, 1);
    EXPECT_EQ(result.termination, Termination::reached_horizon);
    const std::uint64_t intervals = result.operations.kinetic_friction_draws;
    EXPECT_GE(intervals, 400U * 50U);
    EXPECT_LE(intervals, 400U * 50U + 1U) << "perhaps that which begins at the horizon";
    EXPECT_GT(p_value(result.clamps.kinetic_at_zero, intervals, below(0.0, 0.1, sigma)), alarms.level()) << sigma;
    EXPECT_GT(p_value(result.clamps.kinetic_at_static, intervals, 1.0 - below(0.2, 0.1, sigma)), alarms.level())
        << sigma;
    if (sigma < 1.0) {  // the twin that must fail: another standard deviation
      EXPECT_LT(p_value(result.clamps.kinetic_at_zero, intervals, below(0.0, 0.1, 0.8 * sigma)), support::false_alarm);
    }
    EXPECT_GT(result.clamps.kinetic_at_zero + result.clamps.kinetic_at_static, intervals / 2) << sigma;
    const double interval = 2.0 * 3.141592653589793 / 10.0 / 50.0;
    const double lost = (1e4 - result.strobe.back().slip_rate) / (4.0 / 3.0 * interval);  // sum of mu_k
    const auto at_static = static_cast<double>(result.clamps.kinetic_at_static);
    const auto at_zero = static_cast<double>(result.clamps.kinetic_at_zero);
    const double rounding = static_cast<double>(intervals) * 1e4 * 0x1p-53 / (4.0 / 3.0 * interval);
    EXPECT_GE(lost, 0.2 * (at_static - 1.0) - rounding) << sigma;
    EXPECT_LE(lost, 0.2 * (static_cast<double>(intervals) - at_zero) + rounding) << sigma;
  }
}

TEST(ClampedAmplitude, IsHeldAtZeroInHalfThePeriods) {
  support::FalseAlarms alarms;
  Condition condition = sliding(0.0);
  support::harmonic(condition.scene).amplitude = 0.5;
  condition.scene.fluctuation.amplitude = 100.0;
  condition.horizon.sampled_periods = 5'000;
  const RealisationResult result = realise(condition, 3, 1);
  EXPECT_EQ(result.termination, Termination::reached_horizon);
  EXPECT_GT(p_value(result.clamps.amplitude_at_zero, result.operations.amplitude_draws, below(0.0, 0.5, 100.0)),
            alarms.level());
  EXPECT_NEAR(static_cast<double>(result.operations.amplitude_draws), 5'000.0, 1.0);
  // A whole period of the sine does not change V, however large it is: only friction has an effect.
  EXPECT_NEAR(result.strobe.back().slip_rate, 1e4 - 4.0 / 3.0 * 0.1 * 5'000.0 * 0.6283185307179586, 1e-6);
}

// e is drawn at each impact, and the base keeps the block rocking. At its bounds e loses almost no energy, or makes the
// block turn about the same edge again.
TEST(ClampedRestitution, IsHeldWithinItsBoundsInNearlyEveryImpact) {
  support::FalseAlarms alarms;
  Condition condition = support::shaken(1.5);
  condition.scene.fluctuation.restitution = 100.0;
  condition.horizon = {.transient_periods = 0, .sampled_periods = 300};
  std::uint64_t clamped = 0;
  std::uint64_t drawn = 0;
  for (std::uint64_t realisation = 0; realisation < 20; ++realisation) {
    const RealisationResult result = realise(condition, 3, realisation);
    EXPECT_NE(result.termination, Termination::stopped) << realisation;
    EXPECT_TRUE(is_finite(result)) << realisation;
    clamped += result.clamps.restitution;
    drawn += result.operations.restitution_draws;
  }
  EXPECT_GT(drawn, 1'000U);
  EXPECT_GT(p_value(clamped, drawn, 1.0 - (below(1.0, 0.0, 100.0) - below(-0.999, 0.0, 100.0))), alarms.level());
}

// All fluctuations at once, on a block that rocks and slides: 0 <= mu_k <= mu_s whatever was drawn.
TEST(ClampedEverything, LeavesARunThatIsOne) {
  support::FalseAlarms alarms;
  Condition condition = support::shaken(3.0, Friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.3});
  condition.scene.fluctuation = {.static_friction = 50.0,
                                 .kinetic_friction = 50.0,
                                 .refreshes_per_period = 50,
                                 .restitution = 50.0,
                                 .amplitude = 10.0};
  condition.horizon = {.transient_periods = 0, .sampled_periods = 60};
  Clamps clamps;
  OperationCounts operations;
  int painleve = 0;
  for (std::uint64_t realisation = 0; realisation < 200; ++realisation) {
    const RealisationResult result = realise(condition, 3, realisation);
    EXPECT_NE(result.termination, Termination::stopped) << realisation;
    EXPECT_TRUE(is_finite(result)) << realisation;
    EXPECT_EQ(digest_of(result, 0), digest_of(realise(condition, 3, realisation), 0)) << realisation;
    painleve += result.termination == Termination::painleve ? 1 : 0;
    clamps += result.clamps;
    operations += result.operations;
  }
  EXPECT_GT(p_value(clamps.static_at_zero, operations.static_friction_draws, below(0.0, 0.35, 50.0)), alarms.level());
  EXPECT_GT(clamps.kinetic_at_zero + clamps.kinetic_at_static, operations.kinetic_friction_draws / 2);
  EXPECT_GE(painleve, 5) << "a draw of 50 has no answer where it meets a slip against the tilt: said, not hidden";
}

}  // namespace
}  // namespace rocking
