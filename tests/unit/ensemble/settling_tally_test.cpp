// Incidence and rates of leaving, from realisations whose ends are known.

#include "rocking/ensemble/settling_tally.hpp"

#include <optional>

#include <gtest/gtest.h>

namespace rocking {
namespace {

using section::ResponseKind;
using section::ResponseMode;

constexpr ResponseMode one_three{.kind = ResponseKind::periodic, .rocks = 1, .periods = 3};
constexpr int sampled = 50;

Condition condition_with(int held_windows) {
  Condition condition;
  condition.horizon = {.transient_periods = 100, .sampled_periods = sampled, .until_classified = UntilClassified{}};
  condition.horizon.until_classified->at_most_periods = 1000;
  condition.horizon.until_classified->held_windows = held_windows;
  condition.horizon.until_classified->watch_windows = 2;
  return condition;
}

Summary settled(ResponseMode mode, std::int64_t at, std::int64_t observed) {
  Summary summary;
  summary.mode = mode;
  summary.horizon_mode = ResponseMode{};
  summary.settling_period = at;
  summary.observed_periods = observed;
  return summary;
}

Summary censored(std::int64_t observed) {
  Summary summary;
  summary.horizon_mode = ResponseMode{};
  summary.observed_periods = observed;
  return summary;
}

SettlingResult result_of(const SettlingTally& tally, int held_windows) {
  return tally.result(condition_with(held_windows), {}, 0);
}

// Held from 200 on and confirmed at 300; then watched for two windows.
TEST(SettlingTally, CountsTheWatchedPeriodsFromTheLastHeldWindow) {
  SettlingTally tally;
  tally.add(settled(one_three, 200, 400));
  Summary left = settled(one_three, 250, 400);
  left.left_period = 400;
  left.left_to = ResponseMode{.kind = ResponseKind::chaotic};
  tally.add(left);
  const Leaving leaving = result_of(tally, 3).leaving.at(one_three);
  EXPECT_EQ(leaving.watched_periods, 100U + 50U);
  EXPECT_EQ(leaving.left, 1U);
  EXPECT_EQ(result_of(tally, 1).leaving.at(one_three).watched_periods, 200U + 150U);
}

TEST(SettlingTally, HasNoRateOfWhatIsNotWatchedOrCannotBeLeft) {
  SettlingTally tally;
  tally.add(settled(one_three, 200, 300));
  tally.add(settled({.kind = ResponseKind::overturned}, 120, 120));
  EXPECT_TRUE(result_of(tally, 3).leaving.empty());
}

// The second is at risk only until 350, since what appears later cannot be held for three windows. With the risk until
// 450 the curve would end at 2/3.
TEST(SettlingTally, CensorsBeforeTheWindowsThatCannotBeHeld) {
  SettlingTally tally;
  tally.add(settled(one_three, 200, 300));
  tally.add(censored(450));
  tally.add(settled(one_three, 400, 500));
  EXPECT_DOUBLE_EQ(result_of(tally, 3).incidence.at(one_three).back().estimate, 1.0);
  EXPECT_NEAR(result_of(tally, 1).incidence.at(one_three).back().estimate, 2.0 / 3.0, 1e-15);
  EXPECT_EQ(result_of(tally, 3).censored, 1U);
}

}  // namespace
}  // namespace rocking
