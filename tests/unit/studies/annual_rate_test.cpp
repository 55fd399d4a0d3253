// The mean annual rate: closed forms, ranges that add up, and curves without a function.

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "rocking/studies/annual_rate.hpp"

namespace rocking {
namespace {

const HazardCurve& power_law() {  // H = 1e-3 x^-2
  static const HazardCurve hazard{.name = "", .intensity = "", .points = {{0.01, 10.0}, {0.1, 0.1}, {10.0, 1e-5}}};
  return hazard;
}

SuiteCurve suite_with(double median, double between, double within) {
  SuiteCurve curve;
  curve.pooled.emplace();
  curve.pooled->law = {.median = median, .between_records = between, .within_record = within, .log_likelihood = 0.0};
  for (const double x : {0.5, 1.0, 2.0}) {
    curve.levels.push_back({.intensity = x, .records = 1, .happened = {}, .estimate = 0.0, .fitted = {}, .band = {}});
  }
  return curve;
}

// Of H = k0 x^-k and a lognormal capacity: H(median) exp(k^2 dispersion^2/2) (Cornell 1996).
TEST(AnnualRate, OfAPowerLawIsThatOfItsClosedForm) {
  const auto rate = annual_rate(suite_with(1.0, 0.3, 0.2), power_law());
  ASSERT_TRUE(rate);
  EXPECT_NEAR(rate->value, 1e-3 * std::exp(2.0 * (0.09 + 0.04)), 1e-9 * rate->value + 1e-12);
  const auto steep = annual_rate(suite_with(1.0, 1e-4, 0.0), power_law());
  EXPECT_NEAR(steep->value, 1e-3 * std::exp(2.0 * 1e-8), 1e-11);
}

TEST(AnnualRate, IsTheSumOfItsRanges) {
  const auto rate = annual_rate(suite_with(1.0, 0.3, 0.2), power_law());
  ASSERT_TRUE(rate);
  ASSERT_EQ(rate->by_level.size(), 4U);
  double sum = 0.0, untested = 0.0;
  for (const RateInRange& range : rate->by_level) {
    sum += range.rate;
    if (!range.is_tested) untested += range.share;
  }
  EXPECT_NEAR(sum, rate->value, 1e-15);
  EXPECT_NEAR(untested, rate->untested_share, 1e-15);
  EXPECT_FALSE(rate->by_level.front().is_tested);
  EXPECT_TRUE(rate->by_level[1].is_tested);
  EXPECT_FALSE(rate->by_level.back().to.has_value());
}

TEST(AnnualRate, WithoutAFunctionLiesBetweenTheRatesThatItsLevelsAllow) {
  std::vector<stats::IntensityLevel> levels;
  for (const double x : {0.5, 1.0, 2.0}) levels.push_back({.intensity = x, .happened = std::vector<bool>(20, x > 1.5)});
  const FragilityCurve curve = fragility_curve(levels, 0.95, 1);
  ASSERT_FALSE(curve.fit.law);
  const AnnualRate rate = annual_rate(curve, power_law());
  EXPECT_EQ(rate.source, RateSource::levels);
  // All above 2, none below 1, and linear in ln x between.
  EXPECT_GT(rate.value, 1e-3 / 4.0);
  EXPECT_LT(rate.value, 1e-3);
  EXPECT_LT(rate.interval->low, rate.value);
  EXPECT_GT(rate.interval->high, rate.value);
}

TEST(AnnualRate, IsAbsentWhereTheSuiteHasNoLaw) { EXPECT_FALSE(annual_rate(SuiteCurve{}, power_law())); }

}  // namespace
}  // namespace rocking
