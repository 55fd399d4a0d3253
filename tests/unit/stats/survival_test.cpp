// Quantiles of a survival curve, and its continuation: against counting, against a geometric law, at the edges.

#include "rocking/stats/incidence.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace rocking::stats {
namespace {

EventTally tally_of(const std::vector<std::int64_t>& events, const std::vector<std::int64_t>& censored) {
  EventTally tally;
  for (const std::int64_t time : events) ++tally[{.time = time, .event = 0}];
  for (const std::int64_t time : censored) ++tally[{.time = time, .event = std::nullopt}];
  return tally;
}

// Without early censoring the curve counts, so that its quantiles are the order statistics.
TEST(Survival, HasTheQuantilesOfOrderStatisticsWithoutEarlyCensoring) {
  std::vector<std::int64_t> events;
  std::vector<double> values;
  for (std::int64_t i = 1; i <= 23; ++i) {
    events.push_back(i * i);
    values.push_back(static_cast<double>(i * i));
  }
  for (const std::size_t beyond : {0U, 4U, 17U}) {
    const EventTally tally = tally_of(events, std::vector<std::int64_t>(beyond, 1000));
    const auto curve = cumulative_incidence(tally, 0, 0.95);
    for (const double level : {0.02, 0.25, 0.5, 0.75, 0.98}) {
      const QuantileEstimate found = incidence_quantile(curve, 23 + beyond, level, 0.95);
      const QuantileEstimate expected = quantile_estimate(values, beyond, level, 0.95);
      EXPECT_EQ(found.value, expected.value) << level << ' ' << beyond;
      EXPECT_EQ(found.low, expected.low) << level << ' ' << beyond;
      EXPECT_EQ(found.high, expected.high) << level << ' ' << beyond;
    }
  }
}

// Four observations: 10, censored at 15, 20, 30. The curve is 1/4 at 10 and 1/4 + 3/4 x 1/2 = 5/8 at 20. If the
// censored one counted as the last, the median would be 20 as well, but the upper quartile would be beyond.
TEST(Survival, DoesNotTakeAnEarlyCensoringForTheLastTime) {
  const auto curve = cumulative_incidence(tally_of({10, 20, 30}, {15}), 0, 0.95);
  EXPECT_EQ(incidence_quantile(curve, 4, 0.5, 0.95).value, 20.0);
  EXPECT_EQ(incidence_quantile(curve, 4, 0.75, 0.95).value, 30.0);
  EXPECT_EQ(quantile_estimate(std::vector<double>{10, 20, 30}, 1, 0.95, 0.95).value, std::nullopt);
}

TEST(Survival, HasNoQuantileWithoutEvents) {
  const QuantileEstimate found = incidence_quantile({}, 5, 0.5, 0.95);
  EXPECT_FALSE(found.value || found.low || found.high);
  const TimeToShare none = time_to_share(tally_of({}, {100, 100}), {.from = 50, .step = 10}, 0.01, 0.95);
  EXPECT_FALSE(none.is_observed || none.time || none.low || none.high);
}

/// Of 1024 observations half have the event in each step of 10 after 100, until `last`.
EventTally halving(std::int64_t last) {
  EventTally tally;
  std::uint64_t left = 1024;
  for (std::int64_t time = 110; time <= last; time += 10) {
    tally[{.time = time, .event = 0}] = left / 2;
    left /= 2;
  }
  if (left > 0) tally[{.time = last, .event = std::nullopt}] = left;
  return tally;
}

TEST(Survival, ReadsTheTimeToAShareOffTheCurve) {
  const TimeToShare found = time_to_share(halving(180), {.from = 100, .step = 10}, 0.01, 0.95);
  EXPECT_TRUE(found.is_observed);
  EXPECT_EQ(found.time, 170);  // 1/128 < 0.01 < 1/64
  EXPECT_LE(found.low, 170);
}

// After 4 steps 1/16 is left; 1/64 is more than 0.01 and 1/128 is less, after 3 further steps.
TEST(Survival, ContinuesAConstantHazardExactly) {
  const TimeToShare found = time_to_share(halving(140), {.from = 100, .step = 10}, 0.01, 0.95);
  EXPECT_FALSE(found.is_observed);
  EXPECT_EQ(found.time, 170);
  EXPECT_EQ(found.events, 128U + 64U);
  ASSERT_TRUE(found.low && found.high);
  EXPECT_LE(*found.low, 170);
  EXPECT_GE(*found.high, 170);
  EXPECT_LE(*found.high, 200);
}

TEST(Survival, DoesNotTellATimeIfNothingHappensInTheLastHalf) {
  const TimeToShare found =
      time_to_share(tally_of({110, 110, 110}, {200, 200, 200, 200}), {.from = 100, .step = 10}, 0.01, 0.95);
  EXPECT_FALSE(found.is_observed);
  EXPECT_EQ(found.time, std::nullopt);
  EXPECT_EQ(found.high, std::nullopt);
  EXPECT_TRUE(found.low);
  EXPECT_EQ(found.events, 0U);
}

TEST(Survival, KeepsTheEndsOfAThinnedCurve) {
  const auto curve = cumulative_incidence(halving(180), 0, 0.95);
  const auto few = thinned(curve, 3);
  ASSERT_EQ(few.size(), 3U);
  EXPECT_EQ(few.front().time, curve.front().time);
  EXPECT_EQ(few.back().time, curve.back().time);
  EXPECT_EQ(thinned(curve, 50).size(), curve.size());
}

}  // namespace
}  // namespace rocking::stats
