// Probabilities that do not decrease: the regression is the most likely one, and the band covers every such truth.

#include "rocking/stats/record_shares.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>

#include "support/split_mix.hpp"

namespace {

using namespace rocking::stats;
using ::testing::ElementsAre;

TEST(IsotonicRegression, PoolsLevelsWhoseSharesDecrease) {
  const std::vector<Proportion> levels{{1, 4}, {3, 4}, {1, 4}, {4, 4}};
  EXPECT_THAT(isotonic_regression(levels), ElementsAre(0.25, 0.5, 0.5, 1.0));
  const std::vector<Proportion> falling{{3, 3}, {1, 5}, {0, 2}};
  EXPECT_THAT(isotonic_regression(falling), ElementsAre(0.4, 0.4, 0.4));
  const std::vector<Proportion> unequal{{1, 2}, {1, 8}, {9, 10}};
  EXPECT_THAT(isotonic_regression(unequal), ElementsAre(0.2, 0.2, 0.9));
  EXPECT_THAT(isotonic_regression(std::vector<Proportion>{}), ElementsAre());
}

TEST(IsotonicRegression, OfMeansIsThatOfTheirWeights) {
  EXPECT_THAT(isotonic_regression(std::vector{0.25, 0.75, 0.25, 1.0}, std::vector{1.0, 1.0, 3.0, 1.0}),
              ElementsAre(0.25, 0.375, 0.375, 1.0));
}

double log_likelihood(const std::vector<Proportion>& levels, const std::vector<double>& probabilities) {
  double sum = 0.0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const auto happened = static_cast<double>(levels[i].successes);
    const double did_not = static_cast<double>(levels[i].trials) - happened;
    if (happened > 0.0) sum += happened * std::log(probabilities[i]);
    if (did_not > 0.0) sum += did_not * std::log1p(-probabilities[i]);
  }
  return sum;
}

/// The largest likelihood of the shares of successive groups of levels that do not decrease, over all groupings.
double best_of_all_groupings(const std::vector<Proportion>& levels) {
  double best = -INFINITY;
  for (unsigned joints = 0; joints < 1U << (levels.size() - 1); ++joints) {
    std::vector<double> probabilities;
    for (std::size_t first = 0; first < levels.size();) {
      Proportion pool = levels[first];
      std::size_t last = first + 1;
      for (; last < levels.size() && (joints >> (last - 1) & 1U) != 0; ++last) {
        pool.successes += levels[last].successes;
        pool.trials += levels[last].trials;
      }
      probabilities.resize(last, static_cast<double>(pool.successes) / static_cast<double>(pool.trials));
      first = last;
    }
    if (std::ranges::is_sorted(probabilities)) best = std::max(best, log_likelihood(levels, probabilities));
  }
  return best;
}

TEST(IsotonicRegression, IsTheMostLikelyOfAllThatDoNotDecrease) {
  rocking::support::SplitMix random(3);
  for (int run = 0; run < 500; ++run) {
    std::vector<Proportion> levels(static_cast<std::size_t>(1 + random.below(7)));
    for (Proportion& level : levels) {
      level.trials = static_cast<std::uint64_t>(1 + random.below(9));
      level.successes = static_cast<std::uint64_t>(random.below(static_cast<int>(level.trials) + 1));
    }
    const std::vector<double> found = isotonic_regression(levels);
    ASSERT_EQ(found.size(), levels.size());
    EXPECT_TRUE(std::ranges::is_sorted(found)) << run;
    EXPECT_NEAR(log_likelihood(levels, found), best_of_all_groupings(levels), 1e-9) << run;
  }
}

TEST(IsotonicBand, TakesEachEndFromTheLevelThatBoundsItMost) {
  const std::vector<Proportion> levels{{30, 100}, {25, 100}, {60, 100}};
  const auto band = isotonic_band(levels, 0.9);
  ASSERT_TRUE(band);
  const auto own = [](std::uint64_t count) { return bonferroni_clopper_pearson({count, 100}, 0.9, 3); };
  EXPECT_EQ(band->at(0).low, own(30).low);
  EXPECT_EQ(band->at(0).high, own(25).high);
  EXPECT_EQ(band->at(1).low, own(30).low);
  EXPECT_EQ(band->at(1).high, own(25).high);
  EXPECT_EQ(band->at(2).low, own(60).low);
  EXPECT_EQ(band->at(2).high, own(60).high);
}

