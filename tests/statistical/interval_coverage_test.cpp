// How often intervals cover the truth, by adding up the probabilities of all outcomes: no simulation, no false alarm.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "rocking/stats/interval.hpp"

namespace {

using namespace rocking::stats;
using IntervalMaker = Interval (*)(const Proportion&, double);

/// The sabotaged twin: the textbook interval estimate +- z sqrt(p (1 - p)/n), known to promise too much.
Interval wald(const Proportion& proportion, double confidence) {
  EXPECT_EQ(confidence, 0.95);
  const auto n = static_cast<double>(proportion.trials);
  const double estimate = static_cast<double>(proportion.successes) / n;
  const double half_width = 1.959963984540054 * std::sqrt(estimate * (1.0 - estimate) / n);
  return {estimate - half_width, estimate + half_width};
}

/// Probability that the interval made of a count covers the probability `p` behind it.
double coverage(const std::vector<Interval>& interval_of_count, double p) {
  const auto n = static_cast<double>(interval_of_count.size() - 1);
  const boost::math::binomial_distribution<double> law(n, p);
  double covered = 0.0;
  for (std::size_t k = 0; k < interval_of_count.size(); ++k) {
    const Interval& interval = interval_of_count[k];
    if (interval.low <= p && p <= interval.high) covered += pdf(law, static_cast<double>(k));
  }
  return covered;
}

std::vector<Interval> intervals_of_all_counts(IntervalMaker interval, std::uint64_t n, double confidence) {
  std::vector<Interval> all;
  for (std::uint64_t k = 0; k <= n; ++k) all.push_back(interval({k, n}, confidence));
  return all;
}

/// The least coverage over all p in (0, 1). Between two ends of intervals the same counts cover and the coverage has no
/// minimum inside, so it is least just beyond an end.
double least_coverage(IntervalMaker interval, std::uint64_t n, double confidence) {
  const std::vector<Interval> all = intervals_of_all_counts(interval, n, confidence);
  double least = 1.0;
  for (const Interval& ends : all) {
    for (const double p : {ends.low - 1e-9, ends.high + 1e-9}) {
      if (0.0 < p && p < 1.0) least = std::min(least, coverage(all, p));
    }
  }
  return least;
}

double mean_coverage(IntervalMaker interval, std::uint64_t n, double confidence) {
  const std::vector<Interval> all = intervals_of_all_counts(interval, n, confidence);
  constexpr int points = 2000;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) sum += coverage(all, (i + 0.5) / points);
  return sum / points;
}

constexpr std::uint64_t sizes[] = {1, 2, 3, 5, 10, 30, 100, 200};

TEST(ClopperPearson, CoversTheTruthAtLeastAsOftenAsItPromises) {
  for (const std::uint64_t n : sizes) {
    for (const double confidence : {0.5, 0.95, 0.999}) {
      // Stepping 1e-9 beyond the end changes a coverage by no more than 1e-9 n.
      EXPECT_GE(least_coverage(&clopper_pearson, n, confidence), confidence - 1e-9 * static_cast<double>(n)) << n;
    }
  }
}

TEST(ClopperPearson, IsNoWiderThanItsPromiseNeeds) {
  EXPECT_LT(least_coverage(&clopper_pearson, 200, 0.95), 0.96);
}

TEST(Wilson, CoversTheTruthAboutAsOftenAsItPromisesOnTheAverage) {
  for (const std::uint64_t n : {5U, 10U, 30U, 100U, 200U}) {
    EXPECT_NEAR(mean_coverage(&wilson, n, 0.95), 0.95, 0.01) << n;
  }
}

TEST(Wald, BreaksThePromiseSoThisTestCanSee) {
  for (const std::uint64_t n : sizes) {
    EXPECT_LT(least_coverage(&wald, n, 0.95), 0.5) << n;
    EXPECT_LT(mean_coverage(&wald, n, 0.95), 0.95) << n;
  }
}

/// Probability that the intervals of all three classes cover their truths at once, where `all` has those of each count.
double joint_coverage(const std::vector<Interval>& all, const std::array<double, 3>& truth) {
  const std::size_t n = all.size() - 1;
  double covered = 0.0;
  for (std::size_t a = 0; a <= n; ++a) {
    for (std::size_t b = 0; a + b <= n; ++b) {
      const std::array<std::size_t, 3> counts{a, b, n - a - b};
      double probability = std::tgamma(static_cast<double>(n) + 1.0);
      for (std::size_t i = 0; i < 3; ++i) {
        const Interval& interval = all[counts[i]];
        const auto k = static_cast<double>(counts[i]);
        const bool covers = interval.low <= truth[i] && truth[i] <= interval.high;
        probability *= covers ? std::pow(truth[i], k) / std::tgamma(k + 1.0) : 0.0;
      }
      covered += probability;
    }
  }
  return covered;
}

/// The least joint coverage found for ten draws, at level 0.6, where three intervals at once can fail to keep it.
double least_joint_coverage(std::size_t categories) {
  std::vector<Interval> all;
  for (std::uint64_t k = 0; k <= 10; ++k) all.push_back(bonferroni_clopper_pearson({k, 10}, 0.6, categories));
  double least = 1.0;
  for (int i = 1; i < 60; ++i) {
    for (int j = 1; i + j < 60; ++j) {
      least = std::min(least, joint_coverage(all, {i / 60.0, j / 60.0, (60 - i - j) / 60.0}));
    }
  }
  return least;
}

TEST(BonferroniClopperPearson, CoversAllTruthsAtOnceAsOftenAsItPromises) { EXPECT_GE(least_joint_coverage(3), 0.6); }

TEST(BonferroniClopperPearson, NeedsItsCorrection) { EXPECT_LT(least_joint_coverage(1), 0.6); }

}  // namespace
