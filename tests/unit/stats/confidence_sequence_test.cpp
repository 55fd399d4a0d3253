#include "rocking/stats/stopping_rule.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace {

using namespace rocking::stats;

constexpr Significance fixed_significance{.fixed = 0.05, .proportional = 0.0};
constexpr Significance proportional_significance{.fixed = 0.0, .proportional = 0.05};

// From 40-digit arithmetic (mpmath), with the beta functions of the header.
TEST(ConfidenceSequence, GivesTheKnownMartingale) {
  struct Known {
    Proportion counts;
    double p;
    double concentration;
    double log_martingale;
  };
  for (const auto& [counts, p, c, value] : {Known{{0, 1}, 0.5, 64, 0.0},
                                            {{1, 1}, 0.25, 1, 0.0},
                                            {{3, 10}, 0.1, 20, -0.138309581811404156},
                                            {{0, 200}, 0x1p-7, 687, 0.727421732961687395},
                                            {{200, 200}, 0.9, 687, 16.38684713399488},
                                            {{50, 100}, 0.5, 8, -1.85963789047257135},
                                            {{10000, 20000}, 0.4875, 686.86, 3.90313952609198228},
                                            {{7, 100000}, 1e-3, 5, 68.4268399537194032},
                                            {{2, 50}, 1e-6, 100, 8.09052952094679764}}) {
    const double found = ConfidenceSequence(c).log_martingale(counts, p);
    EXPECT_NEAR(found, value, 1e-12 + 1e-14 * static_cast<double>(counts.trials)) << counts.successes;
  }
}

// The martingale property: under p, the mean of the next value is the present one. It starts at 1.
TEST(ConfidenceSequence, IsAMartingale) {
  for (const double c : {1.0, 30.0, 700.0}) {
    const ConfidenceSequence sequence(c);
    for (const double p : {0.001, 0.3, 0.5, 0.98}) {
      EXPECT_NEAR(sequence.log_martingale({0, 0}, p), 0.0, 1e-13);
      for (const std::uint64_t n : {0U, 1U, 7U, 100U, 3000U}) {
        for (const std::uint64_t k : {std::uint64_t{0}, n / 3, n}) {
          const double now = sequence.log_martingale({k, n}, p);
          const double success = std::exp(sequence.log_martingale({k + 1, n + 1}, p) - now);
          const double failure = std::exp(sequence.log_martingale({k, n + 1}, p) - now);
          EXPECT_NEAR(p * success + (1.0 - p) * failure, 1.0, 1e-11 + 2e-14 * static_cast<double>(n)) << k << "/" << n;
        }
      }
    }
  }
}

class AnySignificance : public ::testing::TestWithParam<Significance> {};

INSTANTIATE_TEST_SUITE_P(Stats, AnySignificance,
                         ::testing::Values(fixed_significance, proportional_significance,
                                           Significance{.fixed = 0.01, .proportional = 0.1}));

TEST_P(AnySignificance, EndsTheIntervalWhereTheMartingaleReachesTheBoundary) {
  const ConfidenceSequence sequence(40.0);
  const auto excess = [&](const Proportion& counts, double p) {
    return sequence.log_martingale(counts, p) + std::log(GetParam().at(p));
  };
  for (const std::uint64_t n : {1U, 2U, 20U, 500U, 20000U}) {
    for (const std::uint64_t k : {std::uint64_t{0}, std::uint64_t{1}, n / 9, n / 2, n - 1, n}) {
      const Interval interval = sequence.interval({k, n}, GetParam());
      const double estimate = static_cast<double>(k) / static_cast<double>(n);
      EXPECT_TRUE(0.0 <= interval.low && interval.low <= estimate) << k << "/" << n;
      EXPECT_TRUE(estimate <= interval.high && interval.high <= 1.0) << k << "/" << n;
      // Rounded outwards by 2^-40 of an end, and convex: a point just within is contained, the end is not.
      if (interval.low > 0.0) {
        EXPECT_GE(excess({k, n}, interval.low), -1e-9) << k << "/" << n;
        EXPECT_LT(excess({k, n}, interval.low * (1.0 + 1e-9)), 0.0) << k << "/" << n;
      }
      if (interval.high < 1.0) {
        EXPECT_GE(excess({k, n}, interval.high), -1e-9) << k << "/" << n;
        EXPECT_LT(excess({k, n}, interval.high * (1.0 - 1e-9)), 0.0) << k << "/" << n;
      }
    }
  }
}

