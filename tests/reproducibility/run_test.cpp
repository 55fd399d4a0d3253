// The same bits with any number of threads and in any order of work.

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/ensemble/run.hpp"
#include "rocking/ensemble/work_list.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/scene/experiment.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

Condition condition_at(double amplitude, std::uint64_t realisations) {
  Condition condition = support::shaken(amplitude, Friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.3});
  condition.horizon = {.transient_periods = 30, .sampled_periods = 40};
  condition.realisations = realisations;
  return condition;
}

/// Four conditions of different cost: friction that fluctuates, an odd number of realisations, a random start, nothing
/// random.
Experiment four_conditions() {
  Experiment question;
  question.seed = 0x2012;
  Condition fluctuating = condition_at(4.5, 12);
  fluctuating.scene.fluctuation.static_friction = 0.03;
  fluctuating.scene.fluctuation.kinetic_friction = 0.03;
  Condition odd = fluctuating;
  support::harmonic(odd.scene).amplitude = 9.0;
  odd.realisations = 7;
  Condition started = condition_at(3.6, 11);
  started.scene.initial.tilt = Uniform{.low = -0.5, .high = 0.5};
  support::harmonic(started.scene).phase = Uniform{.low = 0.0, .high = 6.28};
  question.conditions = {fluctuating, odd, started, condition_at(7.0, 50)};
  return question;
}

ExperimentResult result_with(unsigned threads) {
  RunOptions options;
  options.threads = threads;
  auto result = run(four_conditions(), options);
  EXPECT_TRUE(result.has_value());
  return std::move(*result);
}

// lib/docs/draws.md: the record of a suite enters the seed, in runs with their reruns, and of one realisation.
TEST(RecordOfASuite, IsPartOfTheSeedWhereverARealisationIsDrawn) {
  constexpr std::uint64_t stream = 0xfedcba9876543210;
  const Experiment plain = four_conditions();
  Experiment of_record = plain;
  of_record.seed ^= stream;
  for (Condition& condition : of_record.conditions) condition.record_stream = stream;
  RunOptions options;
  options.threads = 1;
  EXPECT_EQ(run(plain, options)->digest, run(of_record, options)->digest);
  for (std::size_t i = 0; i < plain.conditions.size(); ++i) {
    EXPECT_EQ(digest_of(realise(plain.conditions[i], plain.seed, 5), 5),
              digest_of(realise(of_record.conditions[i], of_record.seed, 5), 5));
    const TrajectoryExtent extent(3, 4, {});
    const Trajectory a = trajectory_of(plain.conditions[i], plain.seed, 5, extent);
    const Trajectory b = trajectory_of(of_record.conditions[i], of_record.seed, 5, extent);
    EXPECT_EQ(a.peaks.tilt, b.peaks.tilt);
  }
  of_record.conditions[0].record_stream = 0;
  EXPECT_NE(run(plain, options)->digest, run(of_record, options)->digest);
}

// The kernels that a run uses are those of RunOptions::lanes: one lane, eight, sixteen where the processor has them.
TEST(Run, HasTheSameBitsInLanesOfAnyWidthAlsoOfBlocksOfPartsUnderVerticalMotion) {
  Experiment question = four_conditions();
  Condition general = question.conditions[0];
  general.scene.block.mass = GivenEdges{.edges = {0.5, 0.45}, .centre_height = 2.0, .radius_of_gyration = 1.2};
  general.realisations = 37;
  Condition vertical = question.conditions[2];
  support::harmonic(vertical.scene).vertical = VerticalHarmonic{.amplitude = 1.0, .frequency_ratio = 20.0};
  Condition both = general;
  support::harmonic(both.scene).vertical = VerticalHarmonic{.amplitude = 2.0, .frequency_ratio = 10.0};
  question.conditions.insert(question.conditions.end(), {general, vertical, both});
  RunOptions options;
  options.threads = 2;
  const base::Sha256 expected = run(question, options)->digest;
  for (const lanes::Kernels& kernels : lanes::available_kernels()) {
    options.lanes = kernels;
    EXPECT_EQ(run(question, options)->digest, expected) << kernels.name;
  }
}

