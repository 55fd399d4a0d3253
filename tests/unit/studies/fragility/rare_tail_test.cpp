// The annual rate with rare estimates in its lower tail: cases with known answers.

#include "rocking/studies/curves/rare_tail.hpp"
#include "rocking/stats/suite_bootstrap.hpp"

#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include <boost/math/distributions/normal.hpp>
#include <gtest/gtest.h>

#include "rocking/stats/normal_law.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "support/made_up_suite.hpp"

namespace rocking {
namespace {

using namespace support::six_records;

constexpr double median = 1.0;
constexpr double dispersion = 0.4;

double lognormal(double x) { return stats::normal_cdf(std::log(x / median) / dispersion); }

const HazardCurve& hazard_of_tails() {  // H = 1e-3 x^-3
  static const HazardCurve hazard{
      .name = "", .intensity = "", .header_line = 0, .points = {{0.01, 1000.0}, {0.1, 1.0}, {10.0, 1e-6}}};
  return hazard;
}

/// A fitted lognormal law; at 0.2 and 0.4 too few events for a share.
FragilityCurve curve_with_law() {
  FragilityCurve curve;
  FittedLaw& law = curve.law.emplace();
  law.function.intercept = 0.0;
  law.function.centre = std::log(median);
  law.function.slope = 1.0 / dispersion;
  law.function.covariance = {.aa = 0.01, .ab = 0.0, .bb = 0.04};
  for (const auto& [x, events] :
       std::vector<std::pair<double, std::uint64_t>>{{0.2, 0}, {0.4, 9}, {0.8, 10}, {1.6, 90}}) {
    curve.levels.push_back({.intensity = x, .overturned = {.successes = events, .trials = 100}});
  }
  return curve;
}

RareLevel rare_level(double x, double probability) {
  return {.intensity = x,
          .probability = probability,
          .interval = {0.5 * probability, 2.0 * probability},
          .relative_error = 0.1,
          .degrees_of_freedom = 15.0};
}

TEST(RareTail, OfTheFittedLawItselfChangesNothing) {
  FragilityCurve curve = curve_with_law();
  const AnnualRate without = annual_rate(curve, hazard_of_tails());
  for (const double x : {0.1, 0.2, 0.5}) curve.rare.push_back(rare_level(x, lognormal(x)));
  const AnnualRate with = annual_rate(curve, hazard_of_tails());
  EXPECT_NEAR(with.value / without.value, 1.0, 1e-9);
  EXPECT_FALSE(without.rare_below);
  EXPECT_EQ(with.rare_below, 0.8) << "the lowest level with ten events";
  double sum = 0.0;
  for (const auto& range : with.by_level) sum += range.rate;
  EXPECT_NEAR(sum / with.value, 1.0, 1e-12);
  EXPECT_EQ(with.by_level[1].from, 0.1);
  EXPECT_TRUE(with.by_level[1].is_tested);
}

// Twice the probabilities: integral over x < 0.8 by the trapezoidal rule, of the line on the probit scale.
TEST(RareTail, ReplacesTheLawBelowTheLevels) {
  FragilityCurve curve = curve_with_law();
  const double first = std::log(0.3), last = std::log(0.8);
  curve.rare = {rare_level(0.3, 2.0 * lognormal(0.3)), rare_level(0.9, 0.3)};
  const AnnualRate rate = annual_rate(curve, hazard_of_tails());
  double z_first = std::log(0.3 / median) / dispersion;
  while (stats::normal_cdf(z_first) < 2.0 * lognormal(0.3)) z_first += 1e-6;
  const double z_last = std::log(0.8 / median) / dispersion;
  double expected = 0.0;
  constexpr int steps = 200'000;
  const double low = std::log(0.01), high = std::log(100.0), h = (high - low) / steps;
  for (int i = 0; i < steps; ++i) {
    const double y = low + (i + 0.5) * h;
    const double line = z_first + (z_last - z_first) * (y - first) / (last - first);
    const double p = y < last ? stats::normal_cdf(line) : lognormal(std::exp(y));
    expected += p * 3e-3 * std::exp(-3.0 * y) * h;
  }
  EXPECT_NEAR(rate.value / expected, 1.0, 1e-5);
}

// Where the hazard is steep and begins at the estimate, the rate is nearly in proportion to it.
TEST(RareTail, HasTheErrorOfItsEstimates) {
  FragilityCurve curve = curve_with_law();
  curve.law->function.covariance = {.aa = 1e-12, .ab = 0.0, .bb = 1e-12};
  curve.rare = {rare_level(0.3, 0.2)};
  const HazardCurve steep{.name = "", .intensity = "", .header_line = 0, .points = {{0.3, 1.0}, {0.6, 1e-6}}};
  const AnnualRate rate = annual_rate(curve, steep);
  ASSERT_TRUE(rate.interval);
  const double reach = std::log(rate.interval->high / rate.value);
  const double expected = 0.1 * stats::two_sided_t_quantile(0.95, 15.0);
  EXPECT_GT(reach, 0.8 * expected);
  EXPECT_LT(reach, 1.01 * expected);
  curve.rare.front().relative_error = 0.2;
  const AnnualRate wider = annual_rate(curve, steep);
  EXPECT_NEAR(std::log(wider.interval->high / wider.value) / reach, 2.0, 0.02);
}

TEST(RareTail, BoundsARateOfLevels) {
  FragilityCurve curve = curve_with_law();
  curve.law.reset();
  for (auto& level : curve.levels) {
    level.estimate = static_cast<double>(level.overturned.successes) / 100.0;
    level.simultaneous = {0.8 * level.estimate, std::min(1.0, 1.2 * level.estimate + 0.05)};
  }
  const AnnualRate without = annual_rate(curve, hazard_of_tails());
  curve.rare = {rare_level(0.1, 1e-8), rare_level(0.4, 1e-3)};
  const AnnualRate with = annual_rate(curve, hazard_of_tails());
  EXPECT_LT(with.interval->high, 0.1 * without.interval->high) << "below the levels 1 was possible";
  EXPECT_LT(with.interval->low, with.value);
  EXPECT_LT(with.value, with.interval->high);
}

void set_events(const std::vector<std::uint64_t>& events, FragilityCurve& curve) {
  for (std::size_t i = 0; i < events.size(); ++i) curve.levels[i].overturned.successes = events[i];
}

// Without a level of ten events all are used: up to the level above them with the most.
TEST(RareTail, IsUsedEverywhereWithoutALevelOfTenEvents) {
  FragilityCurve curve = curve_with_law();
  set_events({0, 1, 2, 9}, curve);
  const AnnualRate without = annual_rate(curve, hazard_of_tails());
  curve.rare = {rare_level(0.3, 2.0 * lognormal(0.3)), rare_level(0.5, 2.0 * lognormal(0.5))};
  const AnnualRate rate = annual_rate(curve, hazard_of_tails());
  EXPECT_EQ(rate.rare_below, 1.6);
  EXPECT_EQ(rate.rare_use, rocking::RareUse::below_best_level);
  EXPECT_GT(std::abs(rate.value / without.value - 1.0), 0.05);
  FragilityCurve sure = curve;
  set_events({0, 1, 2, 10}, sure);
  EXPECT_EQ(annual_rate(sure, hazard_of_tails()).value, rate.value) << "an event more changes nothing";
  EXPECT_EQ(annual_rate(sure, hazard_of_tails()).rare_use, rocking::RareUse::below_sure_level);
}

// No level above the estimates has an event: the probability stays at the highest one.
TEST(RareTail, EndsAtItsHighestEstimateWhereNoLevelAboveHasAnEvent) {
  FragilityCurve curve = curve_with_law();
  curve.law.reset();
  set_events({0, 0, 0, 0}, curve);
  for (auto& level : curve.levels) level.simultaneous = {0.0, 0.05};
  curve.rare = {rare_level(0.5, 1e-5), rare_level(1.0, 1e-3)};
  const AnnualRate rate = annual_rate(curve, hazard_of_tails());
  EXPECT_EQ(rate.rare_use, rocking::RareUse::up_to_highest);
  EXPECT_EQ(rate.rare_below, 1.0);
  ASSERT_TRUE(rate.interval);
  const double above = 1e-3 * 1e-3;  // H(1) = 1e-3
  EXPECT_GT(rate.value, above);
  EXPECT_LT(rate.value, 3.0 * above);
  EXPECT_GT(rate.interval->low, 0.5 * above);
  EXPECT_GT(rate.interval->high, rate.value);
  curve.rare.pop_back();
  EXPECT_EQ(annual_rate(curve, hazard_of_tails()).rare_use, rocking::RareUse::not_used);
  curve.rare.clear();
  EXPECT_FALSE(annual_rate(curve, hazard_of_tails()).rare_use);
}

TEST(RareTail, SaysThatItIsNotUsed) {
  FragilityCurve curve = curve_with_law();
  curve.rare = {rare_level(0.9, 0.3)};
  const AnnualRate rate = annual_rate(curve, hazard_of_tails());
  EXPECT_EQ(rate.rare_use, rocking::RareUse::not_used);
  EXPECT_FALSE(rate.rare_below);
}

TEST(RareTailOfASuite, IntegratesTheMeanOverTheRecords) {
  const SuiteRate rate = annual_rate(with_rare(unlike), hazard());
  EXPECT_EQ(rate.chosen.rare_below, 0.4);
  const double low = 2.41e-4 / 6.0, high = 7.52e-3 / 6.0;
  const std::vector<double> shares = shares_of();
  const stats::SuiteLaw law = whole_curve().pooled->law();
  const boost::math::normal_distribution<double> normal;
  const auto with_tail = [&](const std::function<double(double)>& upper) {
    return midpoint_rate([&](double x) {
      if (x >= 0.4) return upper(x);
      const bool is_first = x < 0.3;
      const double from = is_first ? 0.25 : 0.3, to = is_first ? 0.3 : 0.4;
      const double z_from = quantile(normal, is_first ? low : high);
      const double z_to = quantile(normal, is_first ? high : upper(0.4));
      return stats::normal_cdf(z_from + (z_to - z_from) * std::log(x / from) / std::log(to / from));
    });
  };
  const double by_law = with_tail([&](double x) { return law.probability(x); });
  const double by_shares = with_tail([&](double x) { return interpolated(shares, x); });
  EXPECT_NEAR(estimate(rate, RateSource::law), by_law, 1e-6 * by_law);
  EXPECT_NEAR(rate.chosen.value, by_law, 1e-6 * by_law);
  EXPECT_NEAR(estimate(rate, RateSource::isotonic), by_shares, 1e-6 * by_shares);
  double sum = 0.0;
  for (const RateInRange& range : rate.chosen.by_level) sum += range.rate;
  EXPECT_NEAR(sum, rate.chosen.value, 1e-12 * sum);
}

/// Equal probabilities at both levels, and a hazard that ends below them: the rate is the mean over the records, and at
/// most that with an unseen record that does what the worst one does at twice the intensity: 0.9 at 0.4.
TEST(RareTailOfASuite, HasTheIntervalOfTheRecordsWithAnUnseenOne) {
  const std::vector<double> of_record{0.0, 1e-5, 6e-4, 0.0, 2e-6, 1e-4};
  std::vector<std::vector<double>> equal;
  for (const double probability : of_record) equal.push_back({probability, probability});
  const SuiteCurve found = with_rare(equal);
  const HazardCurve below{.name = "", .intensity = "", .header_line = 0, .points = {{0.2, 1.0}, {0.24, 1e-12}}};
  const SuiteRate rate = annual_rate(found, below);
  std::vector<double> highs;
  for (const std::vector<double>& shares : found.bootstrap.with_unseen) {
    highs.push_back(std::inner_product(of_record.begin(), of_record.end(), shares.begin(), 0.0) + 0.9 * shares.back());
  }
  const double high = stats::percentile_interval(highs, highs.size(), 0.95)->high;
  EXPECT_NEAR(estimate(rate, RateSource::isotonic), 7.12e-4 / 6.0, 1e-9);
  EXPECT_NEAR(rate.estimates.back().interval->low, 0.0, 1e-9);
  EXPECT_NEAR(rate.estimates.back().interval->high, high, 1e-9);
  EXPECT_NEAR(rate.chosen.value, 7.12e-4 / 6.0, 1e-9);
  EXPECT_NEAR(rate.by_record[2].share, 6e-4 / 7.12e-4, 1e-6);
}

TEST(RareTailOfASuite, IsSharedOutAmongTheRecords) {
  const SuiteRate rate = annual_rate(with_rare(unlike), hazard());
  double sum = 0.0;
  for (const RateOfRecord& record : rate.by_record) sum += record.rate;
  EXPECT_NEAR(sum / 6.0, estimate(rate, RateSource::isotonic), 1e-12 * sum) << "the means rise";
}

// Without them half of the range below the first event, 7 of 60 at 0.3, is open.
TEST(RareTailOfASuite, IsLessOpen) {
  EXPECT_LT(annual_rate(with_rare(unlike), hazard()).undecided_share,
            annual_rate(whole_curve(), hazard()).undecided_share);
}

// The same for a suite of which no level has an event: the mean estimates, and from the highest one on that.
TEST(RareTailOfASuite, IsThatOfTheEstimatesWhereNoLevelHasAnEvent) {
  SuiteCurve found =
      suite_curve(group_of(std::vector(outcomes.size(), std::vector<int>(intensities.size(), 0))), {}, 1);
  for (std::size_t k = 0; k < rare_at.size(); ++k) {
    for (std::size_t r = 0; r < unlike.size(); ++r) {
      if (unlike[r][k] > 0.0)
        found.records[r].curve.rare.push_back({.intensity = rare_at[k], .probability = unlike[r][k]});
    }
    found.rare.push_back({.intensity = rare_at[k], .probability = k == 0 ? 2.41e-4 / 6.0 : 7.52e-3 / 6.0});
  }
  const SuiteRate rate = annual_rate(found, hazard());
  EXPECT_EQ(rate.chosen.rare_use, RareUse::up_to_highest);
  EXPECT_EQ(rate.chosen.rare_below, 0.3);
  const boost::math::normal_distribution<double> normal;
  const double z_low = quantile(normal, 2.41e-4 / 6.0), z_high = quantile(normal, 7.52e-3 / 6.0);
  const double expected = midpoint_rate([&](double x) {
    if (x >= 0.3) return 7.52e-3 / 6.0;
    return stats::normal_cdf(z_low + (z_high - z_low) * std::log(x / 0.25) / std::log(0.3 / 0.25));
  });
  EXPECT_NEAR(estimate(rate, RateSource::isotonic), expected, 1e-6 * expected);
  EXPECT_NEAR(rate.chosen.value, expected, 1e-6 * expected);
  double sum = 0.0;
  for (const RateOfRecord& record : rate.by_record) sum += record.rate / static_cast<double>(unlike.size());
  EXPECT_NEAR(sum, expected, 1e-6 * expected);
}

}  // namespace
}  // namespace rocking
