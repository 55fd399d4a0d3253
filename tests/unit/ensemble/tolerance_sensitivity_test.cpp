// Numerical error of the probabilities, compared with their sampling error.

#include "rocking/ensemble/result.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace rocking {
namespace {

/// A condition with this half-width of its widest simultaneous interval, and this share of flips among its reruns.
ConditionResult condition(double half_width, stats::Proportion flips) {
  ConditionResult result;
  ModeEstimate narrow;
  narrow.probability.simultaneous = {.low = 0.0, .high = half_width};
  ModeEstimate wide;
  wide.probability.simultaneous = {.low = 0.3, .high = 0.3 + 2.0 * half_width};
  result.modes = {narrow, wide, narrow};
  result.non_recurrence.emplace();
  result.non_recurrence->arithmetic_flips = flips;
  return result;
}

TEST(ToleranceSensitivity, AddsUpAllConditionsAndTakesTheNarrowest) {
  const std::vector<ConditionResult> conditions{condition(0.05, {1, 40}), condition(0.03, {0, 50}), ConditionResult{}};
  const auto floor = tolerance_sensitivity(conditions, 0.95);
  ASSERT_TRUE(floor.has_value());
  EXPECT_EQ(floor->flips.successes, 1U);
  EXPECT_EQ(floor->flips.trials, 90U);
  EXPECT_DOUBLE_EQ(floor->half_width, 0.03);
  EXPECT_DOUBLE_EQ(floor->interval.high, stats::clopper_pearson({1, 90}, 0.95).high);
}

TEST(ToleranceSensitivity, IsAbsentWhereNothingWasRerun) {
  EXPECT_FALSE(tolerance_sensitivity(std::vector{ConditionResult{}, condition(0.1, {0, 0})}, 0.95).has_value());
}

// A fifth of 0.05 is 0.01: 0 of 1000 is shown to be below it, 0 of 100 is undecided, 30 of 1000 is shown to be above
// it.
TEST(ToleranceSensitivity, IsJudgedByBothEndsOfItsInterval) {
  const auto noise = [](stats::Proportion flips) {
    return tolerance_sensitivity(std::vector{condition(0.05, flips)}, 0.95)->noise;
  };
  EXPECT_EQ(noise({0, 1000}), NumericalError::small);
  EXPECT_EQ(noise({0, 100}), NumericalError::undecided);
  EXPECT_EQ(noise({2, 200}), NumericalError::undecided);
  EXPECT_EQ(noise({30, 1000}), NumericalError::not_small);
}

}  // namespace
}  // namespace rocking
