// What accuracy costs: which realisations are measured, what is made of them, what is recommended and in which words.

#include "rocking/experiment/cost.hpp"

#include <atomic>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/experiment/cost_sample.hpp"
#include "rocking/report/json.hpp"
#include "rocking/report/write_cost.hpp"
#include "support/json_schema.hpp"

namespace rocking::experiment {
namespace {

using section::periodic;
using section::ResponseKind;
using section::ResponseMode;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr ResponseMode one = periodic(1, 1);
constexpr ResponseMode three = periodic(1, 3);

Condition condition_of(bool random) {
  Condition condition;
  condition.tolerance = 1e-10;
  condition.realisations = 200;
  if (random) condition.scene.initial.tilt = Normal{.mean = 0.0, .sigma = 1.0};
  return condition;
}

/// As many conditions, random where `random` says so.
Experiment experiment_of(const std::vector<bool>& random) {
  Experiment experiment;
  experiment.canonical_text = "{}";
  for (const bool is_random : random) experiment.conditions.push_back(condition_of(is_random));
  return experiment;
}

TEST(CostSample, IsSpreadOverTheConditionsFromItsBeginning) {
  const CostSample sample(experiment_of(std::vector<bool>(6, true)));
  std::vector<std::uint64_t> conditions;
  for (std::uint64_t i = 0; i < 8; ++i) conditions.push_back(sample.at(i).condition);
  EXPECT_THAT(conditions, ElementsAre(0, 4, 2, 1, 5, 3, 0, 4));
  EXPECT_FALSE(sample.size().has_value());
}

TEST(CostSample, NeverUsesTheSameDrawsTwice) {
  const CostSample sample(experiment_of({true, false, true}));
  std::set<std::uint64_t> numbers;
  for (std::uint64_t i = 0; i < 50; ++i) EXPECT_TRUE(numbers.insert(sample.at(i).realisation).second) << i;
}

TEST(CostSample, HasADeterministicConditionOnce) {
  const CostSample mixed(experiment_of({true, false, true}));
  std::uint64_t deterministic = 0;
  for (std::uint64_t i = 0; i < 50; ++i) deterministic += mixed.at(i).condition == 1 ? 1U : 0U;
  EXPECT_EQ(deterministic, 1U);
  EXPECT_EQ(CostSample(experiment_of({false, false, false})).size(), 3U);
  EXPECT_EQ(CostSample(experiment_of({true})).at(7).condition, 0U);
}

/// A motion of 20 periods that is off by its tolerance; one realisation in seven is another response at 1e-6.
Record made_up(const Condition& condition, std::uint64_t, std::uint64_t realisation) {
  Record record;
  record.verdict.mode = condition.tolerance >= 1e-6 && realisation % 7 == 0 ? three : one;
  for (int k = 1; k <= 20; ++k) record.strobe.push_back({.tilt = 0.5, .tilt_rate = k * condition.tolerance});
  record.effort.steps = 100;
  return record;
}

const std::vector<double> ladder{1e-4, 1e-6, 1e-10, 1e-13, 1e-14};

std::vector<MeasuredRealisation> measure(std::uint64_t sample, const RunOptions& options, const CostTools& tools) {
  return measure_cost(experiment_of({true, true, true}), {.tolerances = ladder, .sample = sample}, tools, options);
}

/// A clock that goes on by a second each time it is read.
CostTools made_up_tools() {
  return {.realise = made_up, .processor_seconds = [now = 0.0]() mutable { return now += 1.0; }};
}

TEST(MeasureCost, RunsEachRealisationAtAllTolerancesWithItsOwnDraws) {
  const auto measured = measure(8, {}, made_up_tools());
  ASSERT_EQ(measured.size(), 8U);
  for (std::uint64_t i = 0; i < 8; ++i) {
    EXPECT_EQ(measured[i].key.realisation, i);
    ASSERT_EQ(measured[i].runs.size(), ladder.size());
    EXPECT_EQ(measured[i].runs[1].mode, i % 7 == 0 ? three : one);
    EXPECT_EQ(measured[i].runs[2].mode, one);
    EXPECT_EQ(measured[i].runs[2].periods, 20U);
    EXPECT_EQ(measured[i].runs[2].steps, 100U);
    EXPECT_EQ(measured[i].runs[2].seconds, 1.0);
    EXPECT_DOUBLE_EQ(*measured[i].runs[0].error, 10 * (1e-4 - 1e-14)) << "of the first ten periods";
    EXPECT_FALSE(measured[i].runs.back().error.has_value());
  }
}

TEST(MeasureCost, FindsTheSameOnAnyNumberOfThreads) {
  CostTools tools{.realise = made_up, .processor_seconds = [] { return 0.0; }};
  const auto alone = measure(60, {}, tools);
  const auto together = measure(60, {.threads = 4, .on_progress = {}}, tools);
  ASSERT_EQ(together.size(), 60U);
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_EQ(together[i].key, alone[i].key);
    EXPECT_EQ(together[i].runs[1].mode, alone[i].runs[1].mode);
    EXPECT_EQ(together[i].runs[1].error, alone[i].runs[1].error);
  }
}

TEST(MeasureCost, StopsWhenAskedButNotBeforeTheFirst) {
  std::atomic<bool> stop = true;
  EXPECT_EQ(measure(60, {.on_progress = {}, .stop_requested = &stop}, made_up_tools()).size(), 1U);
  stop = false;
  const RunOptions after_five{.on_progress = [&](std::uint64_t done, std::uint64_t) { stop = done == 5; },
                              .stop_requested = &stop};
  EXPECT_EQ(measure(60, after_five, made_up_tools()).size(), 5U);
}

TEST(MeasureCost, PassesOnWhatWentWrong) {
  CostTools broken = made_up_tools();
  broken.realise = [](const Condition&, std::uint64_t, std::uint64_t number) -> Record {
    if (number == 3) throw std::runtime_error("number 3");
    return made_up(condition_of(true), 0, number);
  };
  EXPECT_THROW(static_cast<void>(measure(60, {.threads = 2, .on_progress = {}}, broken)), std::runtime_error);
}

TEST(ErrorBeside, IsTheLargestOfAllStatesAndPeriodsThatBothReached) {
  Record reference;
  reference.strobe = {{.tilt = 0.1}, {.tilt = 0.2, .slip_rate = 1.0}, {.tilt = 0.3}};
  Record other = reference;
  EXPECT_EQ(error_beside(other, reference), 0.0);
  other.strobe[1].slip_rate = 1.5;
  EXPECT_EQ(error_beside(other, reference), 0.5);
  other.strobe[0].tilt_rate = -0.75;
  EXPECT_EQ(error_beside(other, reference), 0.75);
  other.strobe.resize(1);
  other.strobe[0] = {.tilt = 0.35};
  EXPECT_DOUBLE_EQ(*error_beside(other, reference), 0.25);
}

TEST(ErrorBeside, IsNotToBeHadOfABlockThatStandsStillOrFellAtOnce) {
  Record still;
  still.strobe.resize(3);
  EXPECT_FALSE(error_beside(still, still).has_value());
  EXPECT_FALSE(error_beside(Record{}, Record{}).has_value());
}

/// One realisation whose modes at the tolerances are these, and whose errors.
MeasuredRealisation realisation(const std::vector<ResponseMode>& modes, double error = 0.0,
                                std::uint64_t condition = 0) {
  MeasuredRealisation measured{.key = {.condition = condition, .realisation = 0}, .runs = {}};
  for (const ResponseMode& mode : modes) {
    measured.runs.push_back(
        {.mode = mode, .periods = 20, .steps = 100, .seconds = 0.5, .error = error, .parted = false});
  }
  measured.runs.back().error.reset();
  return measured;
}

TEST(CostCurve, CountsFlipsAndThoseThatTheFloorDoesNotHave) {
  std::vector<MeasuredRealisation> measured{realisation({three, three, one}, 0.1), realisation({three, one, one}, 0.4),
                                            realisation({one, three, one}, 0.2), realisation({one, one, one}, 0.3),
                                            realisation({three, three, three}, 9.0)};
  measured[3].runs[0].error.reset();
  measured[0].runs[0].parted = true;
  const auto curve = cost_curve(std::vector{1e-4, 1e-8, 1e-12}, measured, 0.95);
  const Departure& coarse = *curve[0].departure;
  EXPECT_EQ(coarse.flips.successes, 2U);
  EXPECT_EQ(coarse.flips.trials, 5U);
  EXPECT_DOUBLE_EQ(coarse.flips_interval.high, stats::clopper_pearson({2, 5}, 0.95).high);
  ASSERT_TRUE(coarse.beside_floor.has_value());
  EXPECT_EQ(coarse.beside_floor->both, 1U);
  EXPECT_EQ(coarse.beside_floor->first_only, 1U);
  EXPECT_EQ(coarse.beside_floor->second_only, 1U);
  EXPECT_EQ(coarse.beside_floor->neither, 2U);
  EXPECT_EQ(coarse.moving, 4U);
  EXPECT_EQ(coarse.median_error, 0.2) << "the lower one of 0.1, 0.2, 0.4, 9";
  EXPECT_EQ(coarse.largest_error, 9.0);
  EXPECT_EQ(coarse.parted, 1U);
  ASSERT_EQ(coarse.first_flips.size(), 2U);
  EXPECT_EQ(coarse.first_flips[0].mode, three);
  EXPECT_EQ(coarse.first_flips[0].reference, one);
  EXPECT_FALSE(curve[1].departure->beside_floor.has_value()) << "it is the floor";
  EXPECT_FALSE(curve[2].departure.has_value()) << "it is the reference";
  EXPECT_EQ(curve[2].periods, 100U);
  EXPECT_EQ(curve[2].steps, 500U);
  EXPECT_EQ(curve[2].seconds, 2.5);
}

/// A curve made by hand: flips of `trials` and steps, by falling tolerance; the floor's flips are among those of all others.
std::vector<ToleranceCost> curve_of(const std::vector<std::uint64_t>& flips, std::uint64_t trials,
                                    const std::vector<std::uint64_t>& steps = {}) {
  std::vector<ToleranceCost> curve(flips.size() + 1);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    curve[i].tolerance = std::vector{1e-6, 1e-8, 1e-10, 1e-12, 1e-14}[i];
    curve[i].periods = 1000;
    curve[i].steps = steps.empty() ? std::uint64_t{1000} << i : steps[i];
    curve[i].seconds = static_cast<double>(curve[i].steps) * 1e-6;
    if (i == flips.size()) break;
    Departure& departure = curve[i].departure.emplace();
    departure.median_error = 1e-7;
    departure.flips = {.successes = flips[i], .trials = trials};
    departure.flips_interval = stats::clopper_pearson(departure.flips, 0.95);
    if (i + 1 == flips.size()) continue;
    const std::uint64_t floor = std::min(flips[i], flips.back());
    departure.beside_floor = stats::PairedCounts{
        .both = floor, .first_only = flips[i] - floor, .second_only = 0, .neither = trials - flips[i]};
    departure.beyond_floor = stats::paired_difference_exact(*departure.beside_floor, 0.95);
  }
  return curve;
}

