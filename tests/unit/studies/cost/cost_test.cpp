// Cost of accuracy: which realisations are measured, and what is computed from them.

#include "rocking/studies/cost/cost.hpp"

#include <atomic>
#include <functional>
#include <limits>
#include <set>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/studies/cost/measurement.hpp"
#include "support/made_up_cost.hpp"

namespace rocking {
namespace {

using section::ResponseKind;
using section::ResponseMode;
using support::experiment_of;
using support::one;
using support::realisation;
using support::shaken_experiment;
using support::three;
using ::testing::ElementsAre;

TEST(CostSample, IsSpreadOverTheConditionsFromItsBeginning) {
  const CostSample sample(experiment_of(std::vector<bool>(6, true)));
  std::vector<std::uint64_t> conditions;
  for (std::uint64_t i = 0; i < 8; ++i) conditions.push_back(sample.at(i).condition);
  EXPECT_THAT(conditions, ElementsAre(0, 4, 2, 1, 5, 3, 0, 4));
  EXPECT_FALSE(sample.size().has_value());
}

TEST(CostSample, NeverMeasuresARealisationTwice) {
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

const std::vector<double> ladder{1e-4, 1e-8, 1e-13, 1e-14};

Experiment three_blocks() { return shaken_experiment({.transient_periods = 2, .sampled_periods = 48}, 4); }

std::vector<MeasuredRealisation> measure(std::uint64_t sample, const RunOptions& options = {},
                                         const std::function<bool()>& is_enough = {}) {
  return measure_cost(three_blocks(), {.tolerances = ladder, .sample = sample, .is_enough = is_enough}, options);
}

RealisationResult alone(const RealisationKey& key, double tolerance) {
  Condition condition = three_blocks().conditions[key.condition];
  condition.tolerance = tolerance;
  return realise(condition, three_blocks().seed, key.realisation);
}

TEST(MeasureCost, RunsEachRealisationAtAllTolerancesWithItsOwnDraws) {
  const auto measured = measure(8);
  ASSERT_EQ(measured.size(), 8U);
  for (std::uint64_t i = 0; i < 8; ++i) {
    EXPECT_EQ(measured[i].key, CostSample(three_blocks()).at(i));
    ASSERT_EQ(measured[i].runs.size(), ladder.size());
    const RealisationResult reference = alone(measured[i].key, ladder.back());
    for (std::size_t t = 0; t < ladder.size(); ++t) {
      const ToleranceRun& run = measured[i].runs[t];
      const RealisationResult result = alone(measured[i].key, ladder[t]);
      EXPECT_EQ(run.mode, result.classification.mode);
      EXPECT_EQ(run.periods, result.strobe.size());
      EXPECT_EQ(run.steps, result.operations.steps);
      EXPECT_EQ(run.error, t + 1 < ladder.size() ? error_beside(result, reference) : std::nullopt);
      EXPECT_EQ(run.diverged, divergence_period(result, reference).has_value());
    }
    EXPECT_GT(measured[i].runs[0].error, measured[i].runs[1].error);
  }
}

void expect_same(std::span<const MeasuredRealisation> some, std::span<const MeasuredRealisation> others) {
  ASSERT_EQ(some.size(), others.size());
  for (std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_EQ(some[i].key, others[i].key);
    for (std::size_t t = 0; t < ladder.size(); ++t) {
      EXPECT_EQ(some[i].runs[t].mode, others[i].runs[t].mode);
      EXPECT_EQ(some[i].runs[t].steps, others[i].runs[t].steps);
      EXPECT_EQ(some[i].runs[t].error, others[i].runs[t].error);
    }
  }
}

TEST(MeasureCost, FindsTheSameOnAnyNumberOfThreadsAndLanes) {
  const auto one_thread = measure(60);
  ASSERT_EQ(one_thread.size(), 60U);
  expect_same(one_thread, measure(60, {.threads = 4, .on_progress = {}}));
  expect_same(one_thread, measure(60, {.on_progress = {}, .lanes = lanes::available_kernels().front()}));
}

TEST(MeasureCost, EndsWhenThereAreEnoughButNotBeforeTheFirst) {
  EXPECT_EQ(measure(60, {}, [] { return true; }).size(), 1U);
  std::atomic<bool> is_enough = false;
  const RunOptions until_five{.threads = 2,
                              .on_progress = [&](std::uint64_t done, std::uint64_t) { is_enough = done >= 5; }};
  const auto some = measure(1000, until_five, [&] { return is_enough.load(); });
  EXPECT_GE(some.size(), 5U);
  EXPECT_LE(some.size(), 5U + 3U + 2U) << "no more than half as many are under way, and one for each thread";
  expect_same(some, measure(some.size()));
}

TEST(MeasureCost, IsEmptyWhereItIsAskedToStop) {
  const std::atomic<bool> stop = true;
  EXPECT_TRUE(measure(60, {.threads = 2, .on_progress = {}, .stop_requested = &stop}).empty());
}

TEST(MeasureCost, PassesOnWhatWentWrong) {
  Experiment experiment = three_blocks();
  experiment.conditions[1].scene.restitution = std::numeric_limits<double>::quiet_NaN();
  for (const unsigned threads : {1U, 2U}) {
    const RunOptions options{.threads = threads, .on_progress = {}};
    EXPECT_THROW(static_cast<void>(measure_cost(experiment, {.tolerances = ladder, .sample = 60}, options)),
                 base::InputError);
  }
}

TEST(ErrorBeside, IsTheLargestOfAllStatesAndPeriodsThatBothReached) {
  RealisationResult reference;
  reference.strobe = {{.tilt = 0.1}, {.tilt = 0.2, .slip_rate = 1.0}, {.tilt = 0.3}};
  RealisationResult other = reference;
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
  RealisationResult still;
  still.strobe.resize(3);
  EXPECT_FALSE(error_beside(still, still).has_value());
  EXPECT_FALSE(error_beside(RealisationResult{}, RealisationResult{}).has_value());
}

TEST(CostCurve, CountsFlipsAndThoseThatTheFloorDoesNotHave) {
  std::vector<MeasuredRealisation> measured{realisation({three, three, one}, 0.1), realisation({three, one, one}, 0.4),
                                            realisation({one, three, one}, 0.2), realisation({one, one, one}, 0.3),
                                            realisation({three, three, three}, 9.0)};
  measured[3].runs[0].error.reset();
  measured[0].runs[0].diverged = true;
  const auto curve = cost_curve(std::vector{1e-4, 1e-8, 1e-12}, measured, 0.95);
  const Departure& coarse = *curve[0].departure;
  EXPECT_EQ(coarse.flips.successes, 2U);
  EXPECT_EQ(coarse.flips.trials, 5U);
  EXPECT_DOUBLE_EQ(coarse.flips_interval.high, stats::clopper_pearson({2, 5}, 0.95).high);
  ASSERT_TRUE(coarse.beside_tolerance_sensitivity.has_value());
  EXPECT_EQ(coarse.beside_tolerance_sensitivity->both, 1U);
  EXPECT_EQ(coarse.beside_tolerance_sensitivity->first_only, 1U);
  EXPECT_EQ(coarse.beside_tolerance_sensitivity->second_only, 1U);
  EXPECT_EQ(coarse.beside_tolerance_sensitivity->neither, 2U);
  EXPECT_EQ(coarse.moving, 4U);
  EXPECT_EQ(coarse.median_error, 0.2) << "the lower one of 0.1, 0.2, 0.4, 9";
  EXPECT_EQ(coarse.largest_error, 9.0);
  EXPECT_EQ(coarse.diverged, 1U);
  ASSERT_EQ(coarse.first_flips.size(), 2U);
  EXPECT_EQ(coarse.first_flips[0].mode, three);
  EXPECT_EQ(coarse.first_flips[0].reference, one);
  EXPECT_FALSE(curve[1].departure->beside_tolerance_sensitivity.has_value()) << "it is the floor";
  EXPECT_FALSE(curve[2].departure.has_value()) << "it is the reference";
  EXPECT_EQ(curve[2].periods, 100U);
  EXPECT_EQ(curve[2].steps, 500U);
}

}  // namespace
}  // namespace rocking
