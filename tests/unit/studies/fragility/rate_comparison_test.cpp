// The rates of two options compared, sample by sample of their bootstraps.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/studies/fragility/fragility.hpp"
#include "support/made_up_suite.hpp"

namespace rocking {
namespace {

using namespace support::six_records;

// The second option stands again at stronger shaking: its law is rejected, and both rates are those of the shares.
TEST(RateComparison, HasTheBasisOfTheRates) {
  SuiteCurve other = suite_curve(
      group_of(
          {{0, 0, 1, 5, 10}, {0, 1, 3, 8, 10}, {0, 2, 6, 4, 7}, {0, 0, 0, 2, 6}, {0, 1, 2, 6, 9}, {0, 0, 3, 7, 10}}),
      {}, 1);
  ASSERT_EQ(other.outcome, stats::FragilityOutcome::fitted);
  const auto ratio = [&](RateSource source) {
    return annual_rate(other, hazard(), source).chosen.value /
           annual_rate(whole_curve(), hazard(), source).chosen.value;
  };
  const RateComparison by_law = compared_rates(whole_curve(), other, hazard());
  EXPECT_EQ(by_law.source, RateSource::law);
  EXPECT_NEAR(*by_law.ratio, ratio(RateSource::law), 1e-12);
  EXPECT_LT(by_law.ratio_interval->low, *by_law.ratio);
  EXPECT_GT(by_law.ratio_interval->high, *by_law.ratio);
  other.outcome = stats::FragilityOutcome::rejected;
  const RateComparison by_shares = compared_rates(whole_curve(), other, hazard());
  EXPECT_EQ(by_shares.source, RateSource::isotonic);
  EXPECT_NEAR(*by_shares.ratio, ratio(RateSource::isotonic), 1e-12);
}

// An option that never overturned is not known to have the rate 0.
TEST(RateComparison, IsNotCertainOfAnOptionThatNeverOverturned) {
  const SuiteCurve calm =
      suite_curve(group_of(std::vector(outcomes.size(), std::vector<int>(intensities.size(), 0))), {}, 1);
  const RateComparison found = compared_rates(whole_curve(), calm, hazard());
  EXPECT_EQ(*found.ratio, 0.0);
  EXPECT_EQ(found.ratio_interval->low, 0.0);
  EXPECT_GT(found.ratio_interval->high, 0.4) << "0 of 6 records: up to 54 % at each level";
}

// Which option is the base is a convention. Between the levels the curve linear in ln x decides in one order, the
// lognormal one in the other.
TEST(RateComparison, IsTheOppositeTheOtherWayRound) {
  SuiteCurve base = whole_curve(), option = suite_curve(group_of({{0, 0, 1, 9, 9},
                                                                  {0, 1, 1, 9, 10},
                                                                  {0, 1, 1, 8, 9},
                                                                  {0, 0, 1, 9, 10},
                                                                  {0, 1, 1, 10, 10},
                                                                  {0, 0, 0, 9, 10}}),
                                                        {}, 1);
  base.outcome = option.outcome = stats::FragilityOutcome::rejected;
  const RateComparison there = compared_rates(base, option, hazard()), back = compared_rates(option, base, hazard());
  const double size = there.interval->high - there.interval->low;
  EXPECT_NEAR(there.interval->low, -back.interval->high, 1e-9 * size);
  EXPECT_NEAR(there.interval->high, -back.interval->low, 1e-9 * size);
  // Between two samples ends are interpolated.
  EXPECT_NEAR(there.ratio_interval->low * back.ratio_interval->high, 1.0, 1e-2);
  EXPECT_NEAR(there.ratio_interval->high * back.ratio_interval->low, 1.0, 1e-2);
}

// The hazard is where one record of the base alone overturned: samples without it have the rate 0, and say nothing of how
// many times as often the option overturns.
TEST(RateComparison, HasNoLeastRatioWhereTheBaseMayNeverOverturn) {
  const auto suite = [](int of_second) {
    SuiteCurve found = suite_curve(group_of({{0, 5, 5, 7, 10},
                                             {0, of_second, of_second, 8, 10},
                                             {0, 0, 0, 6, 9},
                                             {0, 0, 0, 3, 8},
                                             {0, 0, 0, 8, 10},
                                             {0, 0, 0, 9, 10}}),
                                   {}, 1);
    found.outcome = stats::FragilityOutcome::rejected;
    return found;
  };
  const HazardCurve weak{
      .name = "", .intensity = "", .header_line = 0, .points = {{0.25, 1e-2}, {0.35, 5e-3}, {0.39, 0.0}}};
  const RateComparison found = compared_rates(suite(0), suite(5), weak);
  EXPECT_GT(*found.ratio, 1.0);
  EXPECT_EQ(found.ratio_interval->low, 0.0);
  EXPECT_TRUE(std::isinf(found.ratio_interval->high));
}

}  // namespace
}  // namespace rocking
