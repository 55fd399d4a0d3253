// Numbers about all conditions of a report together.

#include "analysis/overview.hpp"

#include <gtest/gtest.h>

#include "support/sample_report.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseKind;
using section::ResponseMode;

// Six conditions of 30 realisations: 30 - 5 i of (1,1), 4 i of (1,3), i overturn.
RunReport overview_sample() { return run_report_of(support::sample_report()); }

TEST(Overview, CountsTheConditionsInWhichAModeOccursAndIsMostLikely) {
  const RunReport report = overview_sample();
  EXPECT_EQ(realisations_of(report), 180U);
  const auto found = prevalences_of(report);
  EXPECT_EQ(found.at(section::periodic(1, 1)).most_likely, 4U) << "30, 25, 20, 15 against 0, 4, 8, 12";
  EXPECT_EQ(found.at(section::periodic(1, 3)).most_likely, 2U);
  EXPECT_EQ(found.at(section::periodic(1, 3)).occurs, 5U);
  EXPECT_EQ(found.at(ResponseMode{.kind = ResponseKind::overturned}).realisations, 15U);
  EXPECT_FALSE(found.contains(ResponseMode{.kind = ResponseKind::chaotic}));
}

TEST(Overview, FindsTheConditionInWhichAModeIsMostFrequent) {
  const Extreme worst = extreme_of(overview_sample(), {.kind = ResponseKind::overturned});
  EXPECT_EQ(worst.condition, 5U);
  EXPECT_EQ(worst.share.count, 5U);
}

TEST(Overview, ComparesInsteadTheUpperEndsForAModeThatNeverOccurs) {
  RunReport report = overview_sample();
  const ResponseMode chaotic{.kind = ResponseKind::chaotic};
  report.conditions[2].modes.at(chaotic).interval.high = 0.4;
  EXPECT_EQ(extreme_of(report, chaotic).condition, 2U);
  EXPECT_EQ(extreme_of(report, chaotic).share.count, 0U);
}

TEST(Overview, FindsTheLeastRepeatableCondition) {
  RunReport report = overview_sample();
  const Repeatability found = repeatability_of(report);
  EXPECT_EQ(found.compared, 6U);
  EXPECT_EQ(found.alike, 1U);
  EXPECT_EQ(found.least, 5U);
  for (ConditionReport& condition : report.conditions) condition.difference.reset();
  EXPECT_EQ(repeatability_of(report).compared, 0U);
  EXPECT_FALSE(repeatability_of(report).least.has_value());
}

TEST(Overview, PoolsThePairsOfAllConditions) {
  RunReport report = overview_sample();
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    report.conditions[i].difference->by_friction.median = 10.0 * static_cast<double>(i);
  }
  report.conditions[5].difference->by_friction.median.reset();
  const PooledDivergence pooled = pooled_divergence(report, &Difference::by_friction);
  EXPECT_EQ(pooled.pairs, 90U);
  EXPECT_EQ(pooled.diverged, 30U);
  EXPECT_EQ(pooled.median, 20.0) << "of 0, 10, 20, 30, 40";
  report.conditions[4].difference->by_friction.median.reset();
  EXPECT_EQ(pooled_divergence(report, &Difference::by_friction).median, 20.0) << "the upper one of 10 and 20";
  EXPECT_FALSE(pooled_divergence(report, &Difference::by_arithmetic).median.has_value());
}

TEST(Overview, AddsUpUnresolvedResponses) {
  RunReport report = overview_sample();
  EXPECT_EQ(unresolved_responses(report).count, 0U);
  const ResponseMode unresolved{.kind = ResponseKind::unresolved};
  report.conditions[1].modes[unresolved] = {.count = 3, .estimate = 0.1, .interval = {}};
  report.conditions[4].modes[unresolved] = {.count = 6, .estimate = 0.2, .interval = {}};
  const UnresolvedResponses found = unresolved_responses(report);
  EXPECT_EQ(found.count, 9U);
  EXPECT_EQ(found.share, 9.0 / 180.0);
  EXPECT_EQ(found.largest_share, 0.2);
  EXPECT_EQ(found.where, 4U);
}

// The interval of a share p is [0.8 p, 0.2 + 0.8 p]: 0.2 wide, whatever p is.
TEST(Overview, FindsTheWidestInterval) {
  RunReport report = overview_sample();
  EXPECT_NEAR(widest_half_width(report), 0.1, 1e-15);
  report.conditions[3].modes.begin()->second.interval = {.low = 0.25, .high = 0.75};
  EXPECT_EQ(widest_half_width(report), 0.25);
}

}  // namespace
}  // namespace rocking::analysis
