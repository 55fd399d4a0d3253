// The annual rate of a suite in several ways, its bounds, what the levels leave open, and what each record contributes.

#include <cmath>
#include <numeric>

#include <gmock/gmock.h>

#include "rocking/stats/fit_suite.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/suite_bootstrap.hpp"
#include "rocking/studies/curves/shares_and_hazard.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "support/made_up_suite.hpp"

namespace rocking {
namespace {

using namespace support::six_records;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(SuiteRate, IsGivenByTheLawAndByShares) {
  const SuiteRate rate = annual_rate(whole_curve(), hazard());
  ASSERT_EQ(whole_curve().outcome, stats::FragilityOutcome::fitted);
  EXPECT_EQ(rate.chosen.source, RateSource::law);
  const stats::SuiteLaw law = whole_curve().pooled->law();
  const double by_law = midpoint_rate([&](double x) { return law.probability(x); });
  EXPECT_NEAR(estimate(rate, RateSource::law), by_law, 1e-6 * by_law);
  EXPECT_NEAR(rate.chosen.value, by_law, 1e-6 * by_law);
  const std::vector<double> shares = shares_of();
  // The means rise, so that the isotonic ones are the same.
  const double by_shares = midpoint_rate([&](double x) { return interpolated(shares, x); });
  EXPECT_NEAR(estimate(rate, RateSource::isotonic), by_shares, 1e-6 * by_shares);
  EXPECT_EQ(rate.estimates.size(), 2U);
  for (const RateEstimate& each : rate.estimates) {
    ASSERT_TRUE(each.interval);
    EXPECT_LT(each.interval->low, each.value);
    EXPECT_GT(each.interval->high, each.value);
  }
  EXPECT_NEAR(*rate.disagreement, std::max(by_law, by_shares) / std::min(by_law, by_shares) - 1.0, 1e-5);
}

TEST(SuiteRate, OfAHazardCurveThatEndsBelowUpliftIsNotSaidToBeThatOfTheLevels) {
  const CurveSubject subject{.parameter = "/excitation/pga_g", .others = {}, .event = {}, .least_uplift = 0.219};
  AnnualRate rate;
  rate.interval = stats::Interval{.low = 0.0, .high = 0.0};
  rate.hazard_ends = 0.215;
  EXPECT_THAT(rate_sentence(subject, rate),
              AllOf(HasSubstr("does not overturn by this hazard curve, whose rate is 0 from"), HasSubstr("0.215 g on"),
                    HasSubstr("below the least that lifts the block"), Not(HasSubstr("at these levels"))));
  rate.hazard_ends.reset();
  EXPECT_THAT(rate_sentence(subject, rate), HasSubstr("did not overturn at these levels"));
}

TEST(SuiteRate, ThatIsTooFrequentToBeBelievedNeedsALook) {
  HazardCurve often = hazard();
  EXPECT_THAT(hazard_doubts(annual_rate(whole_curve(), often).chosen), IsEmpty());
  for (HazardPoint& point : often.points) point.rate *= 1e4;
  const AnnualRate rate = annual_rate(whole_curve(), often).chosen;
  EXPECT_EQ(rate.frequent_hazard, often.points.front().rate);
  EXPECT_THAT(annual_rate_warnings(rate), AllOf(HasSubstr("warning: the hazard curve states"),
                                                HasSubstr("times a year, as of no object that stands")));
  const Json written = type_of<AnnualRate>().json(&rate);
  ASSERT_EQ(written.at("warnings").size(), hazard_warnings(rate).size());
  EXPECT_THAT(written["warnings"][0].get<std::string>(), HasSubstr("the hazard curve states"));
}

// Below the levels the probability is their first share at most, where the law does not give more, and above them 1.
TEST(SuiteRate, IsAtMostWhatItsLevelsAllow) {
  const SuiteRate rate = annual_rate(whole_curve(), hazard());
  const stats::SuiteLaw law = whole_curve().pooled->law();
  const double first = std::max(midpoint_rate([&](double x) { return x < intensities[1] ? law.probability(x) : 0.0; }),
                                shares_of()[1] * (hazard_at(uplift) - hazard_at(intensities[1])));
  const double expected = first + hazard_at(intensities.back()) + midpoint_rate([&](double x) {
                            return x < intensities[1] || x > intensities.back() ? 0.0 : law.probability(x);
                          });
  EXPECT_NEAR(rate.at_most, expected, 1e-4 * expected);
  EXPECT_GT(rate.at_most, rate.chosen.value);
  SuiteCurve rejected = whole_curve();
  rejected.outcome = stats::FragilityOutcome::rejected;
  const SuiteRate by_shares = annual_rate(rejected, hazard());
  EXPECT_GE(by_shares.at_most, by_shares.chosen.value + (1.0 - shares_of().back()) * hazard_at(intensities.back()));
  EXPECT_GT(by_shares.chosen.interval->high, by_shares.at_most) << "the isotonic rate has an interval that holds it";
}

// What lies outside the levels is one number beside the interval: where the hazard reaches lower, the interval of the law
// grows as its rate does, and only `at_most` takes in what may happen below the levels.
TEST(SuiteRate, ByTheLawHasTheIntervalOfTheLaw) {
  StripeGroup high = group_of(outcomes);
  std::erase_if(high.stripes, [](const Stripe& stripe) { return stripe.intensity < 0.4; });
  for (Stripe& stripe : high.stripes) stripe.uplift.reset();
  const SuiteCurve curve = suite_curve(high, {}, 1);
  ASSERT_EQ(curve.outcome, stats::FragilityOutcome::fitted);
  const HazardCurve low_hazard{
      .name = "", .intensity = "", .header_line = 0, .points = {{0.001, hazard_at(0.001)}, {3.0, hazard_at(3.0)}}};
  const SuiteRate rate = annual_rate(curve, low_hazard);
  ASSERT_EQ(rate.chosen.source, RateSource::law);
  std::vector<double> of_samples;
  const auto pieces = pieces_between(low_hazard, 0.001);
  for (const stats::SuiteLaw& law : curve.bootstrap.laws)
    of_samples.push_back(rate_of(LognormalCapacity{std::log(law.median), law.dispersion()}, pieces));
  const stats::Interval interval = curve.interval_of(of_samples).value();
  EXPECT_DOUBLE_EQ(rate.chosen.interval->low, interval.low);
  EXPECT_DOUBLE_EQ(rate.chosen.interval->high, interval.high);
  EXPECT_GT(rate.at_most, 10.0 * interval.high);
}

TEST(SuiteRate, IsToldInOneSentenceWithItsIntervalAndWhatIsOpen) {
  SuiteRate rate = annual_rate(whole_curve(), hazard());
  rate.chosen.value = 5.2e-4;
  rate.chosen.interval = stats::Interval{.low = 3.1e-4, .high = 8.8e-4};
  rate.at_most = 9.1e-4;
  rate.undecided_share = 0.123;
  rate.add_levels = {0.21, 0.34};
  const CurveSubject& subject = whole_curve().subject;
  EXPECT_EQ(rate_sentence(subject, rate),
            "The block overturns about once in 1900 years: mean annual rate 5.2e-4 [3.1e-4, 8.8e-4] (95 %); what the "
            "levels leave open, 12.3 % of the rate, raises it to at most 9.1e-4: add 0.21,0.34");
  rate.undecided_share = 0.02;
  EXPECT_THAT(rate_sentence(subject, rate), ::testing::EndsWith("2.0 % of the rate, raises it to at most 9.1e-4"));
}

TEST(SuiteRate, IsSharedOutAmongTheRecords) {
  const SuiteRate rate = annual_rate(whole_curve(), hazard());
  ASSERT_EQ(rate.by_record.size(), outcomes.size());
  double sum = 0.0, shares = 0.0;
  for (std::size_t r = 0; r < outcomes.size(); ++r) {
    const std::vector<double> own = shares_of(r);
    const double expected = midpoint_rate([&](double x) { return interpolated(own, x); });
    EXPECT_NEAR(rate.by_record[r].rate, expected, 1e-6 * expected) << r;
    sum += rate.by_record[r].rate;
    shares += rate.by_record[r].share;
  }
  EXPECT_NEAR(sum / 6.0, estimate(rate, RateSource::isotonic), 1e-12 * sum) << "the means rise";
  EXPECT_NEAR(shares, 1.0, 1e-12);
}

TEST(SuiteRate, OfARejectedLawIsThatOfTheIsotonicShares) {
  SuiteCurve rejected = whole_curve();
  rejected.outcome = stats::FragilityOutcome::rejected;
  const SuiteRate rate = annual_rate(rejected, hazard());
  EXPECT_EQ(rate.chosen.source, RateSource::isotonic);
  EXPECT_NEAR(rate.chosen.value, estimate(rate, RateSource::isotonic), 1e-12 * rate.chosen.value);
  const double sum = std::accumulate(rate.chosen.by_level.begin(), rate.chosen.by_level.end(), 0.0,
                                     [](double part, const RateInRange& range) { return part + range.rate; });
  EXPECT_NEAR(sum, rate.chosen.value, 1e-12 * sum);
}

TEST(SuiteRate, OfBlocksThatNeverOverturnHasAnUpperBound) {
  const SuiteCurve calm = suite_curve(group_of(std::vector<std::vector<int>>(3, {0, 0, 0, 0, 0})), {}, 1);
  const SuiteRate rate = annual_rate(calm, hazard());
  EXPECT_EQ(rate.chosen.value, 0.0);
  EXPECT_NEAR(rate.at_most, hazard_at(0.9), 1e-12);
  EXPECT_EQ(rate.disagreement, 0.0);
  EXPECT_EQ(rate.undecided_share, 1.0);
  EXPECT_FALSE(rate.add_levels.empty());
  // 0 of 3 records are at most 1 - 0.025^(1/3) by Clopper and Pearson; by 499 samples. At 0.4 the unseen record does what
  // all do at 0.6, at 0.6 what is not known.
  const double most = 1.0 - std::cbrt(0.025);
  const double expected = hazard_at(0.9) + most * (hazard_at(0.4) - hazard_at(0.9));
  ASSERT_TRUE(rate.chosen.interval);
  EXPECT_EQ(rate.chosen.interval->low, 0.0);
  EXPECT_NEAR(rate.chosen.interval->high, expected, 0.05 * expected);
}

// The true rate lies within what the levels allow, and the interval contains that: it is not narrower with fewer levels.
TEST(SuiteRate, ByIsotonicSharesContainsItsBounds) {
  const SuiteRate rate = annual_rate(whole_curve(), hazard());
  const std::vector<double> shares = shares_of();
  const double at_least = midpoint_rate([&](double x) {
    std::size_t k = 0;
    while (k + 1 < intensities.size() && intensities[k + 1] <= x) ++k;
    return x < intensities[1] ? 0.0 : shares[k];
  });
  const double at_most = midpoint_rate([&](double x) {
    std::size_t k = 0;
    while (k < intensities.size() && intensities[k] < x) ++k;
    return k == intensities.size() ? 1.0 : shares[k];
  });
  EXPECT_LT(rate.estimates.back().interval->low, at_least);
  EXPECT_GT(rate.estimates.back().interval->high, at_most);
}

// No record overturned where the hazard is, but the law gives a probability there.
TEST(SuiteRate, ByTheLawDisagreesWithoutANumberWhereThatBySharesIsZero) {
  const SuiteCurve late = suite_curve(
      group_of(
          {{0, 0, 2, 7, 10}, {0, 0, 6, 10, 10}, {0, 0, 9, 6, 9}, {0, 0, 0, 3, 8}, {0, 0, 3, 8, 10}, {0, 0, 5, 9, 10}}),
      {}, 1);
  ASSERT_TRUE(late.pooled);
  const HazardCurve weak{
      .name = "", .intensity = "", .header_line = 0, .points = {{0.25, 1e-2}, {0.27, 5e-3}, {0.29, 0.0}}};
  const SuiteRate rate = annual_rate(late, weak);
  EXPECT_GT(estimate(rate, RateSource::law), 0.0);
  EXPECT_EQ(estimate(rate, RateSource::isotonic), 0.0);
  EXPECT_FALSE(rate.disagreement);
  EXPECT_THAT(annual_rate_warnings(rate), HasSubstr("one is 0 and the other is not"));
}

TEST(Undecided, OfRangesOutsideTheLevelsIsTheirBounds) {
  const std::vector<LevelShare> levels{{0.3, 0.1, 1e-3}, {0.6, 0.8, 1e-3}};
  const auto ranges = undecided_ranges(levels, hazard(), uplift);
  ASSERT_EQ(ranges.size(), 3U);
  EXPECT_NEAR(ranges[0].rate, 0.1 * (hazard_at(uplift) - hazard_at(0.3)), 1e-12);
  EXPECT_NEAR(ranges[2].rate, 0.2 * hazard_at(0.6), 1e-12);
  EXPECT_GT(ranges[1].rate, 0.0);
  EXPECT_LT(ranges[1].rate, 0.7 * (hazard_at(0.3) - hazard_at(0.6)));
}

// Levels on a lognormal curve are added until less than the goal is open, and then none.
TEST(Undecided, IsSettledByTheLevelsThatAreAdded) {
  const auto probability = [](double x) { return 0.5 * std::erfc(-std::log(x / 0.45) / 0.4 / std::sqrt(2.0)); };
  std::vector<LevelShare> levels;
  for (const double x : {0.25, 0.6}) levels.push_back({x, probability(x), 1e-3});
  const auto open = [&] {
    double sum = 0.0;
    for (const UndecidedRange& range : undecided_ranges(levels, hazard(), uplift)) sum += range.rate;
    return sum;
  };
  constexpr double goal = 2e-5;
  ASSERT_GT(open(), goal);
  const std::vector<double> added = levels_to_add(levels, hazard(), uplift, goal, probability);
  EXPECT_THAT(added, Each(::testing::Gt(uplift)));
  for (const double x : added) levels.push_back({x, probability(x), 1e-3});
  std::ranges::sort(levels, {}, &LevelShare::intensity);
  EXPECT_LE(open(), goal);
  EXPECT_THAT(levels_to_add(levels, hazard(), uplift, goal, probability), IsEmpty());
}

TEST(Undecided, SuggestsNumbersWithFewDigitsInsideARange) {
  EXPECT_EQ(inside(0.25, 0.3), 0.27);
  EXPECT_EQ(inside(0.8, std::nullopt), 1.0);
  EXPECT_EQ(inside(0.2501, 0.2509), 0.2505);
}

/// The hazard without what is weaker than an intensity.
HazardCurve without_below(double intensity) {
  HazardCurve cut = hazard();
  std::erase_if(cut.points, [&](const HazardPoint& point) { return point.intensity <= intensity; });
  cut.points.insert(cut.points.begin(), {intensity, hazard_at(intensity)});
  if (cut.points.size() == 1) cut.points.push_back({2.0 * intensity, hazard_at(2.0 * intensity)});
  return cut;
}

std::vector<double> rates_with(const SuiteCurve& suite, const HazardCurve& hazard) {
  const SuiteRate rate = annual_rate(suite, hazard);
  std::vector<double> rates{rate.chosen.value};
  for (const RateEstimate& each : rate.estimates) rates.push_back(each.value);
  return rates;
}

// Around the least uplift, where the shares begin at 0 whether the hazard begins above or below, and at random places.
TEST(SuiteRate, DoesNotRiseWhereHazardIsTakenAway) {
  SuiteCurve isotonic = whole_curve();
  isotonic.outcome = stats::FragilityOutcome::rejected;
  SuiteCurve anywhere = whole_curve();
  anywhere.subject.least_uplift.reset();
  std::vector<double> cuts{0.1001, uplift * (1.0 - 1e-3), uplift, uplift * (1.0 + 1e-3), 0.25, 0.3, 0.95, 3.0};
  std::uint64_t state = 63;
  for (int i = 0; i < 30; ++i) {
    state = 6364136223846793005ULL * state + 1442695040888963407ULL;
    cuts.push_back(0.1 * std::exp(3.0 * static_cast<double>(state >> 11) * 0x1p-53));
  }
  std::ranges::sort(cuts);
  for (const SuiteCurve& suite : {whole_curve(), isotonic, anywhere, with_rare(unlike)}) {
    std::vector<double> before = rates_with(suite, hazard());
    for (const double cut : cuts) {
      const std::vector<double> after = rates_with(suite, without_below(cut));
      for (std::size_t k = 0; k < after.size(); ++k) EXPECT_LE(after[k], before[k] * (1.0 + 1e-12)) << cut << ' ' << k;
      before = after;
    }
  }
  // Just above the least uplift hardly anything is taken away.
  const auto below = rates_with(isotonic, without_below(uplift * (1.0 - 1e-6)));
  const auto above = rates_with(isotonic, without_below(uplift * (1.0 + 1e-6)));
  for (std::size_t k = 0; k < above.size(); ++k) EXPECT_NEAR(above[k], below[k], 1e-4 * below[k]) << k;
}

/// `count` of ten records overturn in all of their trials at each level, the others in none.
StripeGroup group_of_records(const std::vector<std::size_t>& counts) {
  std::vector<std::vector<int>> all(10, std::vector<int>(intensities.size(), 0));
  for (std::size_t k = 0; k < counts.size(); ++k) {
    for (std::size_t r = 0; r < counts[k]; ++r) all[r][k] = 10;
  }
  return group_of(all);
}

// Records are the units of sampling: 0 of 10 is [0, 30.8 %], as 10 of 10 is [69.2 %, 1].
TEST(SuiteLevels, HaveTheExactIntervalOfTheirRecordsWhereTheseAreAllAlike) {
  const SuiteCurve found = suite_curve(group_of_records({0, 0, 10, 10, 10}), {}, 1);
  const stats::Interval none = found.levels[1].isotonic_band, all = found.levels[3].isotonic_band;
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 0.30850, 1e-5);
  EXPECT_NEAR(all.low, 0.69150, 1e-5);
  EXPECT_EQ(all.high, 1.0);
}

// Each record stands at all levels but the last, and the hazard ends where twice the intensity is among those: the unseen
// record may overturn nevertheless.
TEST(SuiteRate, IsNotKnownToBeZeroWhereRecordsAreAllAlike) {
  const HazardCurve weak{
      .name = "", .intensity = "", .header_line = 0, .points = {{0.25, 1e-2}, {0.27, 5e-3}, {0.29, 0.0}}};
  const SuiteCurve found = suite_curve(group_of_records({0, 0, 0, 0, 10}), {}, 1);
  std::vector<double> unseen;
  for (const std::vector<double>& shares : found.bootstrap.with_unseen) unseen.push_back(shares.back());
  const double most = stats::percentile_interval(unseen, unseen.size(), 0.95)->high;
  EXPECT_NEAR(most, 1.0 - std::pow(0.025, 0.1), 0.08);  // Clopper-Pearson's of 0 of 10, by 499 samples: 4 errors
  const SuiteRate rate = annual_rate(found, weak);
  const RateEstimate& by_shares = rate.estimates.back();
  EXPECT_EQ(by_shares.value, 0.0);
  ASSERT_TRUE(by_shares.interval);
  EXPECT_EQ(by_shares.interval->low, 0.0);
  EXPECT_NEAR(by_shares.interval->high, 1e-2 * most, 1e-14);
}

// Of each record one more trial may have overturned at 0.6.
TEST(SuiteRate, CoversBothOutcomesOfRealisationsWithoutAnAnswer) {
  StripeGroup group = group_of(outcomes), more = group;
  for (Stripe& stripe : group.stripes) {
    if (stripe.intensity != 0.6) continue;
    stripe.without_answer.assign(10, false);
    for (std::size_t j = 9; j < 10 && !stripe.overturned[j]; ++j) stripe.without_answer[j] = true;
  }
  for (Stripe& stripe : more.stripes) {
    if (stripe.intensity == 0.6) stripe.overturned[9] = true;
  }
  const SuiteCurve found = suite_curve(group, {}, 1);
  EXPECT_EQ(found.outcome, stats::FragilityOutcome::unresolved);
  EXPECT_FALSE(found.pooled);
  EXPECT_EQ(found.levels[3].unresolved, 5U);
  const SuiteRate open = annual_rate(found, hazard());
  const SuiteRate least = annual_rate(whole_curve(), hazard());
  const SuiteRate most = annual_rate(suite_curve(more, {}, 1), hazard());
  EXPECT_EQ(open.chosen.source, RateSource::isotonic);
  const auto interval_of = [](const SuiteRate& rate) { return rate.estimates.back().interval.value(); };
  EXPECT_EQ(open.chosen.interval->low, interval_of(least).low);
  EXPECT_EQ(open.chosen.interval->high, interval_of(most).high);
  EXPECT_GT(open.chosen.interval->high, interval_of(least).high);
  EXPECT_GT(open.at_most, annual_rate(whole_curve(), hazard(), RateSource::isotonic).at_most);
  EXPECT_GT(open.undecided_share, least.undecided_share);
}

// Levels that end at a share of a half: above them it lies between that and 1, whatever the law says.
TEST(SuiteRate, HasAnIntervalThatHoldsWhatTheLevelsLeaveUndecided) {
  StripeGroup low = group_of(outcomes);
  std::erase_if(low.stripes, [](const Stripe& stripe) { return stripe.intensity > 0.5; });
  const SuiteCurve few = suite_curve(low, {}, 1);
  ASSERT_EQ(few.outcome, stats::FragilityOutcome::fitted);
  const SuiteRate part = annual_rate(few, hazard());
  const SuiteRate whole = annual_rate(whole_curve(), hazard());
  EXPECT_FALSE(part.is_decided());
  const double above = hazard_at(0.4);
  double share = 0.0;
  for (const double each : {2.0, 6.0, 9.0, 0.0, 3.0, 5.0}) share += each / 60.0;
  EXPECT_GT(part.estimates.back().interval->high, above) << "1 above the last level is possible";
  EXPECT_LT(part.estimates.back().interval->low, share * above + 1e-6);
  EXPECT_GT(part.at_most, above);
  EXPECT_GE(whole.chosen.value, part.chosen.interval->low);
  EXPECT_LE(whole.chosen.value, part.chosen.interval->high);
}

}  // namespace
}  // namespace rocking