void expect_same(const DivergenceTimes& a, const DivergenceTimes& b) {
  EXPECT_EQ(a.pairs, b.pairs);
  EXPECT_EQ(a.diverged, b.diverged);
  EXPECT_EQ(a.lower_quartile, b.lower_quartile);
  EXPECT_EQ(a.median, b.median);
  EXPECT_EQ(a.upper_quartile, b.upper_quartile);
}

void expect_same(const NonRecurrence& a, const NonRecurrence& b) {
  EXPECT_EQ(a.differ, b.differ);
  EXPECT_EQ(a.differ_interval.low, b.differ_interval.low);
  EXPECT_EQ(a.differ_interval.high, b.differ_interval.high);
  EXPECT_EQ(a.entropy, b.entropy);
  expect_same(a.friction, b.friction);
  expect_same(a.arithmetic, b.arithmetic);
}

void expect_same(const ConditionResult& a, const ConditionResult& b) {
  EXPECT_EQ(a.realisations, b.realisations);
  ASSERT_EQ(a.modes.size(), b.modes.size());
  for (std::size_t i = 0; i < a.modes.size(); ++i) {
    EXPECT_EQ(a.modes[i].mode, b.modes[i].mode);
    EXPECT_EQ(a.modes[i].probability.counts.successes, b.modes[i].probability.counts.successes);
    for (std::size_t k = 0; k < stats::interval_methods.size(); ++k) {
      EXPECT_EQ(a.modes[i].probability.alone[k].low, b.modes[i].probability.alone[k].low);
      EXPECT_EQ(a.modes[i].probability.alone[k].high, b.modes[i].probability.alone[k].high);
    }
  }
  ASSERT_EQ(a.non_recurrence.has_value(), b.non_recurrence.has_value());
  if (a.non_recurrence) expect_same(*a.non_recurrence, *b.non_recurrence);
  EXPECT_EQ(a.operations.steps, b.operations.steps);
  EXPECT_EQ(a.operations.root_isolations, b.operations.root_isolations);
  EXPECT_EQ(a.operations.exponent_periods, b.operations.exponent_periods);
  EXPECT_EQ(a.operations.static_friction_draws, b.operations.static_friction_draws);
  EXPECT_EQ(a.operations.kinetic_friction_draws, b.operations.kinetic_friction_draws);
  EXPECT_EQ(a.operations.initial_draws, b.operations.initial_draws);
  EXPECT_EQ(a.operations.events, b.operations.events);
  EXPECT_EQ(a.stopped_because, b.stopped_because);
}

TEST(Run, GivesTheSameResultWithAnyNumberOfThreads) {
  const ExperimentResult alone = result_with(1);
  for (const unsigned threads : {2U, 7U}) {
    const ExperimentResult together = result_with(threads);
    EXPECT_EQ(together.digest, alone.digest) << threads << " threads";
    ASSERT_EQ(together.conditions.size(), alone.conditions.size());
    for (std::size_t i = 0; i < alone.conditions.size(); ++i) {
      SCOPED_TRACE(testing::Message() << threads << " threads, condition " << i);
      expect_same(together.conditions[i], alone.conditions[i]);
    }
  }
}

// Realisations computed in reverse order, last condition first, and combined in order have the digest of the run.
TEST(Run, HasTheDigestOfRealisationsMadeInAnyOrder) {
  const Experiment question = four_conditions();
  std::vector<base::Sha256> conditions(question.conditions.size());
  for (std::size_t i = question.conditions.size(); i-- > 0;) {
    const Condition& condition = question.conditions[i];
    std::vector<base::Sha256> realisations(effective_realisations(condition));
    for (std::uint64_t k = realisations.size(); k-- > 0;) {
      realisations[k] = digest_of(realise(condition, question.seed, k), k);
    }
    base::Sha256Builder builder;
    for (const base::Sha256& digest : realisations) builder.add(digest);
    conditions[i] = builder.finish();
  }
  base::Sha256Builder builder;
  for (const base::Sha256& digest : conditions) builder.add(digest);
  EXPECT_EQ(builder.finish(), result_with(2).digest);
}

