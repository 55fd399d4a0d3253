#include "rocking/ensemble/reduction.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace rocking {
namespace {

Summary named(const section::ResponseMode& mode, double held) {
  Summary summary;
  summary.mode = mode;
  summary.held = held;
  return summary;
}

/// A random condition with this number of realisations.
Condition random_condition(std::uint64_t realisations) {
  Condition condition;
  condition.scene.fluctuation.restitution = 0.01;
  condition.realisations = realisations;
  return condition;
}

TEST(Reduction, ListsWhatSettledLateAndTheLeastShareThatANameRestsOn) {
  const Condition condition = random_condition(4);
  Reduction reduction(condition);
  Summary jumped = named({}, 0.0);
  jumped.reason = section::Reason::phase_jump;
  for (const Summary& summary : {named(section::periodic(1, 1), 1.0), named(section::periodic(1, 3), 0.625), jumped,
                                 named(section::periodic(1, 3), 0.875)}) {
    reduction.add(summary);
  }
  const Validity validity = reduction.result().validity;
  EXPECT_EQ(validity.settled_late.count, 2U);
  EXPECT_EQ(validity.settled_late.first, (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(validity.least_held, 0.625);
  EXPECT_EQ(validity.unresolved.at(section::Reason::phase_jump).count, 1U);
}

TEST(Reduction, SummarisesTheExponentsOfTheRealisationsThatHaveOne) {
  const Condition condition = random_condition(6);
  Reduction reduction(condition);
  EXPECT_FALSE(reduction.result().exponents);
  reduction.add(named(section::periodic(1, 1), 1.0));
  EXPECT_FALSE(reduction.result().exponents);
  for (const double exponent : {0.25, -0.5, 0.75, 0.5, 1.0}) {
    Summary summary = named({section::ResponseKind::chaotic}, 1.0);
    summary.exponent = exponent;
    summary.exponent_error = exponent == 1.0 ? 0.4 : 0.2;
    reduction.add(summary);
    EXPECT_EQ(reduction.result().exponents.value().standard_error.has_value(), exponent != 0.25);
  }
  const Exponents found = reduction.result().exponents.value();
  EXPECT_DOUBLE_EQ(found.mean, 0.4);
  EXPECT_DOUBLE_EQ(found.standard_error.value(),
                   std::sqrt(1.325 / 20.0));  // squares 0.0225 + 0.81 + 0.1225 + 0.01 + 0.36
  EXPECT_DOUBLE_EQ(found.error_of_one, std::sqrt((4.0 * 0.04 + 0.16) / 5.0));
  EXPECT_EQ(found.quantiles.realisations, 5U);
  EXPECT_EQ(found.quantiles.levels.at(2).level, 0.5);
  EXPECT_EQ(found.quantiles.levels.at(2).value, 0.5);
}

/// A realisation that reached its horizon with these peaks.
Summary with_peaks(double tilt, double final_slip) {
  Summary summary = named(section::periodic(1, 1), 1.0);
  summary.left_ground_before_fall = false;
  summary.peaks = {.tilt = tilt,
                   .tilt_rate = 2.0 * tilt,
                   .slip = 3.0,
                   .slip_m = 6.0,
                   .final_slip = final_slip,
                   .final_slip_m = 2.0 * final_slip};
  return summary;
}

TEST(Reduction, CountsWhatOverturnedAsAboveEveryPeakAndNotAmongTheFinalSlips) {
  Condition condition = random_condition(5);
  condition.scene.friction = Friction{};
  Reduction reduction(condition);
  Summary fallen = with_peaks(6.4, 9.0);
  fallen.termination = dynamics::Termination::overturned;
  for (const Summary& summary : {with_peaks(0.5, -1.0), fallen, with_peaks(0.2, 1.0), with_peaks(0.7, 0.5), fallen}) {
    reduction.add(summary);
  }
  const PeakQuantiles peaks = reduction.result().peaks;
  EXPECT_EQ(peaks.tilt.realisations, 5U);
  EXPECT_EQ(peaks.tilt.beyond, 2U);
  EXPECT_EQ(peaks.tilt.levels.at(2).level, 0.5);
  EXPECT_EQ(peaks.tilt.levels.at(2).value, 0.7) << "the third of five";
  EXPECT_FALSE(peaks.tilt.levels.at(4).value) << "one that overturned";
  EXPECT_EQ(peaks.tilt_rate.levels.at(2).value, 1.4);
  EXPECT_EQ(peaks.slip.value().metres.at(2).value, 6.0);
  EXPECT_EQ(peaks.final_slip.value().over_half_diagonal.realisations, 3U);
  EXPECT_EQ(peaks.final_slip.value().over_half_diagonal.levels.at(2).value, 0.5);
}

/// A realisation that overturned to this side.
Summary fallen_to(dynamics::Side side) {
  Summary summary = named({section::ResponseKind::overturned}, 1.0);
  summary.termination = dynamics::Termination::overturned;
  summary.overturned_side = side;
  return summary;
}

TEST(Reduction, CountsOverturningToEachSide) {
  Condition condition = random_condition(60);
  condition.until = Until{.half_width = 0.4};
  Reduction reduction(condition);
  for (int i = 0; i < 7; ++i) reduction.add(fallen_to(i < 5 ? dynamics::Side::left : dynamics::Side::right));
  // A settled response that was left by overturning keeps its mode.
  Summary left = named(section::periodic(1, 1), 1.0);
  left.overturned_side = dynamics::Side::left;
  reduction.add(left);
  const ConditionResult result = reduction.result();
  EXPECT_EQ(result.overturned_left.value().probability.counts.successes, 5U);
  EXPECT_EQ(result.overturned_right.value().probability.counts.successes, 2U);
  EXPECT_EQ(result.overturned_right.value().probability.counts.trials, 8U);
  const Estimate& both = *result.estimate_of({section::ResponseKind::overturned});
  EXPECT_EQ(both.counts.successes, 7U);
  const stats::Interval anytime = result.overturned_left.value().probability.anytime.value();
  EXPECT_LT(anytime.low, 5.0 / 8.0);
  EXPECT_LT(anytime.high, 1.0);
  EXPECT_GT(anytime.high - anytime.low, 0.0);
}

TEST(Reduction, LetsNoUnresolvedResponseLowerTheLeastShare) {
  const Condition condition = random_condition(1);
  Reduction reduction(condition);
  reduction.add(named({}, 0.0));
  EXPECT_EQ(reduction.result().validity.least_held, 1.0);
  EXPECT_EQ(reduction.result().validity.settled_late.count, 0U);
}

}  // namespace
}  // namespace rocking