TEST_P(AnySignificance, HoldsNoValueOutsideTheInterval) {
  const ConfidenceSequence sequence(40.0);
  for (const std::uint64_t n : {1U, 2U, 20U, 500U}) {
    for (const std::uint64_t k : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2}, n / 3, n}) {
      if (k > n) continue;
      const Interval interval = sequence.interval({k, n}, GetParam());
      for (int i = -99; i <= 99; ++i) {  // a grid that is fine near both ends
        const double p = i < 0 ? std::pow(10.0, 0.3 * i) : 1.0 - std::pow(10.0, -0.1 * i - 0.3);
        const bool in = sequence.log_martingale({k, n}, p) < -std::log(GetParam().at(p));
        EXPECT_EQ(in, interval.low < p && p < interval.high) << k << "/" << n << " at " << p;
      }
    }
  }
}

TEST(ConfidenceSequence, KnowsNothingWithoutTrialsAndLittleAfterOne) {
  const ConfidenceSequence sequence(40.0);
  EXPECT_EQ(sequence.interval({0, 0}, fixed_significance).low, 0.0);
  EXPECT_EQ(sequence.interval({0, 0}, fixed_significance).high, 1.0);
  // The prior is centred on the tested value: a first trial never rejects.
  EXPECT_EQ(sequence.interval({1, 1}, fixed_significance).low, 0.0);
  EXPECT_EQ(sequence.interval({0, 1}, fixed_significance).high, 1.0);
}

// Except if none or all succeed: there the exact interval uses one of its two tails for nothing.
TEST(ConfidenceSequence, ContainsTheExactIntervalOfTheSameSignificanceLevel) {
  const ConfidenceSequence sequence(40.0);
  for (const std::uint64_t n : {2U, 20U, 500U, 20000U}) {
    for (const std::uint64_t k : {std::uint64_t{1}, n / 2, n - 1}) {
      const Interval always = sequence.interval({k, n}, fixed_significance);
      const Interval once = clopper_pearson({k, n}, 0.95);
      EXPECT_LE(always.low, once.low) << k << "/" << n;
      EXPECT_GE(always.high, once.high) << k << "/" << n;
    }
  }
}

TEST(ConfidenceSequence, TreatsFailuresAsItTreatsSuccesses) {
  const ConfidenceSequence sequence(40.0);
  for (const std::uint64_t k : {0U, 1U, 3U, 90U}) {
    const Interval of_successes = sequence.interval({k, 190}, fixed_significance);
    const Interval of_failures = sequence.interval({190 - k, 190}, fixed_significance);
    EXPECT_NEAR(of_successes.low, 1.0 - of_failures.high, 1e-11);
    EXPECT_NEAR(of_successes.high, 1.0 - of_failures.low, 1e-11);
  }
}

TEST(ConfidenceSequence, NeedsAsManyTrialsAsIsSaidToTheFirstOrder) {
  for (const double significance : {0.05, 0.05 / 7.0, 1e-4}) {
    for (const double half_width : {0.1, 0.02, 0.005}) {
      const double expected = trials_for(half_width, significance);
      const ConfidenceSequence sequence(concentration_for(expected, significance));
      const auto half = [&](double trials) {
        const auto n = static_cast<std::uint64_t>(trials);
        const Interval interval = sequence.interval({n / 2, n}, {.fixed = significance, .proportional = 0.0});
        return 0.5 * (interval.high - interval.low);
      };
      EXPECT_GT(half(expected), half_width);
      EXPECT_LT(half(1.1 * expected), half_width);
    }
  }
}

}  // namespace
