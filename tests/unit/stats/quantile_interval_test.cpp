// Distribution-free intervals of quantiles: exact coverage, open ends, and coverage in samples.

#include "rocking/stats/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "support/false_alarms.hpp"
#include "support/split_mix.hpp"

namespace {

using namespace rocking::stats;

/// Probability that the interval between these ranks covers the quantile of a continuous distribution: that of l <= K <
/// u, K binomial.
double coverage(std::uint64_t n, double level, const QuantileRanks& ranks) {
  const boost::math::binomial_distribution<double> law(static_cast<double>(n), level);
  double covered = 0.0;
  for (std::uint64_t k = ranks.low.value_or(0); k < ranks.high.value_or(n + 1); ++k) {
    covered += pdf(law, static_cast<double>(k));
  }
  return covered;
}

TEST(QuantileRanks, CoverTheQuantileAtLeastAsOftenAsTheyPromise) {
  for (const std::uint64_t n : {1U, 2U, 5U, 6U, 20U, 59U, 72U, 73U, 200U, 1000U}) {
    for (const double level : {0.05, 0.16, 0.5, 0.84, 0.95}) {
      for (const double confidence : {0.5, 0.95, 0.999}) {
        EXPECT_GE(coverage(n, level, quantile_ranks(n, level, confidence)), confidence - 1e-12) << n << ' ' << level;
      }
    }
  }
}

// One rank further inwards at either end misses the quantile more often than (1 - confidence)/2.
TEST(QuantileRanks, AreTheInnermostThatKeepThePromiseAtEachEnd) {
  for (const std::uint64_t n : {20U, 73U, 200U}) {
    for (const double level : {0.16, 0.5, 0.84}) {
      const QuantileRanks ranks = quantile_ranks(n, level, 0.95);
      const boost::math::binomial_distribution<double> law(static_cast<double>(n), level);
      ASSERT_TRUE((ranks.low && ranks.high) || n == 20U);
      if (ranks.low) {
        EXPECT_LE(cdf(law, static_cast<double>(*ranks.low) - 1.0), 0.025);
        EXPECT_GT(cdf(law, static_cast<double>(*ranks.low)), 0.025);
      }
      if (ranks.high) {
        EXPECT_LE(cdf(complement(law, static_cast<double>(*ranks.high) - 1.0)), 0.025);
        EXPECT_GT(cdf(complement(law, static_cast<double>(*ranks.high) - 2.0)), 0.025);
      }
    }
  }
}

// The largest of n values lies below the quantile with probability level^n: the end is open up to 0.95^n > 0.025, n =
// 71. The median is bounded from n = 6 on: 2 (1/2)^6 = 0.031 < 0.05.
TEST(QuantileRanks, AreAbsentWhereTooFewValuesBoundTheQuantile) {
  EXPECT_FALSE(quantile_ranks(71, 0.95, 0.95).high);
  EXPECT_EQ(quantile_ranks(72, 0.95, 0.95).high, 72U);
  EXPECT_FALSE(quantile_ranks(71, 0.05, 0.95).low);
  EXPECT_EQ(quantile_ranks(72, 0.05, 0.95).low, 1U);
  EXPECT_FALSE(quantile_ranks(5, 0.5, 0.95).low);
  EXPECT_FALSE(quantile_ranks(5, 0.5, 0.95).high);
  EXPECT_EQ(quantile_ranks(6, 0.5, 0.95).low, 1U);
  EXPECT_EQ(quantile_ranks(6, 0.5, 0.95).high, 6U);
  EXPECT_FALSE(quantile_ranks(0, 0.5, 0.95).low);
}

TEST(QuantileEstimate, IsTheNearestRankAndHasTheValuesOfItsRanks) {
  std::vector<double> values;
  for (int i = 1; i <= 100; ++i) values.push_back(i);
  const QuantileEstimate median = quantile_estimate(values, 0, 0.5, 0.95);
  EXPECT_EQ(median.value, 50.0);
  EXPECT_EQ(median.low, 40.0);  // P(K <= 39) = 0.018, P(K <= 40) = 0.028
  EXPECT_EQ(median.high, 61.0);
  EXPECT_EQ(quantile_estimate(values, 0, 0.95, 0.95).value, 95.0);
}

TEST(QuantileEstimate, HasNoValueAmongThoseBeyond) {
  const std::vector<double> values{1.0, 2.0, 3.0, 4.0, 5.0, 6.0};
  const QuantileEstimate median = quantile_estimate(values, 14, 0.5, 0.95);
  EXPECT_FALSE(median.value) << "the tenth of twenty";
  EXPECT_EQ(median.low, 6.0);
  EXPECT_FALSE(median.high);
  EXPECT_EQ(quantile_estimate(values, 14, 0.16, 0.95).value, 4.0);
  EXPECT_FALSE(quantile_estimate({}, 0, 0.5, 0.95).value);
  EXPECT_FALSE(quantile_estimate({}, 9, 0.5, 0.95).low);
}

/// Number of `samples` whose interval covers the true quantile: of n values -ln(1 - u), those above the quantile at
/// `censored_above` known to lie beyond.
int covered(std::uint64_t n, double level, double censored_above, int samples) {
  rocking::support::SplitMix numbers(0x2012 + n);
  const double truth = -std::log1p(-level);
  const double largest = -std::log1p(-censored_above);
  int count = 0;
  for (int sample = 0; sample < samples; ++sample) {
    std::vector<double> values;
    std::uint64_t beyond = 0;
    for (std::uint64_t i = 0; i < n; ++i) {
      const double value = -std::log1p(-numbers.uniform());
      if (value > largest) {
        ++beyond;
      } else {
        values.push_back(value);
      }
    }
    std::ranges::sort(values);
    const QuantileEstimate quantile = quantile_estimate(values, beyond, level, 0.95);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (quantile.low.value_or(-infinity) <= truth && truth <= quantile.high.value_or(infinity)) ++count;
  }
  return count;
}

TEST(QuantileEstimate, CoversTheTruthInSamplesAlsoWhereSomeValuesLieBeyond) {
  rocking::support::FalseAlarms alarms;
  constexpr int samples = 2000;
  for (const std::uint64_t n : {3U, 20U, 100U}) {
    for (const double censored_above : {0.97, 0.7}) {
      for (const double level : {0.5, 0.95}) {
        const boost::math::binomial_distribution<double> least(samples, 0.95);
        const int count = covered(n, level, censored_above, samples);
        EXPECT_GT(cdf(least, count), alarms.level()) << n << ' ' << level << ' ' << count;
      }
    }
  }
}

}  // namespace