Recommendation recommended(const std::vector<ToleranceCost>& curve, double half_width = 0.04) {
  return recommend(curve, {.half_width = half_width}, 0.95);
}

// A twentieth of 0.04 is 0.002: the upper end for none of 2000 is 0.00184, for none of 1000 it is 0.0037.
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

// 1 of 1000 and 2 of 1000: at 0.001 and 0.002 of all.
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

// Where 40 of 2000 flip at the floor already, flips are rounding's doing, and 1e-8 adds none to them.
TEST(Recommendation, BlamesNoToleranceForWhatRoundingDoes) {
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

/// 40 of condition 0 in two modes, half and half; 10 of condition 2 in one mode; one deterministic one.
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
    const auto interval = stats::exact_interval({k, n}, mode_family(0.95).of_foreseen());
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

TEST(HalfWidthForecast, AimsAtTheHalfWidthThatTheExperimentNames) {
  auto experiment = experiment_of({true, false, true});
  for (Condition& condition : experiment.conditions) condition.until = Until{.half_width = 0.02};
  const auto measured = two_conditions();
  EXPECT_DOUBLE_EQ(HalfWidthForecast(experiment, measured).aim().value(), 0.02);
}

TEST(HalfWidthForecast, KnowsHowManyRealisationsAreNeeded) {
  const auto measured = two_conditions();
  const Experiment experiment = experiment_of({true, false, true});
  const HalfWidthForecast forecast(experiment, measured);
  for (const double half_width : {0.05, 0.01}) {
    const RealisationsNeeded needed = forecast.needed(half_width);
    const auto reached = [&](std::uint64_t n) {
      const auto interval = stats::exact_interval({n / 2, n}, mode_family(0.95).of_foreseen());
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

report::MeasuredCost cost_with(const Experiment& experiment, const std::vector<ToleranceCost>& curve,
                               const Yardstick& yardstick) {
  Cost cost;
  cost.sample = curve.front().departure->flips.trials;
  cost.sampled_conditions = experiment.conditions.size();
  cost.curve = curve;
  cost.own = 3;
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
      report::cost_recommendation(measured),
      "Recommended: tolerance 1e-08. 1 of 4000 response modes change by it (0 at 1e-12); it is to blame for at most "
      "0.14 %, 1/29 of the half-width of the intervals, 4.00 %. Error in the first 10 periods: 1e-07 (median). It is "
      "4.00 times faster than 1e-12, the experiment's own.");
}

TEST(CostWords, OfTooFewRealisationsSayHowManyWouldDo) {
  const Experiment experiment = experiment_of({true});
  const auto some = cost_with(experiment, curve_of({9, 0, 0, 0}, 1000), {.half_width = 0.04});
  EXPECT_THAT(report::cost_recommendation(some), HasSubstr("Not told apart from the tightest: tolerance 1e-08. "));
  EXPECT_THAT(
      report::cost_recommendation(some),
      HasSubstr(
          "To show that no more than 0.20 % change takes 1843 realisations, if as large a share does: some 1.8 min"));
  const auto few = cost_with(experiment, curve_of({0, 0, 0, 0}, 50), {.half_width = 0.04});
  EXPECT_THAT(report::cost_recommendation(few),
              HasSubstr("No tolerance can be recommended: 50 realisations are too few to tell. To show"));
}

TEST(CostWords, OfEverythingSpeakOfNoInterval) {
  const Experiment experiment = experiment_of({false});
  const auto measured = cost_with(experiment, curve_of({1, 0, 0, 0}, 91), {.half_width = {}, .is_everything = true});
  EXPECT_THAT(report::cost_recommendation(measured),
              HasSubstr("0 of 91 response modes change by it (0 at 1e-12), of all"));
  EXPECT_THAT(report::cost_table(measured), HasSubstr("nothing is drawn at random"));
  EXPECT_THAT(report::cost_table(measured), Not(HasSubstr("[0.00")));
}

TEST(CostText, KeepsToItsSchemaAlsoWhereThereIsNothingToTell) {
  const Experiment random = experiment_of({true, false, true});
  const Experiment still = experiment_of({false});
  const std::vector<MeasuredRealisation> one_only{realisation({one, one, one})};
  for (const auto& measured : {cost_with(random, curve_of({9, 0, 0, 0}, 1000), {.half_width = 0.04}),
                               cost_with(random, curve_of({0, 0, 0, 0}, 5), {.half_width = 0.04}),
                               cost_with(still, curve_of({9, 1, 1, 0}, 10), {.half_width = {}, .is_everything = true}),
                               report::MeasuredCost{.experiment = &still,
                               .cost = cost_of(still, std::vector{1e-4, 1e-8, 1e-10}, one_only),
                               .system = {.build = {}, .machine = "", .start = "2012-02-01T12:00:00Z"}}}) {
    EXPECT_EQ(support::objections("cost", report::cost_text(measured)), "");
  }
}

TEST(CostText, DiffersInSystemOnlyWhereTimesDo) {
  const Experiment experiment = experiment_of({true, false, true});
  auto measured = two_conditions();
  const auto text = [&] {
    auto json =
        report::Json::parse(report::cost_text({.experiment = &experiment,
                                               .cost = cost_of(experiment, std::vector{1e-4, 1e-8, 1e-10}, measured),
                                               .system = {}}));
    json.erase("system");
    return json.dump();
  };
  const std::string before = text();
  measured[1].runs[0].seconds = 100.0;
  EXPECT_EQ(text(), before);
  measured[1].runs[0].mode = three;
  EXPECT_NE(text(), before);
}

}  // namespace
}  // namespace rocking::experiment
