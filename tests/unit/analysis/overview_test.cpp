// Numbers about all conditions of a report together.

#include "rocking/output/overview.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "support/sample_report.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseKind;
using section::ResponseMode;

// Six conditions of 30 realisations: 30 - 5 i of (1,1), 4 i of (1,3), i overturn.
Report overview_sample() { return report_in(support::sample_report()); }

TEST(Overview, CountsTheConditionsInWhichAModeOccursAndIsMostLikely) {
  const Report report = overview_sample();
  EXPECT_EQ(realisations_of(report), 180U);
  const auto found = prevalences_of(report);
  EXPECT_EQ(found.at(section::periodic(1, 1)).most_likely, 4U) << "30, 25, 20, 15 against 0, 4, 8, 12";
  EXPECT_EQ(found.at(section::periodic(1, 3)).most_likely, 2U);
  EXPECT_EQ(found.at(section::periodic(1, 3)).occurs, 5U);
  EXPECT_EQ(found.at(ResponseMode{.kind = ResponseKind::overturned}).realisations, 15U);
  EXPECT_FALSE(found.contains(ResponseMode{.kind = ResponseKind::chaotic}));
}

TEST(Overview, FindsTheConditionInWhichAModeIsMostFrequent) {
  EXPECT_EQ(extreme_of(overview_sample(), {.kind = ResponseKind::overturned}), 5U);
}

TEST(Overview, ComparesInsteadTheUpperEndsForAModeThatNeverOccurs) {
  Report report = overview_sample();
  const ResponseMode chaotic{.kind = ResponseKind::chaotic};
  std::ranges::find(report.conditions[2].result.modes, chaotic, &ModeEstimate::mode)->probability.simultaneous.high =
      0.4;
  EXPECT_EQ(extreme_of(report, chaotic), 2U);
}

TEST(Overview, FindsTheLeastRepeatableCondition) {
  Report report = overview_sample();
  const Repeatability found = repeatability_of(report);
  EXPECT_EQ(found.compared, 6U);
  EXPECT_EQ(found.alike, 1U);
  EXPECT_EQ(found.least, 5U);
  for (ReportedCondition& condition : report.conditions) condition.result.non_recurrence.reset();
  EXPECT_EQ(repeatability_of(report).compared, 0U);
  EXPECT_FALSE(repeatability_of(report).least.has_value());
}

TEST(Overview, PoolsThePairsOfAllConditions) {
  Report report = overview_sample();
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    report.conditions[i].result.non_recurrence->friction.median = 10.0 * static_cast<double>(i);
  }
  report.conditions[5].result.non_recurrence->friction.median.reset();
  const PooledDivergence pooled = pooled_divergence(report, &NonRecurrence::friction);
  EXPECT_EQ(pooled.pairs, 90U);
  EXPECT_EQ(pooled.diverged, 30U);
  EXPECT_EQ(pooled.median, 20.0) << "of 0, 10, 20, 30, 40";
  report.conditions[4].result.non_recurrence->friction.median.reset();
  EXPECT_EQ(pooled_divergence(report, &NonRecurrence::friction).median, 20.0) << "the upper one of 10 and 20";
  EXPECT_FALSE(pooled_divergence(report, &NonRecurrence::arithmetic).median.has_value());
}

TEST(Overview, AddsUpUnresolvedResponses) {
  Report report = overview_sample();
  EXPECT_EQ(unresolved_responses(report).count, 0U);
  const ResponseMode unresolved{.kind = ResponseKind::unresolved};
  report.conditions[1].result.modes.push_back({unresolved, support::sample_estimate(3, 30)});
  report.conditions[4].result.modes.push_back({unresolved, support::sample_estimate(6, 30)});
  const UnresolvedResponses found = unresolved_responses(report);
  EXPECT_EQ(found.count, 9U);
  EXPECT_EQ(found.share, 9.0 / 180.0);
  EXPECT_EQ(found.largest_share, 0.2);
  EXPECT_EQ(found.where, 4U);
}

// The interval of a share p is [0.8 p, 0.2 + 0.8 p]: 0.2 wide, whatever p is.
TEST(Overview, FindsTheWidestInterval) {
  Report report = overview_sample();
  EXPECT_NEAR(widest_half_width(report), 0.1, 1e-15);
  report.conditions[3].result.modes.front().probability.simultaneous = {.low = 0.25, .high = 0.75};
  EXPECT_EQ(widest_half_width(report), 0.25);
}

}  // namespace
}  // namespace rocking::analysis
