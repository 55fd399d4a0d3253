#include "rocking/stats/stopping_rule.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace rocking::stats;

constexpr StoppingGoal goal{.half_width = 0.02, .at_most = 20000, .family = {.prespecified = 3, .confidence = 0.95}};

std::vector<std::uint64_t> looks_of(const StoppingGoal& wanted) {
  const StoppingRule rule(wanted);
  std::vector<std::uint64_t> looks{rule.next_look(0)};
  while (looks.back() < wanted.at_most) looks.push_back(rule.next_look(looks.back()));
  return looks;
}

TEST(StoppingRule, LooksAtFixedNumbersOfTrials) {
  EXPECT_EQ(looks_of({.half_width = 0.1, .at_most = 300, .family = {}}),
            (std::vector<std::uint64_t>{50,  60,  70,  80,  90,  100, 110, 120, 130, 140, 150,
                                        160, 170, 180, 190, 200, 220, 240, 260, 280, 300}));
  EXPECT_EQ(looks_of(goal).size(), 67U);
}

TEST(StoppingRule, LooksLastAtTheMostThatMayBeSpent) {
  EXPECT_EQ(looks_of({.half_width = 0.1, .at_most = 1, .family = {}}), std::vector<std::uint64_t>{1});
  EXPECT_EQ(looks_of({.half_width = 0.1, .at_most = 50, .family = {}}), std::vector<std::uint64_t>{50});
  EXPECT_EQ(looks_of({.half_width = 0.1, .at_most = 64, .family = {}}), (std::vector<std::uint64_t>{50, 60, 64}));
}

TEST(StoppingRule, NeverGoesFarBeyondTheTrialsItNeeds) {
  const std::vector<std::uint64_t> looks = looks_of(goal);
  for (std::size_t i = 1; i < looks.size(); ++i) {
    EXPECT_GT(looks[i], looks[i - 1]);
    EXPECT_LE(looks[i] - looks[i - 1], std::max<std::uint64_t>(10, looks[i - 1] / 10));
  }
}

TEST(StoppingRule, FindsItsWayFromAnyNumberOfTrials) {
  const StoppingRule rule(goal);
  EXPECT_EQ(rule.next_look(0), 50U);
  EXPECT_EQ(rule.next_look(49), 50U);
  EXPECT_EQ(rule.next_look(50), 60U);
  EXPECT_EQ(rule.next_look(57), 60U);
  EXPECT_EQ(rule.next_look(19999), 20000U);
}

TEST(StoppingRule, StopsWhenEveryIntervalIsNarrowEnoughAndNotBefore) {
  const StoppingRule rule(goal);
  const auto narrow = [](const Interval& interval) { return interval.high - interval.low <= 0.04; };
  for (const std::uint64_t n : {100U, 1000U, 3000U, 8000U, 9000U, 20000U}) {
    const bool expected = narrow(rule.interval_of_prespecified({n / 2, n})) && narrow(rule.interval_of_others({0, n}));
    EXPECT_EQ(rule.narrow_enough({.trials = n, .prespecified = {n - n / 2, n / 2, 0}, .others = {}}), expected) << n;
  }
  EXPECT_FALSE(rule.narrow_enough({.trials = 7000, .prespecified = {3500, 3500, 0}, .others = {}}));
  EXPECT_TRUE(rule.narrow_enough({.trials = 9000, .prespecified = {4500, 4500, 0}, .others = {}}));
}

TEST(StoppingRule, MeasuresARelativeHalfWidthByTheEstimate) {
  const StoppingRule rule(
      {.half_width = 0.2, .scale = HalfWidthScale::relative, .at_most = 20000, .family = goal.family});
  EXPECT_TRUE(rule.narrow_enough({50, 100}, {0.4, 0.6}));
  EXPECT_FALSE(rule.narrow_enough({49, 100}, {0.4, 0.6}));
  EXPECT_TRUE(rule.narrow_enough({500, 10000}, {0.04, 0.06}));
  EXPECT_FALSE(rule.narrow_enough({0, 10000}, {0.0, 0.0}));
  EXPECT_FALSE(StoppingRule(goal).narrow_enough({50, 100}, {0.4, 0.6}));
  EXPECT_TRUE(StoppingRule(goal).narrow_enough({0, 10000}, {0.0, 0.04}));
}

