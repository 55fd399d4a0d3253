// Probabilities corrected by a sample that was classified twice: coverage computed exactly, over every outcome.

#include "rocking/stats/paired.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace rocking::stats {
namespace {

/// Probabilities of one trial: in the class by both methods, by the true method only, by the fallible method only.
struct Law {
  double both;
  double gained;
  double lost;
};

double choose(std::uint64_t n, std::uint64_t k) {
  return std::exp(std::lgamma(static_cast<double>(n) + 1.0) - std::lgamma(static_cast<double>(k) + 1.0) -
                  std::lgamma(static_cast<double>(n - k) + 1.0));
}

double power(double base, std::uint64_t exponent) { return std::pow(base, static_cast<double>(exponent)); }

/// How often `covers(counts, truth)` holds for `trials` trials of which `checked` are checked.
template <class Covers>
double frequency(const Law& law, std::uint64_t trials, std::uint64_t checked, Covers covers) {
  const double truth = law.both + law.gained;
  const double classified = law.both + law.lost;
  const double neither = 1.0 - law.both - law.gained - law.lost;
  double sum = 0.0;
  for (std::uint64_t both = 0; both <= checked; ++both) {
    for (std::uint64_t gained = 0; gained + both <= checked; ++gained) {
      for (std::uint64_t lost = 0; lost + gained + both <= checked; ++lost) {
        const std::uint64_t rest = checked - both - gained - lost;
        const double of_checked = choose(checked, both) * choose(checked - both, gained) * choose(rest + lost, lost) *
                                  power(law.both, both) * power(law.gained, gained) * power(law.lost, lost) *
                                  power(neither, rest);
        for (std::uint64_t others = 0; others <= trials - checked; ++others) {
          const double p = of_checked * choose(trials - checked, others) * power(classified, others) *
                           power(1.0 - classified, trials - checked - others);
          const CheckedCounts counts{
              .classified = {both + lost + others, trials}, .checked = checked, .gained = gained, .lost = lost};
          if (covers(counts, truth)) sum += p;
        }
      }
    }
  }
  return sum;
}

const Law laws[] = {{0.5, 0.0, 0.0}, {0.4, 0.1, 0.05}, {0.0, 0.02, 0.3}, {0.9, 0.05, 0.0}, {0.001, 0.0, 0.2}};

TEST(CorrectedInterval, CoversTheTruthAtLeastAsOftenAsItPromises) {
  for (const Law& law : laws) {
    for (const double confidence : {0.8, 0.95}) {
      const double covered = frequency(law, 40, 10, [confidence](const CheckedCounts& counts, double truth) {
        const Interval interval = corrected_interval(counts, confidence);
        return interval.low <= truth && truth <= interval.high;
      });
      EXPECT_GE(covered, confidence - 1e-12) << law.both << ' ' << law.gained << ' ' << law.lost;
    }
  }
}

TEST(RawInterval, MissesTheTruthWhereLabelsAreWrong) {
  const double covered = frequency({0.0, 0.02, 0.3}, 40, 10, [](const CheckedCounts& counts, double truth) {
    const Interval interval = clopper_pearson(counts.classified, 0.95);
    return interval.low <= truth && truth <= interval.high;
  });
  EXPECT_LT(covered, 0.1);
}

TEST(CorrectedEstimate, AddsWhatWasGainedAndTakesAwayWhatWasLost) {
  EXPECT_DOUBLE_EQ(corrected_estimate({.classified = {9, 20}, .checked = 20, .gained = 2, .lost = 1}),
                   0.45 + 0.1 - 0.05);
}

TEST(CorrectedInterval, KnowsNothingWhereNothingWasChecked) {
  const Interval interval = corrected_interval({.classified = {5, 10}, .checked = 0, .gained = 0, .lost = 0}, 0.95);
  EXPECT_EQ(interval.low, 0.0);
  EXPECT_EQ(interval.high, 1.0);
}

TEST(Corrected, StaysBetweenZeroAndOne) {
  const CheckedCounts less{.classified = {0, 100}, .checked = 10, .gained = 0, .lost = 5};
  EXPECT_EQ(corrected_estimate(less), 0.0);
  EXPECT_EQ(corrected_interval(less, 0.95).low, 0.0);
  const CheckedCounts more{.classified = {100, 100}, .checked = 10, .gained = 5, .lost = 0};
  EXPECT_EQ(corrected_estimate(more), 1.0);
  EXPECT_EQ(corrected_interval(more, 0.95).high, 1.0);
}

}  // namespace
}  // namespace rocking::stats
