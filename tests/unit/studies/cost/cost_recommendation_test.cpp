// Recommended tolerances and numbers of realisations from measured costs, and their wording.

#include "rocking/studies/cost/cost.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/ensemble/mode_family.hpp"
#include "rocking/studies/cost/measurement.hpp"
#include "rocking/studies/cost/study.hpp"
#include "rocking/text/json.hpp"
#include "support/json_schema.hpp"
#include "support/made_up_cost.hpp"

namespace rocking {
namespace {

using support::curve_of;
using support::experiment_of;
using support::one;
using support::realisation;
using support::three;
using ::testing::HasSubstr;
using ::testing::Not;

Recommendation recommended(const std::vector<ToleranceCost>& curve, double half_width = 0.04) {
  return recommend(curve, {.half_width = half_width}, 0.95);
}

// A twentieth of 0.04 is 0.002: the upper end is 0.00184 for 0 of 2000 and 0.0037 for 0 of 1000.
TEST(Recommendation, IsTheCoarsestToleranceOfWhichItIsShownThatItDoesNotMatter) {
  const auto found = recommended(curve_of({30, 0, 0, 0}, 2000));
  EXPECT_EQ(found.assurance, Assurance::shown);
  EXPECT_EQ(found.place, 1U);
  EXPECT_EQ(found.coarsest, 1U);
  EXPECT_DOUBLE_EQ(found.bearable, 0.002);
  EXPECT_LE(found.at_most, 0.002);
  EXPECT_FALSE(found.sample_needed.has_value());
}

TEST(Recommendation, IsNotPassedByATighterToleranceThatFails) {
  EXPECT_EQ(recommended(curve_of({0, 30, 0, 0}, 2000)).place, 2U);
}

TEST(Recommendation, WantsAnErrorFarBelowWhereMotionsPart) {
  auto curve = curve_of({0, 0, 0, 0}, 2000);
  curve[0].departure->median_error = 1.01e-4;
  EXPECT_EQ(recommended(curve).place, 1U);
  curve[0].departure->median_error = 1e-4;
  EXPECT_EQ(recommended(curve).place, 0U);
  curve[0].departure->median_error.reset();
  EXPECT_EQ(recommended(curve).place, 0U) << "nothing moved";
}

TEST(Recommendation, SaysWhatWouldShowWhatTooFewDoNot) {
  const auto found = recommended(curve_of({9, 0, 0, 0}, 1000));
  EXPECT_EQ(found.assurance, Assurance::not_told_apart);
  EXPECT_EQ(found.place, 1U);
  EXPECT_DOUBLE_EQ(found.at_most, stats::clopper_pearson({0, 1000}, 0.95).high);
  ASSERT_TRUE(found.sample_needed.has_value());
  EXPECT_LE(stats::clopper_pearson({0, *found.sample_needed}, 0.95).high, 0.002);
  EXPECT_GT(stats::clopper_pearson({0, *found.sample_needed - 1}, 0.95).high, 0.002);
}

// 1 of 1000 and 2 of 1000: shares of 0.001 and 0.002.
TEST(Recommendation, KnowsThatNoSampleShowsWhatIsNotSo) {
  const auto some = recommended(curve_of({9, 1, 1, 1}, 1000));
  EXPECT_EQ(some.assurance, Assurance::not_told_apart);
  ASSERT_TRUE(some.sample_needed.has_value());
  const std::uint64_t n = *some.sample_needed;
  EXPECT_LE(stats::clopper_pearson({(n + 999) / 1000, n}, 0.95).high, 0.002);
  EXPECT_GT(stats::clopper_pearson({(n + 999) / 1000, n * 9 / 10}, 0.95).high, 0.002);
  EXPECT_FALSE(recommended(curve_of({9, 2, 2, 2}, 1000)).sample_needed.has_value());
}

TEST(Recommendation, IsNoneWhereNotEvenTheHalfWidthIsReached) {
  const auto found = recommended(curve_of({0, 0, 0, 0}, 50));
  EXPECT_EQ(found.assurance, Assurance::none);
  EXPECT_FALSE(found.place.has_value());
  EXPECT_FALSE(found.coarsest.has_value());
  EXPECT_TRUE(found.sample_needed.has_value());
}

// If 40 of 2000 already flip at the floor, flips are caused by rounding, and 1e-8 adds none.
TEST(Recommendation, AttributesNoFlipOfRoundingToATolerance) {
  auto curve = curve_of({90, 40, 40, 40}, 200'000);
  EXPECT_EQ(recommended(curve, 0.004).assurance, Assurance::shown) << "few beside 0.0002";
  curve = curve_of({4000, 1000, 1000, 1000}, 200'000);
  const auto found = recommended(curve, 0.004);
  EXPECT_EQ(found.assurance, Assurance::shown);
  EXPECT_EQ(found.coarsest, 1U);
  EXPECT_LT(found.at_most, 0.0002);
}

TEST(Recommendation, TakesATighterToleranceThatIsAllButFree) {
  const auto found = recommended(curve_of({30, 0, 0, 0}, 2000, {1000, 1000, 1050, 1101, 2000}));
  EXPECT_EQ(found.coarsest, 1U);
  EXPECT_EQ(found.place, 2U);
  EXPECT_EQ(recommended(curve_of({30, 0, 0, 0}, 2000, {1000, 1000, 1050, 1100, 2000})).place, 3U);
}

TEST(Recommendation, OfEverythingThatThereIsNeedsNoInterval) {
  const Yardstick everything{.half_width = {}, .is_everything = true};
  const auto kept = recommend(curve_of({1, 0, 0, 0}, 91), everything, 0.95);
  EXPECT_EQ(kept.assurance, Assurance::shown);
  EXPECT_EQ(kept.place, 1U);
  EXPECT_EQ(kept.at_most, 0.0);
  EXPECT_EQ(recommend(curve_of({2, 1, 1, 1}, 91), everything, 0.95).place, 1U) << "rounding changes one anyway";
  EXPECT_EQ(recommend(curve_of({9, 8, 7, 1}, 91), everything, 0.95).assurance, Assurance::none);
  EXPECT_EQ(recommend(curve_of({0, 0, 0, 0}, 90), {}, 0.95).assurance, Assurance::none) << "one is missing";
}

/// 40 of condition 0 in two modes, half each; 10 of condition 2 in one mode; one deterministic one.
std::vector<MeasuredRealisation> two_conditions() {
  std::vector<MeasuredRealisation> measured{realisation({one, one, three}, 0.0, 1)};
  for (int i = 0; i < 40; ++i) measured.push_back(realisation({one, one, i % 2 == 0 ? one : three}, 0.0, 0));
  for (int i = 0; i < 10; ++i) measured.push_back(realisation({three, three, one}, 0.0, 2));
  return measured;
}

TEST(HalfWidthForecast, IsWhatTheIntervalsWillBeIfModesKeepTheirShares) {
  const auto measured = two_conditions();
  const Experiment experiment = experiment_of({true, false, true});
  const HalfWidthForecast forecast(experiment, measured);
  const auto half = [](std::uint64_t k, std::uint64_t n) {
    const auto interval = stats::exact_interval({k, n}, mode_family(0.95).of_prespecified());
    return 0.5 * (interval.high - interval.low);
  };
  const HalfWidths now = forecast.at(1);
  EXPECT_DOUBLE_EQ(now.widest, half(100, 200));
  EXPECT_DOUBLE_EQ(now.mean, 0.5 * (half(100, 200) + half(200, 200)));
  EXPECT_DOUBLE_EQ(now.widest_wilson,
                   0.5 * (stats::wilson({100, 200}, 0.95).high - stats::wilson({100, 200}, 0.95).low));
  EXPECT_DOUBLE_EQ(forecast.at(4).widest, half(400, 800));
  EXPECT_DOUBLE_EQ(forecast.aim().value(), now.mean);
}

// Condition 2 needs a higher confidence than condition 0, but its shares are those of one mode.
TEST(HalfWidthForecast, TakesEachConditionAtItsOwnConfidence) {
  const auto measured = two_conditions();
  Experiment experiment = experiment_of({true, false, true});
  experiment.conditions[0].confidence = 0.8;
  experiment.conditions[2].confidence = 0.999;
  const HalfWidthForecast forecast(experiment, measured);
  const auto half = [](const stats::Interval& interval) { return 0.5 * (interval.high - interval.low); };
  const double first = half(simultaneous_interval(one, {100, 200}, 0.8));
  const double third = half(simultaneous_interval(one, {200, 200}, 0.999));
  const HalfWidths widths = forecast.at(1);
  EXPECT_DOUBLE_EQ(widths.mean, 0.5 * (first + third));
  EXPECT_DOUBLE_EQ(widths.widest, first);
  EXPECT_DOUBLE_EQ(widths.widest_wilson, half(stats::wilson({100, 200}, 0.8)));
  EXPECT_DOUBLE_EQ(forecast.aim().value(), widths.mean);
  const RealisationsNeeded needed = forecast.needed(0.02);
  EXPECT_GT(half(simultaneous_interval(one, {needed.by_shares / 2 - 1, needed.by_shares - 2}, 0.8)), 0.02);
  EXPECT_LE(half(simultaneous_interval(one, {needed.by_shares / 2 + 1, needed.by_shares + 2}, 0.8)), 0.02);
  const auto highest = mode_family(0.999).of_others();
  EXPECT_GT(half(stats::exact_interval({needed.at_most / 2 - 1, needed.at_most - 2}, highest)), 0.02);
  EXPECT_LE(half(stats::exact_interval({needed.at_most / 2 + 1, needed.at_most + 2}, highest)), 0.02);
}

TEST(Cost, StatesTheEffectOfAToleranceAtTheHighestConfidence) {
  Experiment experiment = experiment_of({true, false, true});
  experiment.conditions[2].confidence = 0.999;
  const auto measured = two_conditions();
  const CostTiming times{.seconds_per_period = {1e-6, 2e-6, 4e-6}, .realisations = 1, .periods = 1};
  const Cost cost = cost_of(experiment, std::vector{1e-4, 1e-8, 1e-10}, measured, times);
  EXPECT_EQ(cost.confidence, 0.999);
  const Departure& departure = *cost.curve[0].departure;
  EXPECT_DOUBLE_EQ(departure.flips_interval.high, stats::clopper_pearson(departure.flips, 0.999).high);
  EXPECT_EQ(cost.speed(0), 4.0);
  EXPECT_THAT(cost_table({.experiment = &experiment, .cost = cost, .system = {}}), HasSubstr("exact 99.9 % interval"));
}

TEST(HalfWidthForecast, AimsAtTheHalfWidthThatTheExperimentNames) {
  auto experiment = experiment_of({true, false, true});
  for (Condition& condition : experiment.conditions) condition.until = Until{.half_width = 0.02};
  const auto measured = two_conditions();
  EXPECT_DOUBLE_EQ(HalfWidthForecast(experiment, measured).aim().value(), 0.02);
}

TEST(HalfWidthForecast, TakesARelativeHalfWidthOfTheShareOfItsMode) {
  auto experiment = experiment_of({true, false, true});
  const auto measured = two_conditions();
  const double without = HalfWidthForecast(experiment, measured).aim().value();
  for (Condition& condition : experiment.conditions) {
    condition.until = Until{.relative_half_width = 0.1, .mode = one};
  }
  const double mean_share = HalfWidthForecast(experiment, measured).aim().value() / 0.1;
  EXPECT_GT(mean_share, 0.0);
  EXPECT_LE(mean_share, 1.0);
  for (Condition& condition : experiment.conditions) condition.until->mode = section::periodic(7, 9);
  EXPECT_DOUBLE_EQ(HalfWidthForecast(experiment, measured).aim().value(), without) << "it did not occur";
}

TEST(HalfWidthForecast, KnowsHowManyRealisationsAreNeeded) {
  const auto measured = two_conditions();
  const Experiment experiment = experiment_of({true, false, true});
  const HalfWidthForecast forecast(experiment, measured);
  for (const double half_width : {0.05, 0.01}) {
    const RealisationsNeeded needed = forecast.needed(half_width);
    const auto reached = [&](std::uint64_t n) {
      const auto interval = stats::exact_interval({n / 2, n}, mode_family(0.95).of_prespecified());
      return 0.5 * (interval.high - interval.low) <= half_width;
    };
    EXPECT_TRUE(reached(needed.by_shares + 2)) << half_width;
    EXPECT_FALSE(reached(needed.by_shares - 2)) << half_width;
    EXPECT_GT(needed.at_most, needed.by_shares);
    EXPECT_LT(static_cast<double>(needed.at_most), 1.3 * static_cast<double>(needed.by_shares));
  }
}

TEST(HalfWidthForecast, IsEmptyWhereNothingIsDrawn) {
  const std::vector<MeasuredRealisation> measured{realisation({one, one, one})};
  const Experiment experiment = experiment_of({false});
  const HalfWidthForecast forecast(experiment, measured);
  EXPECT_TRUE(forecast.is_empty());
  EXPECT_FALSE(forecast.aim().has_value());
}

TEST(ToleranceLadder, HasEveryDecadeAndTheExperimentsOwnOnce) {
  Experiment experiment = experiment_of({true});
  EXPECT_EQ(tolerance_ladder(experiment).size(), 11U);
  experiment.conditions[0].tolerance = 3e-9;
  const auto with_own = tolerance_ladder(experiment);
  EXPECT_EQ(with_own.size(), 12U);
  EXPECT_THAT(with_own, ::testing::Contains(3e-9));
  EXPECT_TRUE(std::ranges::is_sorted(with_own, std::ranges::greater{}));
}

TEST(ToleranceLadder, HasEveryToleranceOfASweep) {
  Experiment experiment = experiment_of({true, true, true});
  experiment.conditions[0].tolerance = 1e-6;
  experiment.conditions[1].tolerance = 3e-9;
  experiment.conditions[2].tolerance = 3e-9;
  EXPECT_EQ(own_tolerances(experiment), (std::vector{1e-6, 3e-9}));
  EXPECT_EQ(tolerance_ladder(experiment).size(), 12U);
  EXPECT_THAT(tolerance_ladder(experiment), ::testing::Contains(3e-9));
}

TEST(Cost, OfASweepOfTolerancesAndNumbersCountsEachConditionByItsOwn) {
  Experiment experiment = experiment_of({true, false, true});
  experiment.conditions[0].tolerance = experiment.conditions[1].tolerance = 1e-8;
  experiment.conditions[2].tolerance = 1e-4;
  experiment.conditions[0].realisations = 40;
  experiment.conditions[2].realisations = 100;
  for (Condition& condition : experiment.conditions) {
    condition.horizon = {.transient_periods = 1, .sampled_periods = 9};
  }
  const auto measured = two_conditions();
  const CostTiming times{.seconds_per_period = {1e-6, 2e-6, 4e-6}, .realisations = 1, .periods = 1};
  const Cost cost = cost_of(experiment, std::vector{1e-4, 1e-8, 1e-10}, measured, times);
  EXPECT_EQ(cost.own, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(cost.speed(0), 2.0) << "relative to the tightest of its own";
  EXPECT_EQ(cost.planned[1].periods, 10U * (4 * 40 + 1 + 4 * 100));
  EXPECT_DOUBLE_EQ(cost.planned[1].seconds, 10.0 * ((4 * 40 + 1) * 2e-6 + 4 * 100 * 1e-6));
  const double needed = static_cast<double>(cost.goals[0].needed.by_shares);
  EXPECT_DOUBLE_EQ(cost.goals[0].seconds, 10.0 * ((needed + 1.0) * 2e-6 + needed * 1e-6));
  const std::string table = cost_table({.experiment = &experiment, .cost = cost, .system = {}});
  EXPECT_THAT(table, ::testing::AllOf(HasSubstr("160 to 400"), HasSubstr("0.0001 *"), HasSubstr("1e-08 *"),
                                      HasSubstr("at the tightest tolerance of the experiment")));
}

MeasuredCost cost_with(const Experiment& experiment, const std::vector<ToleranceCost>& curve,
                       const Yardstick& yardstick) {
  Cost cost;
  cost.sample = curve.front().departure->flips.trials;
  cost.sampled_conditions = experiment.conditions.size();
  cost.curve = curve;
  cost.own = {3};
  cost.timing = support::timing_of(curve);
  cost.yardstick = yardstick;
  cost.recommendation = recommend(curve, yardstick, 0.95);
  return {.experiment = &experiment,
          .cost = cost,
          .system = {.build = {}, .machine = "", .start = "2012-02-01T12:00:00Z", .duration_s = 60.0}};
}

TEST(CostWords, SayWhatIsRecommendedWhyAndWhatIsGained) {
  const Experiment experiment = experiment_of({true});
  const auto measured = cost_with(experiment, curve_of({30, 1, 0, 0}, 4000), {.half_width = 0.04});
  EXPECT_EQ(
      cost_recommendation(measured),
      "Tolerance 1e-08 is recommended: 1 of 4000 response modes change (0 at 1e-12); the tolerance causes a change of "
      "at most 0.14 %, 1/29 of the half-width of the intervals, 4.00 %. Error in the first 10 periods: 1e-07 (median). "
      "It is "
      "4.00 times faster than 1e-12, the tolerance of the experiment.");
}

TEST(CostWords, OfTooFewRealisationsSayHowManyWouldDo) {
  const Experiment experiment = experiment_of({true});
  const auto some = cost_with(experiment, curve_of({9, 0, 0, 0}, 1000), {.half_width = 0.04});
  EXPECT_THAT(cost_recommendation(some), HasSubstr("Tolerance 1e-08 is not distinguishable from the tightest: "));
  EXPECT_THAT(cost_recommendation(some), HasSubstr("To show that at most 0.20 % change requires 1843 realisations, if "
                                                   "the share stays the same: about 0.057 s of "
                                                   "processor time."))
      << "of 31 000 steps in 1000 realisations, 1 us each, and not of the minute that their timing took too";
  const auto few = cost_with(experiment, curve_of({0, 0, 0, 0}, 50), {.half_width = 0.04});
  EXPECT_THAT(cost_recommendation(few),
              HasSubstr("No tolerance can be recommended: 50 realisations are too few to decide. To show"));
}

TEST(CostWords, OfEverythingSpeakOfNoInterval) {
  const Experiment experiment = experiment_of({false});
  const auto measured = cost_with(experiment, curve_of({1, 0, 0, 0}, 91), {.half_width = {}, .is_everything = true});
  EXPECT_THAT(cost_recommendation(measured), HasSubstr("0 of 91 response modes change (0 at 1e-12), of all"));
  EXPECT_THAT(cost_table(measured), HasSubstr("nothing is random"));
  EXPECT_THAT(cost_table(measured), Not(HasSubstr("[0.00")));
}

TEST(CostText, KeepsToItsSchemaAlsoWhereThereIsNothingToTell) {
  const Experiment random = experiment_of({true, false, true});
  const Experiment still = experiment_of({false});
  const std::vector<MeasuredRealisation> one_only{realisation({one, one, one})};
  const std::vector ladder{1e-4, 1e-8, 1e-10};
  const CostTiming no_times{.seconds_per_period = {0.0, 0.0, 0.0}, .realisations = 1, .periods = 1};
  for (const auto& measured : {cost_with(random, curve_of({9, 0, 0, 0}, 1000), {.half_width = 0.04}),
                               cost_with(random, curve_of({0, 0, 0, 0}, 5), {.half_width = 0.04}),
                               cost_with(still, curve_of({9, 1, 1, 0}, 10), {.half_width = {}, .is_everything = true}),
                               MeasuredCost{.experiment = &still,
                               .cost = cost_of(still, ladder, one_only, no_times),
                               .system = {.build = {}, .machine = "", .start = "2012-02-01T12:00:00Z"}}}) {
    EXPECT_EQ(support::objections("cost", cost_document().text(cost_report(measured))), "");
  }
}

TEST(CostText, DiffersInSystemOnlyWhereTimesDo) {
  const Experiment experiment = experiment_of({true, false, true});
  auto measured = two_conditions();
  CostTiming timing{.seconds_per_period = {1.0, 2.0, 3.0}, .realisations = 1, .periods = 1};
  const auto text = [&] {
    auto json = Json::parse(
        cost_document().text(cost_report({.experiment = &experiment,
                                          .cost = cost_of(experiment, std::vector{1e-4, 1e-8, 1e-10}, measured, timing),
                                          .system = {}})));
    json.erase("system");
    return json.dump();
  };
  const std::string before = text();
  timing = {.seconds_per_period = {3.0, 2.0, 1.0}, .realisations = 5, .periods = 7};
  EXPECT_EQ(text(), before);
  measured[1].runs[0].mode = three;
  EXPECT_NE(text(), before);
}

}  // namespace
}  // namespace rocking
