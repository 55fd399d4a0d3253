// What arithmetic does, beside what chance does.

#include "rocking/experiment/noise_floor.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace rocking::experiment {
namespace {

/// A condition whose widest simultaneous interval is so wide, with so many modes changed of those that were repeated.
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

TEST(NoiseFloor, AddsUpAllConditionsAndTakesTheNarrowest) {
  const std::vector<ConditionResult> conditions{condition(0.05, {1, 40}), condition(0.03, {0, 50}), ConditionResult{}};
  const auto floor = noise_floor(conditions, 0.95);
  ASSERT_TRUE(floor.has_value());
  EXPECT_EQ(floor->flips.successes, 1U);
  EXPECT_EQ(floor->flips.trials, 90U);
  EXPECT_DOUBLE_EQ(floor->half_width, 0.03);
  EXPECT_DOUBLE_EQ(floor->interval.high, stats::clopper_pearson({1, 90}, 0.95).high);
}

TEST(NoiseFloor, IsAbsentWhereNothingWasRepeated) {
  EXPECT_FALSE(noise_floor(std::vector{ConditionResult{}, condition(0.1, {0, 0})}, 0.95).has_value());
}

// A fifth of 0.05 is 0.01: none of 1000 is below it, none of 100 does not tell, 30 of 1000 is above it.
TEST(NoiseFloor, IsJudgedByBothEndsOfItsInterval) {
  const auto noise = [](stats::Proportion flips) {
    return noise_floor(std::vector{condition(0.05, flips)}, 0.95)->noise;
  };
  EXPECT_EQ(noise({0, 1000}), ArithmeticNoise::small);
  EXPECT_EQ(noise({0, 100}), ArithmeticNoise::undecided);
  EXPECT_EQ(noise({2, 200}), ArithmeticNoise::undecided);
  EXPECT_EQ(noise({30, 1000}), ArithmeticNoise::not_small);
}

}  // namespace
}  // namespace rocking::experiment
