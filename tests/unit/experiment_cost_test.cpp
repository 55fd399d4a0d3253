// What accuracy costs: which realisations are measured, and what is made of them.

#include "rocking/experiment/cost.hpp"

#include <atomic>
#include <set>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/experiment/cost_sample.hpp"
#include "support/made_up_cost.hpp"

namespace rocking::experiment {
namespace {

using section::ResponseKind;
using section::ResponseMode;
using support::condition_of;
using support::experiment_of;
using support::one;
using support::realisation;
using support::three;
using ::testing::ElementsAre;

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

}  // namespace
}  // namespace rocking::experiment
