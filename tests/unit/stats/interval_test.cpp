#include "rocking/stats/interval.hpp"

#include <vector>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

namespace {

using namespace rocking::stats;

struct Known {
  Proportion proportion;
  double confidence;
  Interval wilson;
  Interval clopper_pearson;
};

// From 40-digit arithmetic (mpmath), by bisection of the sums of binomial probabilities. The first four rows agree with
// the four decimals printed by Newcombe (1998), Stat. Med. 17, 857-872, Table I.
const std::vector<Known> known_intervals{
    {{81, 263}, 0.95, {0.25528851987827423, 0.36620957698280007}, {0.25273674558527116, 0.36762192260135136}},
    {{15, 148}, 0.95, {0.06238639953073628, 0.16048724172330804}, {0.057844010083448559, 0.16165049034947901}},
    {{0, 20}, 0.95, {0.0, 0.16112515805281939}, {0.0, 0.16843347098308534}},
    {{1, 29}, 0.95, {0.0061132142927626605, 0.17175521879320288}, {0.00087264688357992199, 0.17764429548872293}},
    {{29, 29}, 0.95, {0.88303020150025923, 1.0}, {0.88055513093049728, 1.0}},
    {{1, 1}, 0.95, {0.20654931437723739, 1.0}, {0.025, 1.0}},
    {{0, 1}, 0.95, {0.0, 0.79345068562276261}, {0.0, 0.975}},
    {{3, 200}, 0.99, {0.0037973972749195637, 0.057348598918633215}, {0.0016963809882777954, 0.053803445228559717}},
    {{7, 100000}, 0.999, {2.1618806063427e-5, 0.00022662997634202}, {1.3483953491350e-5, 0.00020652626844370}},
    {{1, 2}, 0.5, {0.28475888458196231, 0.71524111541803769}, {0.13397459621556135, 0.86602540378443865}}};

/// Both ends agree to twelve digits: confidence is known to 1e-16 absolute, which is 1e-13 of 1 - confidence.
void expect_close(const Interval& found, const Interval& known) {
  EXPECT_NEAR(found.low, known.low, 1e-12 * known.low);
  EXPECT_NEAR(found.high, known.high, 1e-12 * known.high);
}

TEST(Wilson, GivesTheKnownIntervals) {
  for (const Known& known : known_intervals) expect_close(wilson(known.proportion, known.confidence), known.wilson);
}

TEST(ClopperPearson, GivesTheKnownIntervals) {
  for (const Known& known : known_intervals) {
    expect_close(clopper_pearson(known.proportion, known.confidence), known.clopper_pearson);
  }
}

TEST(ClopperPearson, LeavesTheSameTailOnBothSides) {
  for (const std::uint64_t n : {1U, 2U, 7U, 200U, 20000U}) {
    for (const std::uint64_t k : {n / 7, n / 2, n - 1, n}) {
      const Interval interval = clopper_pearson({k, n}, 0.95);
      const auto trials = static_cast<double>(n);
      const auto count = static_cast<double>(k);
      if (k > 0) {
        const boost::math::binomial_distribution<double> at_low(trials, interval.low);
        EXPECT_NEAR(cdf(complement(at_low, count - 1.0)), 0.025, 1e-11) << k << "/" << n;
      }
      if (k < n) {
        const boost::math::binomial_distribution<double> at_high(trials, interval.high);
        EXPECT_NEAR(cdf(at_high, count), 0.025, 1e-11) << k << "/" << n;
      }
    }
  }
}

class AnyInterval : public ::testing::TestWithParam<Interval (*)(const Proportion&, double)> {};

TEST_P(AnyInterval, KnowsNothingWithoutTrials) {
  const Interval interval = GetParam()({0, 0}, 0.95);
  EXPECT_EQ(interval.low, 0.0);
  EXPECT_EQ(interval.high, 1.0);
}

TEST_P(AnyInterval, ReachesTheEndExactlyWhereTheCountDoes) {
  for (const std::uint64_t n : {1U, 3U, 10U, 200U, 1000000U}) {
    EXPECT_EQ(GetParam()({0, n}, 0.95).low, 0.0);
    EXPECT_LT(GetParam()({0, n}, 0.95).high, 1.0);
    EXPECT_EQ(GetParam()({n, n}, 0.95).high, 1.0);
    EXPECT_GT(GetParam()({n, n}, 0.95).low, 0.0);
  }
}

TEST_P(AnyInterval, LiesInRangeAroundItsEstimate) {
  for (std::uint64_t n = 1; n <= 60; ++n) {
    for (std::uint64_t k = 0; k <= n; ++k) {
      for (const double confidence : {0.01, 0.95, 0.999999}) {
        const Interval interval = GetParam()({k, n}, confidence);
        const double estimate = static_cast<double>(k) / static_cast<double>(n);
        EXPECT_TRUE(0.0 <= interval.low && interval.low <= estimate) << k << "/" << n;
        EXPECT_TRUE(estimate <= interval.high && interval.high <= 1.0) << k << "/" << n;
      }
    }
  }
}

TEST_P(AnyInterval, TreatsFailuresAsItTreatsSuccesses) {
  for (const std::uint64_t k : {0U, 1U, 3U, 9U}) {
    const Interval of_successes = GetParam()({k, 19}, 0.9);
    const Interval of_failures = GetParam()({19 - k, 19}, 0.9);
    EXPECT_NEAR(of_successes.low, 1.0 - of_failures.high, 1e-14);
    EXPECT_NEAR(of_successes.high, 1.0 - of_failures.low, 1e-14);
  }
}

TEST_P(AnyInterval, GrowsWithConfidenceAndShrinksWithTrials) {
  const auto width = [](const Interval& interval) { return interval.high - interval.low; };
  EXPECT_LT(width(GetParam()({3, 10}, 0.9)), width(GetParam()({3, 10}, 0.99)));
  EXPECT_LT(width(GetParam()({30, 100}, 0.9)), width(GetParam()({3, 10}, 0.9)));
}

INSTANTIATE_TEST_SUITE_P(Stats, AnyInterval, ::testing::Values(&wilson, &clopper_pearson));

TEST(BonferroniClopperPearson, DividesTheSignificanceLevelAmongTheCategories) {
  expect_close(bonferroni_clopper_pearson({3, 200}, 0.95, 7), {0.0015021813457016233, 0.055918403362990557});
  EXPECT_EQ(bonferroni_clopper_pearson({3, 200}, 0.95, 1).low, clopper_pearson({3, 200}, 0.95).low);
}

/// One of seven shares, divided among categories that were not prespecified.
Interval others(const Proportion& proportion, double confidence) {
  return exact_interval(proportion, Family{.prespecified = 6, .confidence = confidence}.of_others());
}

TEST(ExactInterval, IsClopperPearsonWhereTheSignificanceLevelIsFixed) {
  const Family family{.prespecified = 6, .confidence = 0.95};
  for (const std::uint64_t k : {0U, 1U, 3U, 199U, 200U}) {
    const Interval found = exact_interval({k, 200}, family.of_prespecified());
    expect_close(found, bonferroni_clopper_pearson({k, 200}, 0.95, 7));
  }
}

TEST(ExactInterval, LeavesBothTailsTheSignificanceLevelAtItsEnds) {
  const Significance significance{.fixed = 0.001, .proportional = 0.03};
  for (const std::uint64_t n : {2U, 7U, 200U, 20000U}) {
    const auto trials = static_cast<double>(n);
    for (const std::uint64_t k : {std::uint64_t{1}, n / 2, n - 1}) {
      const Interval interval = exact_interval({k, n}, significance);
      const boost::math::binomial_distribution<double> at_low(trials, interval.low), at_high(trials, interval.high);
      // To 2^-40 of an end, which changes a tail by less than n times that.
      EXPECT_NEAR(cdf(complement(at_low, static_cast<double>(k - 1))), 0.5 * significance.at(interval.low),
                  1e-12 * trials);
      EXPECT_NEAR(cdf(at_high, static_cast<double>(k)), 0.5 * significance.at(interval.high), 1e-12 * trials);
    }
  }
}

TEST(ExactInterval, LiesInRangeAroundItsEstimateWhereTheSignificanceLevelIsProportional) {
  for (std::uint64_t n = 1; n <= 60; ++n) {
    for (std::uint64_t k = 0; k <= n; ++k) {
      const Interval interval = others({k, n}, 0.95);
      const double estimate = static_cast<double>(k) / static_cast<double>(n);
      EXPECT_TRUE(0.0 <= interval.low && interval.low <= estimate) << k << "/" << n;
      EXPECT_TRUE(estimate <= interval.high && interval.high <= 1.0) << k << "/" << n;
      EXPECT_EQ(interval.low == 0.0, k <= 1)
          << k << "/" << n;  // some of many rare categories are expected to occur once
      EXPECT_EQ(interval.high == 1.0, k == n) << k << "/" << n;
    }
  }
  EXPECT_EQ(others({0, 0}, 0.95).low, 0.0);
  EXPECT_EQ(others({0, 0}, 0.95).high, 1.0);
}

}  // namespace
