// A fragility curve: what is stated at each intensity.

#include <gtest/gtest.h>

#include "rocking/studies/fragility/fragility.hpp"

namespace rocking {
namespace {

/// `successes` of `trials` happened, the first ones.
stats::IntensityLevel level(double intensity, std::size_t successes, std::size_t trials) {
  stats::IntensityLevel made{.intensity = intensity, .happened = std::vector<bool>(trials, false)};
  for (std::size_t i = 0; i < successes; ++i) made.happened[i] = true;
  return made;
}

constexpr std::uint64_t seed = 0x2012;

TEST(FragilityCurve, StatesEstimateAndIntervalsAtEachLevel) {
  constexpr double confidence = 0.9;
  const FragilityCurve curve =
      fragility_curve({level(1.0, 5, 20), level(2.0, 12, 20), level(3.0, 18, 20)}, confidence, seed);
  ASSERT_EQ(curve.levels.size(), 3U);
  const FragilityLevel& middle = curve.levels[1];
  const stats::Proportion counts{.successes = 12, .trials = 20};
  EXPECT_EQ(curve.subject.confidence, confidence);
  EXPECT_EQ(middle.intensity, 2.0);
  EXPECT_EQ(middle.estimate, 0.6);
  EXPECT_EQ(middle.exact.low, stats::clopper_pearson(counts, confidence).low);
  EXPECT_EQ(middle.simultaneous.high, stats::bonferroni_clopper_pearson(counts, confidence, 3).high);
  ASSERT_TRUE(curve.law.has_value());
  ASSERT_TRUE(middle.fitted.has_value());
  EXPECT_EQ(*middle.fitted, curve.law->function.probability(2.0));
  EXPECT_EQ(middle.band.value().low, curve.law->function.band(2.0, confidence).low);
  EXPECT_FALSE(middle.isotonic.has_value());
  EXPECT_EQ(curve.missed_levels(), 0U);
  ASSERT_TRUE(curve.test.has_value());
  EXPECT_GT(curve.test->p_value, 0.2);
  EXPECT_EQ(curve.test->samples, fragility_samples);
}

TEST(FragilityCurve, RepeatsItsTestWithTheSeed) {
  const std::vector<stats::IntensityLevel> levels{level(1.0, 15, 100), level(2.0, 40, 100), level(3.0, 75, 100)};
  const auto test = [&levels](std::uint64_t chosen) { return fragility_curve(levels, 0.95, chosen).test.value(); };
  EXPECT_EQ(test(seed).as_large, test(seed).as_large);
  EXPECT_NE(test(seed).as_large, test(seed + 1).as_large);
}

TEST(FragilityCurve, KnowsWhetherItsMedianIsExtrapolated) {
  const FragilityCurve below =
      fragility_curve({level(1.0, 5, 100), level(2.0, 20, 100), level(3.0, 42, 100)}, 0.95, seed);
  ASSERT_TRUE(below.law.has_value());
  EXPECT_GT(below.law->median.value, 3.0);
  EXPECT_TRUE(below.law->is_extrapolated);
  const FragilityCurve around =
      fragility_curve({level(1.0, 3, 100), level(2.0, 33, 100), level(3.0, 64, 100)}, 0.95, seed);
  ASSERT_TRUE(around.law.has_value());
  EXPECT_LT(around.law->median.value, 3.0);
  EXPECT_FALSE(around.law->is_extrapolated);
}

// The shares stand still between two rises, which no lognormal function does.
TEST(FragilityCurve, ReplacesARejectedFunctionByTheIsotonicEstimate) {
  const FragilityCurve curve = fragility_curve(
      {level(1.0, 2, 100), level(2.0, 50, 100), level(3.0, 54, 100), level(4.0, 46, 100), level(5.0, 98, 100)}, 0.95,
      seed);
  EXPECT_EQ(curve.outcome, stats::FragilityOutcome::rejected);
  EXPECT_FALSE(curve.law.has_value());
  EXPECT_EQ(curve.test.value().as_large, 0U);
  const std::vector<double> pooled{0.02, 0.5, 0.5, 0.5, 0.98};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_FALSE(curve.levels[i].fitted.has_value());
    ASSERT_TRUE(curve.levels[i].isotonic.has_value());
    EXPECT_EQ(*curve.levels[i].isotonic, pooled[i]);
    EXPECT_EQ(curve.levels[i].band.value().high, curve.levels[i].simultaneous.high);
  }
}

// The pooled share of the later levels lies below what the second level excludes.
TEST(FragilityCurve, KeepsTheIsotonicEstimateWithinTheSimultaneousIntervals) {
  std::vector<stats::IntensityLevel> levels{level(1.0, 0, 100), level(2.0, 68, 100)};
  for (int i = 0; i < 20; ++i) levels.push_back(level(3.0 + i, 50, 100));
  levels.push_back(level(30.0, 100, 100));
  const FragilityCurve curve = fragility_curve(levels, 0.95, seed);
  ASSERT_EQ(curve.outcome, stats::FragilityOutcome::rejected);
  double last = 0.0;
  for (const FragilityLevel& level : curve.levels) {
    EXPECT_LE(level.simultaneous.low, level.isotonic.value());
    EXPECT_LE(level.isotonic.value(), level.simultaneous.high);
    EXPECT_GE(*level.isotonic, last);
    last = *level.isotonic;
  }
  EXPECT_EQ(curve.levels[1].isotonic, curve.levels[1].simultaneous.low);
}

// Of 400 trials at each level: the share falls where the function can only rise.
TEST(FragilityCurve, GivesTheLevelsAloneWhereTheSharesFall) {
  const FragilityCurve curve = fragility_curve(
      {level(1.0, 40, 400), level(2.0, 280, 400), level(3.0, 120, 400), level(4.0, 360, 400)}, 0.95, seed);
  EXPECT_EQ(curve.outcome, stats::FragilityOutcome::not_monotone);
  EXPECT_FALSE(curve.law.has_value());
  EXPECT_TRUE(curve.test.has_value());
  for (const FragilityLevel& level : curve.levels) EXPECT_FALSE(level.fitted || level.isotonic);
}

// Levels 1.00 to 1.20 of a recorded excitation: the outcome changes several times as the intensity grows, and all
// realisations have the same outcome.
TEST(FragilityCurve, InventsNothingWhereEveryLevelIsZeroOrAHundredPerCent) {
  for (const std::size_t trials : {2U, 12U, 500U}) {
    for (const unsigned pattern :
         {0b1'1111'1111'1110'0110'0000U, 0b1'0101'0101'0101'0101'0101U, 0b0'0000'0000'0000'0001U,
          0b1'1111'1111'1111'0000'0000U, 0U, 0b1'1111'1111'1111'1111'1111U}) {
      std::vector<stats::IntensityLevel> levels;
      for (unsigned i = 0; i <= 20; ++i) {
        levels.push_back(level(1.0 + 0.01 * i, (pattern >> i & 1U) != 0 ? trials : 0, trials));
      }
      const FragilityCurve curve = fragility_curve(levels, 0.95, seed);
      EXPECT_NE(curve.outcome, stats::FragilityOutcome::fitted) << pattern;
      EXPECT_FALSE(curve.law.has_value());
      EXPECT_FALSE(curve.test.has_value());
      ASSERT_EQ(curve.levels.size(), 21U);
      for (const FragilityLevel& found : curve.levels) {
        EXPECT_LT(found.exact.low, found.exact.high);
        EXPECT_FALSE(found.fitted || found.isotonic);
      }
    }
  }
}

TEST(FragilityCurve, HasNoFittedProbabilityWithoutAFit) {
  const FragilityCurve curve = fragility_curve({level(1.0, 0, 20), level(2.0, 0, 20)}, 0.95, seed);
  EXPECT_FALSE(curve.levels[0].fitted.has_value());
  EXPECT_EQ(curve.missed_levels(), 0U);
}

// Whether a realisation without an answer has the event is not known: no law, and intervals that cover both.
TEST(FragilityCurve, CoversBothOutcomesOfRealisationsWithoutAnAnswer) {
  stats::IntensityLevel open = level(2.0, 12, 20);
  open.unresolved = 5;
  const FragilityCurve curve = fragility_curve({level(1.0, 5, 20), open, level(3.0, 18, 20)}, 0.9, seed);
  EXPECT_EQ(curve.outcome, stats::FragilityOutcome::unresolved);
  EXPECT_FALSE(curve.law);
  EXPECT_EQ(curve.levels[1].unresolved, 5U);
  EXPECT_EQ(curve.levels[1].exact.low, stats::clopper_pearson({12, 20}, 0.9).low);
  EXPECT_EQ(curve.levels[1].exact.high, stats::clopper_pearson({17, 20}, 0.9).high);
  EXPECT_EQ(curve.levels[1].simultaneous.high, stats::bonferroni_clopper_pearson({17, 20}, 0.9, 3).high);
  EXPECT_EQ(curve.levels[0].exact.high, stats::clopper_pearson({5, 20}, 0.9).high);
}

TEST(FragilityCurve, KnowsTheEventOfARealisationThatExceededTheTiltBeforeItEnded) {
  const Stripe stripe{.record = "",
                      .intensity = 1.0,
                      .overturned = {false, false, true, false},
                      .peaks = {{.tilt = 0.6}, {.tilt = 0.2}, {.tilt = 3.0}, {.tilt = 0.4}},
                      .without_answer = {true, true, false, false}};
  EXPECT_EQ(level_of(stripe, {}).unresolved, 2U);
  const stats::IntensityLevel tilted = level_of(stripe, {EventName::tilt, 0.5});
  EXPECT_EQ(tilted.unresolved, 1U);
  EXPECT_EQ(stats::proportion_at(tilted).successes, 2U);
}

// The slip at the end is not known without an end; an overturned block is lost, whatever its slip.
TEST(FragilityCurve, CountsSlipInMetresAndOverturnedBlocksWithEveryEvent) {
  const Stripe stripe{.record = "",
                      .intensity = 1.0,
                      .overturned = {false, false, true, false},
                      .peaks = {{.slip = 9.0, .slip_m = 0.06, .final_slip_m = -0.06},
                                {.slip = 9.0, .slip_m = 0.06, .final_slip_m = -0.06},
                                {.slip_m = 0.0},
                                {.slip_m = 0.07, .final_slip_m = 0.01}},
                      .without_answer = {true, false, false, false}};
  const stats::IntensityLevel slip = level_of(stripe, {EventName::slip, 0.05});
  EXPECT_EQ(slip.happened, std::vector<bool>(4, true));
  EXPECT_EQ(slip.unresolved, 0U);
  const stats::IntensityLevel displacement = level_of(stripe, {EventName::displacement, 0.05});
  EXPECT_EQ(displacement.happened, (std::vector<bool>{false, true, true, false}));
  EXPECT_EQ(displacement.unresolved, 1U);
}

}  // namespace
}  // namespace rocking
