// A run that stops when its intervals are narrow enough: where it stops depends on the random numbers only.

#include <algorithm>
#include <atomic>

#include <gtest/gtest.h>

#include "rocking/ensemble/run.hpp"
#include "rocking/ensemble/stopping.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

/// Inexpensive conditions: a free block with a random start overturns or comes to rest within two periods. In the first
/// condition both are equally likely, in the second it almost always comes to rest, in the third always.
Experiment experiment(double half_width, std::uint64_t at_most) {
  Experiment question;
  question.seed = 0x2012;
  for (const double widest : {2.0, 1.01, 0.0}) {
    Condition condition;
    support::harmonic(condition.scene).frequency_ratio = 0.05;
    condition.horizon = {.transient_periods = 1, .sampled_periods = 1};
    condition.tolerance = 1e-8;
    if (widest > 0.0) condition.scene.initial.tilt = Uniform{.low = 0.0, .high = widest};
    condition.until = Until{.half_width = half_width};
    condition.realisations = at_most;
    question.conditions.push_back(condition);
  }
  return question;
}

ExperimentResult result_with(const Experiment& question, unsigned threads) {
  return run(question, {.threads = threads, .on_progress = {}, .stop_requested = nullptr}).value();
}

double widest_half(const ConditionResult& condition) {
  double widest = 0.0;
  for (const auto& [mode, probability] : condition.modes) {
    widest = std::max(widest, 0.5 * (probability.anytime->high - probability.anytime->low));
  }
  return widest;
}

TEST(Until, StopsWhereEveryIntervalIsNarrowEnoughAndNotBefore) {
  const Experiment question = experiment(0.1, 5000);
  const ExperimentResult result = result_with(question, 2);
  EXPECT_EQ(result.conditions[0].stopped_because, StoppedBecause::half_width_reached);
  EXPECT_LE(widest_half(result.conditions[0]), 0.1);
  EXPECT_GT(result.conditions[0].realisations, result.conditions[1].realisations) << "even odds need the most";

  Experiment fewer = question;
  const stats::StoppingRule rule = stopping_rule(question.conditions[0]);
  std::uint64_t last_but_one = 0;
  for (std::uint64_t look = rule.next_look(0); look < result.conditions[0].realisations; look = rule.next_look(look)) {
    last_but_one = look;
  }
  ASSERT_GT(last_but_one, 0U);
  fewer.conditions[0].realisations = last_but_one;
  const ExperimentResult before = result_with(fewer, 2);
  EXPECT_EQ(before.conditions[0].stopped_because, StoppedBecause::at_most_reached);
  EXPECT_EQ(before.conditions[0].realisations, last_but_one);
}

const section::ResponseMode overturned{.kind = section::ResponseKind::overturned};

double half_width_of(const ConditionResult& condition, const section::ResponseMode& mode) {
  const auto found = std::ranges::find(condition.modes, mode, &ModeEstimate::mode);
  return 0.5 * (found->probability.anytime->high - found->probability.anytime->low);
}

TEST(Until, AimsAtOneModeAndLeavesTheOthersAsTheyAre) {
  Experiment one = experiment(0.1, 5000);
  for (Condition& condition : one.conditions) condition.until->mode = overturned;
  const ConditionResult of_one = result_with(one, 2).conditions[1];
  const ConditionResult of_all = result_with(experiment(0.1, 5000), 2).conditions[1];
  EXPECT_EQ(of_one.stopped_because, StoppedBecause::half_width_reached);
  EXPECT_LE(half_width_of(of_one, overturned), 0.1);
  EXPECT_LE(of_one.realisations, of_all.realisations);
  one.conditions[1].until->mode = section::periodic(2, 5);  // does not occur
  const ConditionResult of_absent = result_with(one, 2).conditions[1];
  EXPECT_EQ(of_absent.stopped_because, StoppedBecause::half_width_reached);
  EXPECT_LE(of_absent.realisations, of_all.realisations);
}

TEST(Until, MeasuresTheHalfWidthRelativeToTheEstimateOfTheMode) {
  Experiment question = experiment(0.1, 5000);
  for (Condition& condition : question.conditions) {
    condition.until = Until{.relative_half_width = 0.2, .mode = overturned};
  }
  const ExperimentResult result = result_with(question, 2);
  const ConditionResult& even_odds = result.conditions[0];
  const auto found = std::ranges::find(even_odds.modes, overturned, &ModeEstimate::mode);
  EXPECT_EQ(even_odds.stopped_because, StoppedBecause::half_width_reached);
  EXPECT_LE(half_width_of(even_odds, overturned), 0.2 * found->probability.estimate);
  EXPECT_GT(half_width_of(even_odds, overturned), 0.1 * found->probability.estimate)
      << "it stopped long after it could";
  question.conditions[0].until->mode = section::periodic(2, 5);  // does not occur
  question.conditions[0].realisations = 200;
  EXPECT_EQ(result_with(question, 2).conditions[0].stopped_because, StoppedBecause::at_most_reached);
}

TEST(Until, SaysThatOneRunSaysAllWhereNothingIsRandom) {
  const ExperimentResult result = result_with(experiment(0.1, 5000), 1);
  EXPECT_EQ(result.conditions[2].stopped_because, StoppedBecause::deterministic);
  EXPECT_EQ(result.conditions[2].realisations, 1U);
}

TEST(Until, TakesNoMoreThanItMay) {
  for (const std::uint64_t at_most : {1U, 7U, 50U, 73U}) {
    const ExperimentResult result = result_with(experiment(0.01, at_most), 3);
    EXPECT_EQ(result.conditions[0].realisations, at_most);
    EXPECT_EQ(result.conditions[0].stopped_because, StoppedBecause::at_most_reached);
  }
}

TEST(Until, StopsAtTheSameNumberWithAnyNumberOfThreads) {
  const Experiment question = experiment(0.08, 5000);
  const ExperimentResult alone = result_with(question, 1);
  for (const unsigned threads : {2U, 7U, 16U}) {
    const ExperimentResult together = result_with(question, threads);
    EXPECT_EQ(together.digest, alone.digest);
    for (std::size_t i = 0; i < alone.conditions.size(); ++i) {
      EXPECT_EQ(together.conditions[i].realisations, alone.conditions[i].realisations);
    }
  }
}

TEST(Until, StopsAtTheSameNumberWhereverItWasInterrupted) {
  const Experiment question = experiment(0.1, 5000);
  const ExperimentResult alone = result_with(question, 1);
  Store store = Store::in_memory({.experiment = "", .code = "", .files = "", .shard = {}});
  std::uint64_t stops = 0;
  RunEnd end = RunEnd::stopped;
  while (end == RunEnd::stopped) {
    std::atomic<bool> stop{false};
    std::uint64_t calls = 0;
    const auto watch = [&](std::uint64_t, std::uint64_t) { stop = ++calls >= 11; };
    end = run(question, store, {.threads = 2, .on_progress = watch, .stop_requested = &stop});
    ASSERT_LT(++stops, 1000U);
  }
  EXPECT_GT(stops, 5U);
  EXPECT_EQ(result_of(question, store)->digest, alone.digest);
  const auto [done, all] = completeness(question, store);
  EXPECT_EQ(done, all);
  std::uint64_t realisations = 0;
  for (const ConditionResult& condition : alone.conditions) realisations += condition.realisations;
  EXPECT_EQ(done, realisations) << "nothing was run that is not needed";
}

}  // namespace
}  // namespace rocking
