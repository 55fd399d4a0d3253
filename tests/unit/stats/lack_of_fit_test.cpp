// The test of a lognormal law against the levels; how often it rejects is in tests/statistical/fragility_test.cpp.

#include "rocking/stats/lack_of_fit.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "rocking/stats/probit.hpp"
#include "support/split_mix.hpp"

namespace {

using namespace rocking::stats;

/// `successes[i]` of `trials` happened at intensity i + 1, those with the lowest numbers.
std::vector<IntensityLevel> levels_of(const std::vector<std::size_t>& successes, std::size_t trials) {
  std::vector<IntensityLevel> levels;
  for (const std::size_t count : successes) {
    levels.push_back({.intensity = static_cast<double>(levels.size()) + 1.0, .happened = std::vector<bool>(trials)});
    std::fill_n(levels.back().happened.begin(), count, true);
  }
  return levels;
}

BootstrapNumbers seeded(std::uint64_t seed) {
  return [seed](std::uint64_t sample, std::uint64_t number) {
    rocking::support::SplitMix random(seed + (sample << 32U) + number);
    const double first = random.uniform();
    return std::array{first, random.uniform()};
  };
}

TEST(LackOfFit, HasTheDevianceOfTheLevels) {
  const auto levels = levels_of({5, 30, 45, 80, 85}, 100);
  const auto law = fit_lognormal(levels).law;
  ASSERT_TRUE(law);
  double deviance = 0.0;
  for (const IntensityLevel& level : levels) {
    const auto k = static_cast<double>(proportion_at(level).successes);
    const double p = law->probability(level.intensity);
    deviance += 2.0 * (k * std::log(k / (100.0 * p)) + (100.0 - k) * std::log((100.0 - k) / (100.0 * (1.0 - p))));
  }
  EXPECT_NEAR(lack_of_fit(levels, *law, 0, seeded(1)).deviance, deviance, 1e-9);
}

TEST(ProbitDeviance, IsNoneWhereAStepDescribesTheCounts) {
  using Levels = std::vector<ProbitCounts>;
  EXPECT_EQ(probit_deviance(Levels{{-1.0, 0.0, 5.0}, {0.0, 2.0, 3.0}, {1.0, 5.0, 0.0}}), 0.0);
  EXPECT_EQ(probit_deviance(Levels{{-1.0, 5.0, 0.0}, {1.0, 0.0, 5.0}}), 0.0);
  EXPECT_EQ(probit_deviance(Levels{{-1.0, 0.0, 5.0}, {1.0, 0.0, 5.0}}), 0.0);
  EXPECT_GT(probit_deviance(Levels{{-1.0, 0.0, 5.0}, {0.0, 5.0, 0.0}, {1.0, 0.0, 5.0}}), 10.0);
}

TEST(LackOfFit, OfTwoLevelsIsNone) {
  const auto levels = levels_of({10, 60}, 100);
  const LackOfFit test = lack_of_fit(levels, fit_lognormal(levels).law.value(), 99, seeded(1));
  EXPECT_NEAR(test.deviance, 0.0, 1e-9);
  EXPECT_EQ(test.as_large, 99U);
  EXPECT_EQ(test.p_value, 1.0);
}

TEST(LackOfFit, CountsTheSamplesThatTheGivenNumbersMake) {
  const auto levels = levels_of({8, 28, 52, 70, 84}, 100);
  const auto law = fit_lognormal(levels).law.value();
  const LackOfFit once = lack_of_fit(levels, law, 199, seeded(1));
  EXPECT_NE(once.as_large, lack_of_fit(levels, law, 199, seeded(2)).as_large);
  EXPECT_EQ(once.p_value, static_cast<double>(once.as_large + 1) / 200.0);
}

TEST(LackOfFit, IsGreatWhereSharesStandStillBetweenTwoRises) {
  const auto levels = levels_of({2, 50, 51, 52, 51, 50, 98}, 100);
  EXPECT_EQ(lack_of_fit(levels, fit_lognormal(levels).law.value(), 199, seeded(1)).as_large, 0U);
}

// Numbers that draw each trial once and put it in the middle of its range give the data with the law's shares.
TEST(LackOfFit, KeepsTheDependenceOfTheLevels) {
  const auto levels = levels_of({10, 26, 49, 69, 81}, 100);
  const auto law = fit_lognormal(levels).law.value();
  const LackOfFit test = lack_of_fit(levels, law, 1, [](std::uint64_t, std::uint64_t number) {
    return std::array{(static_cast<double>(number) + 0.5) / 100.0, 0.5};
  });
  EXPECT_EQ(test.as_large, 1U) << "a place of 1/2 changes no outcome here, so that the sample is the data";
}

}  // namespace
