// The lognormal law of overturning: compared with statsmodels, its coverage, and the cases without a law.

#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "rocking/stats/fragility.hpp"
#include "support/split_mix.hpp"

namespace {

using namespace rocking::stats;
using Json = nlohmann::json;

std::vector<bool> trials_in(const std::string& text) {
  std::vector<bool> happened;
  for (const char c : text) happened.push_back(c == '1');
  return happened;
}

/// The trials of a text, five times.
std::string five_of(const std::string& trials) { return trials + trials + trials + trials + trials; }

/// Levels at intensities 1, 2, 3, ...
std::vector<IntensityLevel> levels_of(const std::vector<std::string>& happened) {
  std::vector<IntensityLevel> levels;
  for (const std::string& text : happened) {
    levels.push_back({.intensity = static_cast<double>(levels.size()) + 1.0, .happened = trials_in(text)});
  }
  return levels;
}

FragilityOutcome outcome_of(const std::vector<std::string>& happened) {
  return fit_lognormal(levels_of(happened)).outcome;
}

TEST(Fragility, AgreesWithStatsmodelsOnLawAndCovariance) {
  const Json oracle = Json::parse(std::ifstream(ROCKING_SOURCE_DIR "/tests/oracles/statsmodels_fragility.json"));
  ASSERT_GE(oracle["cases"].size(), 6U);
  for (const Json& known : oracle["cases"]) {
    std::vector<IntensityLevel> levels;
    for (std::size_t i = 0; i < known["intensities"].size(); ++i) {
      levels.push_back({.intensity = known["intensities"][i], .happened = trials_in(known["happened"][i])});
    }
    const auto law = fit_lognormal(levels).law;
    ASSERT_TRUE(law) << known;
    EXPECT_NEAR(law->centre, known["centre"].get<double>(), 1e-14);
    EXPECT_NEAR(law->intercept, known["intercept"].get<double>(), 1e-9);
    EXPECT_NEAR(law->slope, known["slope"].get<double>(), 1e-9 * law->slope);
    const double scale = known["covariance"][2].get<double>();
    EXPECT_NEAR(law->covariance.aa, known["covariance"][0].get<double>(), 1e-8 * scale);
    EXPECT_NEAR(law->covariance.ab, known["covariance"][1].get<double>(), 1e-8 * scale);
    EXPECT_NEAR(law->covariance.bb, scale, 1e-8 * scale);
  }
}

TEST(Fragility, GoesThroughTwoSharesAtTwoIntensities) {
  const auto levels = levels_of({five_of("1000000000"), five_of("1111100000")});
  const auto law = fit_lognormal(levels).law;
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->probability(1.0), 0.1, 1e-12);
  EXPECT_NEAR(law->probability(2.0), 0.5, 1e-12);
  EXPECT_NEAR(law->median(0.95).value, 2.0, 1e-11);
  EXPECT_NEAR(law->dispersion(0.95).value, std::log(2.0) / 1.2815515655446004, 1e-11);
}

TEST(Fragility, ChangesItsMedianAloneWithTheUnitOfTheIntensity) {
  auto levels = levels_of({five_of("1000000000"), five_of("1101000000"), five_of("1111101100")});
  const auto law = fit_lognormal(levels).law;
  for (IntensityLevel& level : levels) level.intensity *= 1000.0;
  const auto scaled = fit_lognormal(levels).law;
  ASSERT_TRUE(law && scaled);
  EXPECT_NEAR(scaled->median(0.9).value, 1000.0 * law->median(0.9).value, 1e-8);
  EXPECT_NEAR(scaled->median(0.9).interval.high, 1000.0 * law->median(0.9).interval.high, 1e-8);
  EXPECT_NEAR(scaled->dispersion(0.9).value, law->dispersion(0.9).value, 1e-11);
  EXPECT_NEAR(scaled->band(2500.0, 0.9).low, law->band(2.5, 0.9).low, 1e-11);
}

