// A fragility curve: what is stated at each intensity.

#include <gtest/gtest.h>

#include "rocking/studies/fragility.hpp"

namespace rocking {
namespace {

/// `successes` of `trials` happened, the first ones.
stats::IntensityLevel level(double intensity, std::size_t successes, std::size_t trials) {
  stats::IntensityLevel made{.intensity = intensity, .happened = std::vector<bool>(trials, false)};
  for (std::size_t i = 0; i < successes; ++i) made.happened[i] = true;
  return made;
}

TEST(FragilityCurve, StatesEstimateAndIntervalsAtEachLevel) {
  constexpr double confidence = 0.9;
  const FragilityCurve curve = fragility_curve({level(1.0, 5, 20), level(2.0, 12, 20), level(3.0, 18, 20)}, confidence);
  ASSERT_EQ(curve.levels.size(), 3U);
  const FragilityLevel& middle = curve.levels[1];
  const stats::Proportion counts{.successes = 12, .trials = 20};
  EXPECT_EQ(curve.confidence, confidence);
  EXPECT_EQ(middle.intensity, 2.0);
  EXPECT_EQ(middle.estimate, 0.6);
  EXPECT_EQ(middle.exact.low, stats::clopper_pearson(counts, confidence).low);
  EXPECT_EQ(middle.simultaneous.high, stats::bonferroni_clopper_pearson(counts, confidence, 3).high);
  ASSERT_TRUE(curve.fit.law.has_value());
  ASSERT_TRUE(middle.fitted.has_value());
  EXPECT_EQ(middle.fitted->value, curve.fit.law->probability(2.0));
  EXPECT_EQ(middle.fitted->band.low, curve.fit.law->band(2.0, confidence).low);
  EXPECT_EQ(curve.missed_levels(), 0U);
}

// Of 400 trials at each level: the share falls where the function can only rise, so its dispersion is too large at the
// ends.
TEST(FragilityCurve, CountsLevelsThatTheFunctionMisses) {
  const FragilityCurve curve =
      fragility_curve({level(1.0, 40, 400), level(2.0, 280, 400), level(3.0, 120, 400), level(4.0, 360, 400)}, 0.95);
  ASSERT_TRUE(curve.fit.law.has_value());
  EXPECT_EQ(curve.missed_levels(), 4U);
  EXPECT_TRUE(curve.levels[1].fitted->is_missed) << "0.70 is above the function";
  EXPECT_TRUE(curve.levels[2].fitted->is_missed) << "0.30 is below the function";
}

TEST(FragilityCurve, HasNoFittedProbabilityWithoutAFit) {
  const FragilityCurve curve = fragility_curve({level(1.0, 0, 20), level(2.0, 0, 20)}, 0.95);
  EXPECT_FALSE(curve.levels[0].fitted.has_value());
  EXPECT_EQ(curve.missed_levels(), 0U);
}

}  // namespace
}  // namespace rocking