TEST(IsotonicBand, IsAbsentWhereTheCountsContradictEveryProbabilityThatDoesNotDecrease) {
  EXPECT_FALSE(isotonic_band(std::vector<Proportion>{{0, 12}, {12, 12}, {0, 12}, {12, 12}}, 0.95));
  EXPECT_FALSE(isotonic_band(std::vector<Proportion>{{80, 100}, {82, 100}, {50, 100}}, 0.95));
  EXPECT_TRUE(isotonic_band(std::vector<Proportion>{{2, 2}, {0, 2}}, 0.95)) << "two trials show nothing";
  EXPECT_TRUE(isotonic_band(std::vector<Proportion>{{55, 100}, {50, 100}}, 0.95));
}

constexpr std::uint64_t of_each = 7;

/// Probability of the counts `first` and `second` if trials at the two levels are independent or, with `common`, if
/// each trial has one uniform number for both.
double probability_of(std::uint64_t first, std::uint64_t second, double p, double q, bool common) {
  const auto binomial = [](std::uint64_t k, std::uint64_t n, double chance) {
    return std::tgamma(double(n) + 1.0) / std::tgamma(double(k) + 1.0) / std::tgamma(double(n - k) + 1.0) *
           std::pow(chance, double(k)) * std::pow(1.0 - chance, double(n - k));
  };
  if (!common) return binomial(first, of_each, p) * binomial(second, of_each, q);
  if (second < first) return 0.0;
  const double of_the_rest = p < 1.0 ? std::min(1.0, (q - p) / (1.0 - p)) : 1.0;
  return binomial(first, of_each, p) * binomial(second - first, of_each - first, of_the_rest);
}

// The sum of the probabilities of all counts: no simulation, no false alarm.
TEST(IsotonicBand, CoversBothLevelsAsOftenAsItPromisesWithCommonAndWithIndependentNumbers) {
  for (const bool common : {false, true}) {
    for (int i = 0; i <= 20; ++i) {
      for (int j = i; j <= 20; ++j) {
        const double p = i / 20.0, q = j / 20.0;
        double covered = 0.0;
        for (std::uint64_t first = 0; first <= of_each; ++first) {
          for (std::uint64_t second = 0; second <= of_each; ++second) {
            const auto band = isotonic_band(std::array<Proportion, 2>{{{first, of_each}, {second, of_each}}}, 0.8);
            const auto holds = [](const Interval& interval, double x) {
              return interval.low <= x && x <= interval.high;
            };
            if (!band || !holds(band->at(0), p) || !holds(band->at(1), q)) continue;
            covered += probability_of(first, second, p, q, common);
          }
        }
        EXPECT_GE(covered, 0.8) << p << ' ' << q << ' ' << common;
      }
    }
  }
}

// Two records at 1, three others at 2.
TEST(RecordShares, OfLevelsWithRecordsOfTheirOwnAreMeansOverThese) {
  const SuiteLevels suite{{{1.0, {1, 4}}}, {{1.0, {3, 4}}}, {{2.0, {4, 4}}}, {{2.0, {2, 4}}}, {{2.0, {0, 4}}}};
  const RecordShares shares(suite);
  EXPECT_THAT(shares.intensities(), ElementsAre(1.0, 2.0));
  EXPECT_THAT(shares.mean({1, 1, 1, 1, 1}), ElementsAre(0.5, 0.5));
  EXPECT_THAT(shares.mean({2, 0, 1, 2, 0}), ElementsAre(0.25, 2.0 / 3.0));
  EXPECT_THAT(shares.of_record(0), ElementsAre(0.25, 0.5)) << "the mean where it has no level";
  EXPECT_THAT(shares.shares_of_another({0.1, 0.3, 0.1, 0.2, 0.1}, 0.2),
              ElementsAre(testing::DoubleEq(1.0 / 3.0), testing::DoubleEq(1.0 / 3.0)));
  const RecordShares same({{{1.0, {1, 4}}, {2.0, {1, 1}}}, {{1.0, {3, 4}}, {2.0, {1, 1}}}});
  EXPECT_THAT(same.shares_of_another({0.5, 0.25}, 0.25), ElementsAre(0.25, 0.25));
}

}  // namespace