// The median's interval holds the intensities at which the band contains 1/2.
TEST(Fragility, HasTheMediansIntervalWhereItsBandReachesAHalf) {
  for (const auto& happened :
       {std::vector<std::string>{five_of("1000000000"), five_of("1101000000"), five_of("1111101100")},
        std::vector<std::string>{five_of("0000000000"), five_of("1000000000"), five_of("1101000000")}}) {
    const auto law = fit_lognormal(levels_of(happened)).law;
    ASSERT_TRUE(law);
    const Bounded median = law->median(0.95);
    EXPECT_NEAR(law->band(median.interval.low, 0.95).high, 0.5, 1e-12);
    EXPECT_NEAR(law->band(median.interval.high, 0.95).low, 0.5, 1e-12);
    EXPECT_LT(median.interval.low, median.value);
    EXPECT_GT(median.interval.high, median.value);
    EXPECT_TRUE(std::isinf(law->median(1.0 - 1e-12).interval.high)) << "the slope may be 0 at this confidence";
  }
}

TEST(Fragility, HasADegreeOfFreedomForEachTrialThatDiffersButOne) {
  const auto law = fit_lognormal(levels_of({"0000000000"
                                            "0000000000"
                                            "1000000000",
                                            "0000000000"
                                            "0011111111"
                                            "1111111111",
                                            "0000000001"
                                            "1111111111"
                                            "1111111111"}))
                       .law;
  ASSERT_TRUE(law);
  EXPECT_EQ(law->degrees_of_freedom, 13.0 - 1.0) << "17 of 30 trials do the same";
  LognormalFragility normal = *law;
  normal.degrees_of_freedom = INFINITY;
  EXPECT_NEAR(std::log(normal.dispersion(0.95).interval.high / normal.dispersion(0.95).value) / 1.959963984540054,
              std::sqrt(normal.covariance.bb) / normal.slope, 1e-12);
  EXPECT_NEAR(std::log(law->dispersion(0.95).interval.high / law->dispersion(0.95).value) / 2.178812829663418,
              std::sqrt(law->covariance.bb) / law->slope, 1e-12);
}

TEST(Fragility, NeedsASlopeThatDiffersFromZeroAtItsConfidence) {
  const auto levels = levels_of({five_of("1000000000"), five_of("1101000000")});
  EXPECT_EQ(fit_lognormal(levels, 0.95).outcome, FragilityOutcome::fitted);
  EXPECT_EQ(fit_lognormal(levels, 0.9999).outcome, FragilityOutcome::does_not_rise);
}

TEST(Fragility, IsNamedWhereThereIsNoLaw) {
  using enum FragilityOutcome;
  EXPECT_EQ(outcome_of({"000", "000"}), never_happened);
  EXPECT_EQ(outcome_of({"111", "111"}), always_happened);
  EXPECT_EQ(outcome_of({"000", "000", "111"}), separated);
  EXPECT_EQ(outcome_of({"000", "010", "111"}), separated);
  EXPECT_EQ(outcome_of({"000", "010"}), separated);
  EXPECT_EQ(outcome_of({"010", "111"}), separated);
  EXPECT_EQ(outcome_of({"111", "000"}), does_not_rise);
  EXPECT_EQ(outcome_of({"111", "010", "000"}), does_not_rise);
  EXPECT_EQ(outcome_of({"110", "100", "100"}), does_not_rise);
  EXPECT_EQ(outcome_of({"110", "110"}), does_not_rise);
  EXPECT_EQ(outcome_of({"010"}), too_little);
  EXPECT_EQ(outcome_of({"0", "1", "0", "1"}), too_little);
  EXPECT_EQ(outcome_of({"010", "101"}), no_scatter);
  EXPECT_EQ(outcome_of({"100000000000000", "010101010101010", "111111111111110"}), fitted);
  EXPECT_FALSE(fit_lognormal(levels_of({"000", "111"})).law);
}

TEST(Fragility, HasNoLawWhereTrialsDifferInOneWayAtMost) {
  using enum FragilityOutcome;
  const std::string never(12, '0');
  const std::string always(12, '1');
  EXPECT_EQ(outcome_of({never, never, never, always, never, never, always, always}), no_scatter);
  const std::string some = "000111000000";
  EXPECT_EQ(outcome_of({never, always, never, some, always}), no_scatter);              // at one level
  EXPECT_EQ(outcome_of({never, some, never, some, always, some, always}), no_scatter);  // together at several
  auto levels = levels_of({never, always, never, some, some, always});
  levels[4].intensity = levels[3].intensity;
  EXPECT_EQ(fit_lognormal(levels).outcome, no_scatter);
}

// Levels with fewer trials give the trial numbers different scores, although all trials of a level do the same.
TEST(Fragility, HasNoLawWhereTrialsDifferInTheirLevelsOnly) {
  EXPECT_EQ(outcome_of({"0000", "111", "00", "1111", "1111"}), FragilityOutcome::no_scatter);
}

