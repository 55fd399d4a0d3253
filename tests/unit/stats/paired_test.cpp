#include "rocking/stats/paired.hpp"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using namespace rocking::stats;
using Json = nlohmann::json;

// Bentur et al. (2009), cited in Fagerland, Lydersen, Laake (2013), BMC Med. Res. Methodol. 13, 91: airways before and
// after transplantation; p = 0.070, mid-p = 0.039, and Tango's interval -0.517 to -0.026.
constexpr PairedCounts airways{.both = 1, .first_only = 1, .second_only = 7, .neither = 12};

TEST(McNemar, GivesThePublishedValues) {
  EXPECT_DOUBLE_EQ(mcnemar(airways).p_value, 18.0 / 256.0);
  EXPECT_DOUBLE_EQ(mcnemar(airways).mid_p, 10.0 / 256.0);
  EXPECT_EQ(mcnemar({.both = 3, .neither = 4}).p_value, 1.0);
  EXPECT_EQ(mcnemar({.both = 3, .first_only = 5, .second_only = 5}).p_value, 1.0);
  EXPECT_DOUBLE_EQ(mcnemar({.first_only = 5, .second_only = 5}).mid_p, 1.0);
}

TEST(PairedDifference, GivesThePublishedInterval) {
  EXPECT_DOUBLE_EQ(paired_difference(airways), -6.0 / 21.0);
  EXPECT_NEAR(paired_difference_score(airways, 0.95).low, -0.517, 0.0005);
  EXPECT_NEAR(paired_difference_score(airways, 0.95).high, -0.026, 0.0005);
}

TEST(Oracle, AgreesOnPairs) {
  const auto oracle = Json::parse(std::ifstream(ROCKING_SOURCE_DIR "/tests/oracles/statsmodels_intervals.json"));
  EXPECT_GT(oracle["pairs"].size(), 5U);
  for (const Json& row : oracle["pairs"]) {
    const Json& table = row["table"];
    const PairedCounts counts{table[0], table[1], table[2], table[3]};
    EXPECT_NEAR(mcnemar(counts).p_value, row["exact"].get<double>(), 1e-12) << row;
    EXPECT_NEAR(mcnemar(counts).mid_p, row["mid_p"].get<double>(), 1e-12) << row;
    const Interval interval = paired_difference_score(counts, 0.95);
    EXPECT_NEAR(interval.low, row["tango"][0].get<double>(), 1e-11) << row;  // 2^-39 is 2e-12
    EXPECT_NEAR(interval.high, row["tango"][1].get<double>(), 1e-11) << row;
  }
}

class AnyDifference : public ::testing::TestWithParam<Interval (*)(const PairedCounts&, double)> {};

INSTANTIATE_TEST_SUITE_P(Stats, AnyDifference, ::testing::Values(&paired_difference_score, &paired_difference_exact));

TEST_P(AnyDifference, LiesInRangeAroundItsEstimate) {
  for (std::uint64_t n = 1; n <= 25; ++n) {
    for (std::uint64_t b = 0; b <= n; ++b) {
      for (std::uint64_t c = 0; b + c <= n; ++c) {
        const PairedCounts counts{.both = 0, .first_only = b, .second_only = c, .neither = n - b - c};
        const Interval interval = GetParam()(counts, 0.9);
        const double estimate = paired_difference(counts);
        EXPECT_TRUE(-1.0 <= interval.low && interval.low <= estimate) << b << ' ' << c << ' ' << n;
        EXPECT_TRUE(estimate <= interval.high && interval.high <= 1.0) << b << ' ' << c << ' ' << n;
      }
    }
  }
}

TEST_P(AnyDifference, ChangesSignWithTheSettings) {
  for (const auto& [b, c] : {std::pair{0U, 5U}, {3U, 9U}, {20U, 0U}, {7U, 7U}}) {
    const Interval one = GetParam()({.both = 4, .first_only = b, .second_only = c, .neither = 9}, 0.95);
    const Interval other = GetParam()({.both = 4, .first_only = c, .second_only = b, .neither = 9}, 0.95);
    EXPECT_NEAR(one.low, -other.high, 1e-11);
    EXPECT_NEAR(one.high, -other.low, 1e-11);
  }
}

TEST_P(AnyDifference, KnowsNothingWithoutTrialsAndSomethingWithoutDiscordantOnes) {
  EXPECT_EQ(GetParam()({}, 0.95).low, -1.0);
  EXPECT_EQ(GetParam()({}, 0.95).high, 1.0);
  const Interval alike = GetParam()({.both = 500, .neither = 500}, 0.95);
  EXPECT_TRUE(-0.01 < alike.low && alike.low < 0.0);
  EXPECT_TRUE(0.0 < alike.high && alike.high < 0.01);
}

// With independent random numbers both variances have the same mean; the covariance of the trials is 2 (a d - b c)/n^2.
TEST(VarianceReduction, IsTheCovarianceOfTheTwoSettings) {
  const PairedCounts counts{.both = 30, .first_only = 8, .second_only = 2, .neither = 60};
  const VarianceReduction found = variance_reduction(counts);
  EXPECT_NEAR(found.independent - found.paired, 2.0 * (30.0 * 60.0 - 8.0 * 2.0) / 1e4, 1e-15);
  EXPECT_NEAR(found.factor.value(), found.independent / found.paired, 1e-15);
  EXPECT_GT(found.factor.value(), 4.0);
  const VarianceReduction none = variance_reduction({.both = 6, .first_only = 14, .second_only = 24, .neither = 56});
  EXPECT_NEAR(none.factor.value(), 1.0, 1e-15);  // 6/30 = 20 %: independent to the last trial
}

TEST(VarianceReduction, HasNoFactorWhereNoTrialsDiffer) {
  EXPECT_FALSE(variance_reduction({.both = 6, .neither = 4}).factor.has_value());
  EXPECT_FALSE(variance_reduction({.first_only = 3}).factor.has_value());
  EXPECT_TRUE(variance_reduction({.first_only = 3, .neither = 1}).factor.has_value());
}

}  // namespace
