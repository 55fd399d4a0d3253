// The mean annual rate: closed forms, ranges that add up, and curves without a function.

#include <cmath>

#include <gtest/gtest.h>

#include "rocking/studies/curves/look.hpp"
#include "rocking/studies/fragility/fragility.hpp"

namespace rocking {
namespace {

const HazardCurve& power_law() {  // H = 1e-3 x^-2
  static const HazardCurve hazard{
      .name = "", .intensity = "", .header_line = 0, .points = {{0.01, 10.0}, {0.1, 0.1}, {10.0, 1e-5}}};
  return hazard;
}

SuiteCurve suite_with(double median, double between, double within) {
  SuiteCurve curve;
  PooledSuite& pooled = curve.pooled.emplace();
  pooled.median.value = median;
  pooled.between_records.value = between;
  pooled.within_record.value = within;
  RecordCurve& record = curve.records.emplace_back();
  for (const double x : {0.5, 1.0, 2.0}) {
    curve.levels.emplace_back().intensity = x;
    record.curve.levels.push_back({.intensity = x, .overturned = {.successes = 1, .trials = 2}});
  }
  return curve;
}

/// The rate by the law.
AnnualRate rate_by_law(const SuiteCurve& curve) { return annual_rate(curve, power_law()).chosen; }

// Of H = k0 x^-k and a lognormal capacity: H(median) exp(k^2 dispersion^2/2) (Cornell 1996).
TEST(AnnualRate, OfAPowerLawIsThatOfItsClosedForm) {
  const AnnualRate rate = rate_by_law(suite_with(1.0, 0.3, 0.2));
  EXPECT_NEAR(rate.value, 1e-3 * std::exp(2.0 * (0.09 + 0.04)), 1e-9 * rate.value + 1e-12);
  const AnnualRate steep = rate_by_law(suite_with(1.0, 1e-4, 0.0));
  EXPECT_NEAR(steep.value, 1e-3 * std::exp(2.0 * 1e-8), 1e-11);
}

TEST(AnnualRate, IsTheSumOfItsRanges) {
  const AnnualRate rate = rate_by_law(suite_with(1.0, 0.3, 0.2));
  ASSERT_EQ(rate.by_level.size(), 4U);
  double sum = 0.0, untested = 0.0;
  for (const RateInRange& range : rate.by_level) {
    sum += range.rate;
    if (!range.is_tested) untested += range.share;
  }
  EXPECT_NEAR(sum, rate.value, 1e-15);
  EXPECT_NEAR(untested, rate.untested_share, 1e-15);
  EXPECT_FALSE(rate.by_level.front().is_tested);
  EXPECT_TRUE(rate.by_level[1].is_tested);
  EXPECT_FALSE(rate.by_level.back().to.has_value());
}

TEST(AnnualRate, SaysWhyItHasNoInterval) {
  AnnualRate rate = rate_by_law(suite_with(1.0, 0.3, 0.2));
  ASSERT_FALSE(rate.interval);
  EXPECT_EQ(rate_sources_in_words(rate, {}),
            "no interval of the rate: too few bootstrap samples over the records have a law\n");
  rate.interval = {.low = 0.0, .high = 1.0};
  EXPECT_EQ(rate_sources_in_words(rate, {}), "");
}

TEST(AnnualRate, DoesNotCountIntensitiesThatCannotLiftTheBlock) {
  SuiteCurve curve = suite_with(1.0, 0.3, 0.2);
  const AnnualRate plain = rate_by_law(curve);
  EXPECT_EQ(plain.impossible, 0.0);
  curve.subject.least_uplift = 0.8;
  const AnnualRate cut = rate_by_law(curve);
  EXPECT_NEAR(cut.value + cut.impossible, plain.value, 1e-12 * plain.value);
  // Integral of Phi(ln x/s) 2e-3 x^-3 dx above 0.8, by parts: exp(2 s^2) 1e-3 (1 - Phi(u)) + Phi(z) H(0.8), u = z + 2 s.
  const double s = std::sqrt(0.13), z = std::log(0.8) / s;
  const auto phi = [](double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); };
  const double expected = 1e-3 * std::exp(2.0 * s * s) * phi(-z - 2.0 * s) + phi(z) * 1e-3 / 0.64;
  EXPECT_NEAR(cut.value, expected, 1e-12 * expected);
  // The level 0.5 cannot lift the block: the range from the least uplift to the level 1 is not tested.
  ASSERT_EQ(cut.by_level.size(), 3U);
  EXPECT_EQ(cut.by_level[0].from, 0.8);
  EXPECT_EQ(cut.by_level[0].to, 1.0);
  EXPECT_FALSE(cut.by_level[0].is_tested);
  EXPECT_EQ(cut.below_levels, cut.by_level[0].rate);
  EXPECT_TRUE(cut.by_level[1].is_tested);
  EXPECT_NEAR(cut.untested_share, 1.0 - cut.by_level[1].share, 1e-15);
  EXPECT_EQ(cut.probability_at_first, 0.0);  // nothing below the hazard curve could overturn
}

TEST(AnnualRate, CountsFromTheFirstPointOfTheHazardIfTheBlockLiftsBelow) {
  SuiteCurve curve = suite_with(1.0, 0.3, 0.2);
  curve.subject.least_uplift = 0.004;
  const AnnualRate rate = rate_by_law(curve);
  EXPECT_EQ(rate.impossible, 0.0);
  EXPECT_EQ(rate.by_level.front().from, 0.01);
  EXPECT_EQ(rate.below_levels, rate.by_level.front().rate);
  EXPECT_GT(rate.below_levels, 0.0);
}

TEST(AnnualRate, TakesALevelAtTheLeastUpliftAsTested) {
  for (const double rounded : {1.0 - 1e-15, 1.0, 1.0 + 1e-15}) {
    SuiteCurve curve = suite_with(1.0, 0.3, 0.2);
    curve.subject.least_uplift = 0.5 * rounded;
    const AnnualRate rate = rate_by_law(curve);
    ASSERT_EQ(rate.by_level.size(), 3U) << rounded;
    EXPECT_TRUE(rate.by_level.front().is_tested) << rounded;
    EXPECT_EQ(rate.below_levels, 0.0) << rounded;
  }
}

TEST(AnnualRate, OfLevelsOrOfOneMotionIsCutAtTheLeastUpliftToo) {
  std::vector<stats::IntensityLevel> levels, scattered;
  for (const double x : {0.5, 1.0, 2.0}) {
    levels.push_back({.intensity = x, .happened = std::vector<bool>(20, x > 1.5)});
    scattered.push_back({.intensity = x, .happened = {}});
    for (int j = 0; j < 20; ++j) scattered.back().happened.push_back(j < 8.0 * x + (j % 3 == 0 ? 3.0 : 0.0));
  }
  for (const auto& given : {levels, scattered}) {
    FragilityCurve curve = fragility_curve(given, 0.95, 1);
    const AnnualRate plain = annual_rate(curve, power_law());
    curve.subject.least_uplift = 1.25;
    const AnnualRate cut = annual_rate(curve, power_law());
    EXPECT_NEAR(cut.value + cut.impossible, plain.value, 1e-12 * plain.value);
    EXPECT_GT(cut.impossible, 0.0);
    EXPECT_LT(cut.interval->low, cut.value);
    EXPECT_LT(cut.interval->high, plain.interval->high);
    if (cut.source == RateSource::levels) {
      EXPECT_LE(cut.interval->high, 1e-3 / 1.5625 * (1.0 + 1e-12));  // H at the least uplift
    }
    EXPECT_EQ(cut.by_level.front().from, 1.25);
  }
}

// The hazard curve ends at 0.2 g, and the block lifts at 0.25 g: the whole rate is from beyond the curve.
TEST(AnnualRate, SaysWhatComesFromBeyondTheHazardCurve) {
  SuiteCurve curve = suite_with(1.0, 0.3, 0.2);
  const double whole = rate_by_law(curve).value;
  const HazardCurve up_to_one{.name = "", .intensity = "", .header_line = 0, .points = {{0.01, 10.0}, {1.0, 1e-3}}};
  const AnnualRate half = annual_rate(curve, up_to_one).chosen;
  EXPECT_NEAR(half.value, whole, 1e-12 * whole);
  // The law beyond x = 1: exp(2 s^2) Phi(-2 s) + 1/2 times H(1), by parts.
  const double s = std::sqrt(0.13);
  const double beyond = 1e-3 * (0.5 + std::exp(2.0 * s * s) * 0.5 * std::erfc(2.0 * s / std::sqrt(2.0)));
  EXPECT_NEAR(half.extrapolated_hazard, beyond / whole, 1e-12);
  EXPECT_NEAR(half.within_hazard, whole - beyond, 1e-12 * whole);
  curve.subject.least_uplift = 0.25;
  const HazardCurve weak{.name = "", .intensity = "", .header_line = 0, .points = {{0.01, 10.0}, {0.2, 0.025}}};
  const AnnualRate none = annual_rate(curve, weak).chosen;
  EXPECT_GT(none.value, 0.0);
  EXPECT_EQ(none.extrapolated_hazard, 1.0);
  EXPECT_EQ(none.within_hazard, 0.0);
  // A rate of 0 at the last point ends the hazard.
  const HazardCurve ended{
      .name = "", .intensity = "", .header_line = 0, .points = {{0.01, 10.0}, {1.0, 1e-3}, {2.0, 0.0}}};
  const AnnualRate known = annual_rate(curve, ended).chosen;
  EXPECT_EQ(known.extrapolated_hazard, 0.0);
  EXPECT_EQ(known.within_hazard, known.value);
}

TEST(AnnualRate, OfOneMotionSaysWhatComesFromBeyondTheHazardCurve) {
  std::vector<stats::IntensityLevel> levels;
  for (const double x : {0.5, 1.0, 2.0}) levels.push_back({.intensity = x, .happened = std::vector<bool>(20, x > 1.5)});
  const FragilityCurve curve = fragility_curve(levels, 0.95, 1);
  const HazardCurve up_to_two{.name = "", .intensity = "", .header_line = 0, .points = {{0.01, 10.0}, {2.0, 2.5e-4}}};
  const AnnualRate rate = annual_rate(curve, up_to_two);
  EXPECT_NEAR(rate.extrapolated_hazard, 2.5e-4 / rate.value, 1e-12);  // all realisations overturn beyond
  EXPECT_NEAR(rate.within_hazard, rate.value - 2.5e-4, 1e-15);
}

TEST(AnnualRate, OfOneMotionDoesNotRiseWhereHazardIsTakenAway) {
  std::vector<stats::IntensityLevel> levels;
  for (const double x : {0.5, 1.0, 2.0}) levels.push_back({.intensity = x, .happened = std::vector<bool>(20, x > 0.7)});
  FragilityCurve curve = fragility_curve(levels, 0.95, 1);
  curve.subject.least_uplift = 0.4;
  double before = annual_rate(curve, power_law()).value;
  for (double cut = 0.02; cut < 9.0; cut *= 1.07) {
    const HazardCurve less{
        .name = "", .intensity = "", .header_line = 0, .points = {{cut, 1e-3 / (cut * cut)}, {10.0, 1e-5}}};
    const double after = annual_rate(curve, less).value;
    EXPECT_LE(after, before * (1.0 + 1e-12)) << cut;
    before = after;
  }
}

TEST(AnnualRate, WithoutAFunctionLiesBetweenTheRatesThatItsLevelsAllow) {
  std::vector<stats::IntensityLevel> levels;
  for (const double x : {0.5, 1.0, 2.0}) levels.push_back({.intensity = x, .happened = std::vector<bool>(20, x > 1.5)});
  const FragilityCurve curve = fragility_curve(levels, 0.95, 1);
  ASSERT_FALSE(curve.law);
  const AnnualRate rate = annual_rate(curve, power_law());
  EXPECT_EQ(rate.source, RateSource::levels);
  // All above 2, none below 1, and linear in ln x between.
  EXPECT_GT(rate.value, 1e-3 / 4.0);
  EXPECT_LT(rate.value, 1e-3);
  EXPECT_LT(rate.interval->low, rate.value);
  EXPECT_GT(rate.interval->high, rate.value);
}

}  // namespace
}  // namespace rocking