TEST(Fragility, HasALawOfPositiveWidthWhereTrialsDifferInTwoWays) {
  std::vector<IntensityLevel> levels =
      levels_of({"100000000000", "000000000000", "110111101111", std::string(12, '1')});
  levels[3].intensity = levels[2].intensity * (1.0 + 1e-6);  // levels that nearly coincide
  levels[1].intensity = levels[0].intensity * (1.0 + 1e-6);
  const auto law = fit_lognormal(levels).law;
  ASSERT_TRUE(law);
  for (const double intensity : {1.0, 1.3, 1.7, 2.0, 3.0}) {
    EXPECT_LT(law->band(intensity, 0.95).low, law->band(intensity, 0.95).high);
  }
}

TEST(Fragility, IsFittedWhereOneTrialOfAThousandKeepsTheLikelihoodFromHavingNoMaximum) {
  std::string few(1000, '0');
  std::string most(1000, '1');
  few[17] = '1';
  most[400] = '0';
  const auto law = fit_lognormal(levels_of({std::string(1000, '0'), few, most, std::string(1000, '1')})).law;
  ASSERT_TRUE(law);
  EXPECT_GT(law->slope, 10.0);
  EXPECT_GT(law->covariance.bb, 0.0);
  EXPECT_LT(law->dispersion(0.95).interval.low, law->dispersion(0.95).value);
}

// The same trials once and ten times at every intensity: the information on the capacity is the same.
TEST(Fragility, TreatsTrialsWithCommonRandomNumbersAsOneCluster) {
  const std::vector<std::string> happened{"1000000000", "1111100000", "1111111110"};
  auto levels = levels_of(happened);
  const auto once = fit_lognormal(levels).law;
  for (int again = 0; again < 9; ++again) {
    const auto more = levels_of(happened);
    levels.insert(levels.end(), more.begin(), more.end());
  }
  const auto often = fit_lognormal(levels).law;
  ASSERT_TRUE(once && often);
  EXPECT_NEAR(often->intercept, once->intercept, 1e-10);
  EXPECT_NEAR(often->covariance.aa, once->covariance.aa, 1e-8);
  EXPECT_NEAR(often->covariance.bb, once->covariance.bb, 1e-8);
}

/// Number of `runs` simulated experiments whose intervals contain the true value.
struct Coverage {
  int median = 0, dispersion = 0, band = 0, fitted = 0;
};

/// `shared`: whether a trial number has the same capacity at all intensities, or independent ones.
Coverage coverage(bool shared, int runs) {
  constexpr double median = 3.0, dispersion = 0.4;
  rocking::support::SplitMix random(2012);
  const auto capacity = [&random] {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
    return median * std::exp(dispersion * radius * std::cos(2.0 * M_PI * random.uniform()));
  };
  Coverage found;
  for (int run = 0; run < runs; ++run) {
    auto levels = levels_of(std::vector<std::string>(7, std::string(100, '0')));
    for (std::size_t j = 0; j < 100; ++j) {
      double own = capacity();
      for (IntensityLevel& level : levels) {
        level.happened[j] = own < level.intensity;
        if (!shared) own = capacity();
      }
    }
    const auto law = fit_lognormal(levels).law;
    if (!law) continue;
    const auto holds = [](const Interval& interval, double truth) {
      return interval.low <= truth && truth <= interval.high;
    };
    ++found.fitted;
    found.median += holds(law->median(0.95).interval, median) ? 1 : 0;
    found.dispersion += holds(law->dispersion(0.95).interval, dispersion) ? 1 : 0;
    found.band += holds(law->band(median, 0.95), 0.5) ? 1 : 0;
  }
  return found;
}

/// Seeds are fixed, so that the counts never change; they are farther from these bounds than chance explains.
TEST(Fragility, CoversTheTruthWithCommonAndWithIndependentRandomNumbers) {
  for (const bool shared : {false, true}) {
    const Coverage found = coverage(shared, 1000);
    EXPECT_EQ(found.fitted, 1000) << shared;
    for (const int count : {found.median, found.dispersion, found.band}) {
      EXPECT_GT(count, 915) << shared << ' ' << found.median << ' ' << found.dispersion << ' ' << found.band;
      EXPECT_LT(count, 985) << shared << ' ' << found.median << ' ' << found.dispersion << ' ' << found.band;
    }
  }
}

}  // namespace
