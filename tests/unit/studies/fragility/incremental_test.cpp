// Incremental dynamic analysis: quantiles with overturned realisations, and resurrections.

#include <gtest/gtest.h>

#include "rocking/studies/incremental/incremental.hpp"

namespace rocking {
namespace {

Stripe stripe_of(const std::string& record, double intensity, const std::vector<double>& tilts) {
  Stripe stripe{.record = record, .intensity = intensity, .measures = {}, .overturned = {}, .peaks = {}};
  for (const double tilt : tilts) {
    stripe.overturned.push_back(tilt > 5.0);
    stripe.peaks.push_back({.tilt = tilt});
  }
  return stripe;
}

TEST(IncrementalAnalysis, HasTheFlatLineWhereAQuantileOverturns) {
  const StripeGroup group{
      .parameter = "/excitation/scale",
      .others = {},
      .confidence = 0.95,
      .stripes = {stripe_of("a", 1.0, {0.1, 0.2, 0.3, 9.0}), stripe_of("a", 2.0, {9.0, 9.0, 0.4, 9.0}),
                  stripe_of("b", 1.0, {0.5, 0.6, 0.7, 0.8}), stripe_of("b", 2.0, {9.0, 0.9, 9.0, 0.9})}};
  const IncrementalAnalysis found = incremental_analysis(group);
  ASSERT_EQ(found.records.size(), 2U);
  EXPECT_EQ(found.records[0].levels[0].quantiles[0], 0.1);
  EXPECT_EQ(found.records[0].levels[0].quantiles[1], 0.2);
  EXPECT_FALSE(found.records[0].levels[0].quantiles[2].has_value());
  EXPECT_EQ(found.records[0].levels[0].overturned, 1U);
  EXPECT_EQ(found.all[0].trials, 8U);
  EXPECT_EQ(found.all[0].quantiles[1], 0.5);
  EXPECT_EQ(found.records[0].resurrections.trials, 0U);
  EXPECT_EQ(found.resurrections.of, 5U);
}

TEST(IncrementalAnalysis, CountsARealisationThatStandsAgainOnce) {
  const StripeGroup group{.parameter = "/excitation/scale",
                          .others = {},
                          .confidence = 0.95,
                          .stripes = {stripe_of("", 1.0, {9.0, 0.1}), stripe_of("", 2.0, {0.2, 0.2}),
                                      stripe_of("", 3.0, {9.0, 9.0}), stripe_of("", 4.0, {0.4, 9.0})}};
  const IncrementalAnalysis found = incremental_analysis(group);
  EXPECT_EQ(found.resurrections.trials, 1U);
  EXPECT_EQ(found.resurrections.of, 2U);
}

}  // namespace
}  // namespace rocking