TEST(Run, DependsOnItsSeed) {
  Experiment question = four_conditions();
  question.seed = 0x2013;
  EXPECT_NE(run(question, {.threads = 2, .on_progress = {}, .stop_requested = nullptr})->digest, result_with(2).digest);
}

TEST(Run, RunsOneRealisationWhereNothingIsRandom) {
  EXPECT_EQ(effective_realisations(condition_at(7.0, 50)), 1U);
  const ExperimentResult result = result_with(2);
  EXPECT_EQ(result.conditions.back().realisations, 1U);
  EXPECT_EQ(result.conditions.back().stopped_because, StoppedBecause::deterministic);
  EXPECT_FALSE(result.conditions.back().non_recurrence.has_value());
}

TEST(Run, GivesNothingWhereItIsAskedToStop) {
  for (const unsigned threads : {1U, 2U, 7U}) {
    const std::atomic<bool> stop{true};
    EXPECT_FALSE(run(four_conditions(), {.threads = threads, .on_progress = {}, .stop_requested = &stop}).has_value());
  }
}

TEST(Run, GivesNothingWhereItIsStoppedHalfWay) {
  std::atomic<bool> stop{false};
  std::uint64_t last = 0;
  const auto watch = [&](std::uint64_t done, std::uint64_t) {
    last = done;
    if (done >= 4) stop = true;
  };
  EXPECT_FALSE(run(four_conditions(), {.threads = 2, .on_progress = watch, .stop_requested = &stop}).has_value());
  EXPECT_GE(last, 4U);
  EXPECT_LT(last, 31U);
}

TEST(Run, ReportsItsProgressFromItsBeginningToItsEnd) {
  std::vector<std::uint64_t> told;
  const auto watch = [&](std::uint64_t done, std::uint64_t all) {
    EXPECT_EQ(all, 12U + 7U + 11U + 1U);
    told.push_back(done);
  };
  ASSERT_TRUE(run(four_conditions(), {.threads = 7, .on_progress = watch, .stop_requested = nullptr}).has_value());
  ASSERT_GT(told.size(), 1U);
  EXPECT_EQ(told.front(), 0U);
  EXPECT_EQ(told.back(), 12U + 7U + 11U + 1U);
  EXPECT_TRUE(std::ranges::adjacent_find(told, std::greater_equal()) == told.end());
}

TEST(Run, RerunsAsManyRealisationsAsItIsAskedTo) {
  for (const auto& [every, rerun] : {std::pair{0U, 0U}, {1U, 12U}, {5U, 3U}, {100U, 1U}}) {
    Experiment question = four_conditions();
    for (Condition& condition : question.conditions) condition.rerun_every = every;
    const auto result = run(question, {.threads = 2, .on_progress = {}, .stop_requested = nullptr});
    EXPECT_EQ(result->conditions[0].non_recurrence->arithmetic_flips.trials, rerun);
    EXPECT_EQ(result->digest, result_with(2).digest) << "what is rerun does not touch what it is compared with";
  }
}

TEST(Run, CountsEveryRealisationOnce) {
  const ExperimentResult result = result_with(7);
  const Experiment question = four_conditions();
  for (std::size_t i = 0; i < result.conditions.size(); ++i) {
    std::uint64_t counted = 0;
    for (const ModeEstimate& mode : result.conditions[i].modes) counted += mode.probability.counts.successes;
    EXPECT_EQ(counted, effective_realisations(question.conditions[i]));
    EXPECT_EQ(result.conditions[i].realisations, counted);
  }
}

}  // namespace
}  // namespace rocking
