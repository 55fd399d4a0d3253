// When responses have settled, of realisations whose ends are known.

#include "rocking/ensemble/settling_tally.hpp"

#include <gtest/gtest.h>

namespace rocking {
namespace {

Condition windowed(int held) {
  Condition condition;
  condition.horizon = {.transient_periods = 100, .sampled_periods = 50, .until_classified = UntilClassified{}};
  condition.horizon.until_classified->held_windows = held;
  return condition;
}

Summary ended(std::int64_t observed, std::optional<std::int64_t> settled) {
  Summary summary;
  summary.observed_periods = observed;
  summary.settling_period = settled;
  return summary;
}

// Settled at 150, 200 and 400; the observation of the fourth ends at 450. With three windows it is at risk until 350,
// so that the curve reaches 1 at 400; with one it is at risk until 450, and the curve ends at 3/4.
TEST(ResponseTimes, CensorBeforeTheWindowsThatCannotBeHeld) {
  ResponseTimesTally tally;
  tally.add(ended(250, 150));
  tally.add(ended(300, 200));
  tally.add(ended(450, std::nullopt));
  tally.add(ended(500, 400));
  const ResponseTimes three = tally.result(windowed(3), {}, 0);
  EXPECT_DOUBLE_EQ(three.any_mode.back().estimate, 1.0);
  EXPECT_TRUE(three.nearly_all.is_observed);
  EXPECT_EQ(three.nearly_all.time, 400);
  const ResponseTimes one = tally.result(windowed(1), {}, 0);
  EXPECT_NEAR(one.any_mode.back().estimate, 0.75, 1e-15);
  EXPECT_FALSE(one.nearly_all.is_observed);
  EXPECT_EQ(one.quartiles[1].value, 200.0);
}

TEST(ResponseTimes, TakeTheDivergenceOfPairsAsCensoredAtTheFixedHorizon) {
  ResponseTimesTally tally;
  tally.add(ended(150, 150));
  const ResponseTimes found = tally.result(windowed(1), {{1, 5}, {7, 3}}, 8);
  ASSERT_EQ(found.divergence_quartiles.size(), 3U);
  EXPECT_EQ(found.divergence_quartiles[0].value, 1.0);
  EXPECT_EQ(found.divergence_quartiles[1].value, 7.0);
  EXPECT_EQ(found.divergence_quartiles[2].value, std::nullopt);
}

TEST(ResponseTimes, BoundWhatDidNotOccur) { EXPECT_NEAR(bound_of_none(100, 0.95), 0.0362, 5e-5); }

}  // namespace
}  // namespace rocking