/// Trials, to 1 %, at which the interval of a category of probability p has the relative half-width 0.1.
double trials_needed(const StoppingRule& rule, double p) {
  for (std::uint64_t n = 1000;; n += n / 100) {
    const Proportion counts{static_cast<std::uint64_t>(p * static_cast<double>(n)), n};
    const Interval interval = rule.interval_of_prespecified(counts);
    if (0.5 * (interval.high - interval.low) <= 0.1 * p) return static_cast<double>(n);
  }
}

// The numbers of trials are those of lib/docs/methods.md. A rule that is tuned to the probability has no concentration
// for other probabilities to pay for, but the probability is not known beforehand.
TEST(StoppingRule, NeedsAtMostASixthMoreTrialsForARelativeHalfWidthThanIfTheProbabilityWereKnown) {
  constexpr Family family{.prespecified = 6, .confidence = 0.95};
  constexpr std::uint64_t many = 100'000'000;
  const StoppingRule rule({.half_width = 0.1, .scale = HalfWidthScale::relative, .at_most = many, .family = family});
  for (const auto& [p, documented] : {std::pair{0.5, 1600.0}, {0.1, 13600.0}, {0.01, 141000.0}}) {
    const double needed = trials_needed(rule, p);
    EXPECT_NEAR(needed, documented, 0.03 * documented) << p;
    const StoppingRule tuned({.half_width = 0.05 * std::sqrt(p / (1.0 - p)), .at_most = many, .family = family});
    EXPECT_LE(needed, 7.0 / 6.0 * trials_needed(tuned, p)) << p;
  }
}

TEST(StoppingRule, NeedsFewTrialsWhereAllAreAlike) {
  EXPECT_TRUE(StoppingRule(goal).narrow_enough({.trials = 300, .prespecified = {0, 300, 0}, .others = {}}));
}

TEST(StoppingRule, HeedsTheCategoriesThatWereNotPrespecified) {
  const StoppingRule rule(goal);
  EXPECT_FALSE(rule.narrow_enough({.trials = 9000, .prespecified = {0, 4500, 0}, .others = {4500}}));
  EXPECT_TRUE(rule.narrow_enough({.trials = 12000, .prespecified = {0, 6000, 0}, .others = {6000}}));
  // The interval of a category that has not occurred may still be wider than requested.
  EXPECT_TRUE(rule.interval_of_prespecified({200, 200}).low > 0.96);
  EXPECT_FALSE(rule.narrow_enough({.trials = 200, .prespecified = {0, 200, 0}, .others = {}}));
}

TEST(StoppingRule, GivesWiderIntervalsToModesThatAreNotPrespecified) {
  const StoppingRule rule(goal);
  for (const std::uint64_t k : {0U, 1U, 2U, 50U, 500U, 1000U}) {
    EXPECT_LE(rule.interval_of_others({k, 1000}).low, rule.interval_of_prespecified({k, 1000}).low) << k;
    EXPECT_GE(rule.interval_of_others({k, 1000}).high, rule.interval_of_prespecified({k, 1000}).high) << k;
  }
}

// The levels of a family sum to 1 - confidence, however many categories share the last part.
TEST(Family, DividesItsSignificanceLevelAmongAllCategories) {
  const Family family{.prespecified = 6, .confidence = 0.95};
  double significance = 6.0 * family.of_prespecified().at(0.05);
  for (int i = 0; i < 1000; ++i) significance += family.of_others().at(0.7 / 1000.0);
  EXPECT_LE(significance, 0.05);
  EXPECT_NEAR(significance + family.of_others().at(0.3), 0.05, 1e-14);  // a thousand roundings
}

}  // namespace
