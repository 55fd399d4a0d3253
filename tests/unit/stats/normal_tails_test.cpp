#include "rocking/stats/normal_check.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/stats/normality.hpp"

namespace {

using namespace rocking::stats;

/// Probability of each count 0 ... n.
std::vector<double> binomial_law(std::uint64_t n, double p) {
  std::vector<double> law;
  for (std::uint64_t k = 0; k <= n; ++k) {
    double probability = 1.0;
    for (std::uint64_t i = 0; i < k; ++i) probability *= static_cast<double>(n - i) / static_cast<double>(i + 1) * p;
    law.push_back(probability * std::pow(1.0 - p, n - k));
  }
  return law;
}

TEST(TwoSidedBinomialTest, GivesTheKnownValues) {
  // mpmath; the first is the example of R's binom.test, printed there as 0.3825
  EXPECT_NEAR(two_sided_binomial_p_value({682, 925}, 0.75), 0.38249155957485168, 1e-12);
  EXPECT_NEAR(two_sided_binomial_p_value({10, 15}, 0.4), 0.060947303661568, 1e-14);
  EXPECT_NEAR(two_sided_binomial_p_value({3, 15}, 0.4), 0.185549310558208, 1e-14);
  EXPECT_NEAR(two_sided_binomial_p_value({0, 50}, 0.1), 0.0083736963432300253, 1e-14);
  EXPECT_NEAR(two_sided_binomial_p_value({12, 50}, 0.1), 0.003219921135909912, 1e-14);
}

TEST(TwoSidedBinomialTest, AddsUpAllThatIsNoMoreProbable) {
  for (const double p : {0.5, 0.3, 0.07, 0.95}) {
    for (const std::uint64_t n : {1U, 2U, 9U, 20U}) {
      const std::vector<double> law = binomial_law(n, p);
      for (std::uint64_t k = 0; k <= n; ++k) {
        double sum = 0.0;
        for (const double probability : law) sum += probability <= law[k] * (1.0 + 1e-7) ? probability : 0.0;
        EXPECT_NEAR(two_sided_binomial_p_value({k, n}, p), sum, 1e-13) << k << "/" << n << " " << p;
      }
    }
  }
}

// The defining property of a p-value: P(p-value <= level) <= level.
TEST(TwoSidedBinomialTest, RaisesFalseAlarmsNoMoreOftenThanItSays) {
  const std::vector<double> law = binomial_law(40, 0.15);
  for (const double level : {0.001, 0.01, 0.05, 0.3}) {
    double alarms = 0.0;
    for (std::uint64_t k = 0; k <= 40; ++k) alarms += two_sided_binomial_p_value({k, 40}, 0.15) <= level ? law[k] : 0.0;
    EXPECT_LE(alarms, level);
  }
}

TEST(TwoSidedBinomialTest, KnowsTheSureAndTheImpossible) {
  EXPECT_EQ(two_sided_binomial_p_value({0, 10}, 0.0), 1.0);
  EXPECT_EQ(two_sided_binomial_p_value({10, 10}, 1.0), 1.0);
  EXPECT_EQ(two_sided_binomial_p_value({1, 10}, 0.0), 0.0);
  EXPECT_EQ(two_sided_binomial_p_value({9, 10}, 1.0), 0.0);
  EXPECT_EQ(two_sided_binomial_p_value({0, 0}, 0.3), 1.0);
}

TEST(NormalTails, CountWhatLiesBeyond) {
  const std::vector<double> sample{0.4, 0.4 + 0.03 * 2.9, 0.4 - 0.03 * 3.1, 0.4 + 0.03 * 4.5, 0.4 - 0.03 * 7.0};
  const auto tails = normal_tails(sample, {0.4, 0.03});
  const std::uint64_t expected[] = {3, 2, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(tails[i].sigmas, static_cast<double>(i + 3));
    EXPECT_EQ(tails[i].beyond.successes, expected[i]);
    EXPECT_EQ(tails[i].beyond.trials, 5U);
  }
}

TEST(NormalTails, KnowWhatToExpectOfTwentyThousand) {
  std::vector<double> sample(20000, 0.0);
  sample[17] = 5.5;
  const auto tails = normal_tails(sample, {});
  EXPECT_NEAR(tails[0].expected, 53.995921265203781, 1e-10);  // mpmath, here and below
  EXPECT_NEAR(tails[1].expected, 1.2668496733247969, 1e-12);
  EXPECT_NEAR(tails[2].expected, 0.011466062875167756, 1e-14);
  EXPECT_LT(tails[0].p_value, 1e-20);  // 1 observed, 54 expected
  EXPECT_EQ(tails[1].p_value, 1.0);    // 1 observed, 1.27 expected
  EXPECT_NEAR(tails[2].p_value, 0.01140058134868462, 1e-13);
}

}  // namespace
