// Measurement of the time of realisations in lanes, with simulated clocks.

#include "rocking/studies/cost/cost.hpp"

#include <atomic>
#include <vector>

#include <gtest/gtest.h>

#include "support/made_up_cost.hpp"

namespace rocking {
namespace {

using support::shaken_experiment;

const std::vector<double> timed_tolerances{1e-4, 1e-8, 1e-12};

/// Clocks that advance by a second each time that they are read; counts the readings of each.
struct Clocks {
  std::atomic<int> processor = 0;
  std::atomic<int> wall = 0;

  [[nodiscard]] TimingPlan with_time(double seconds) {
    return {.processor_seconds = [this] { return static_cast<double>(++processor); },
            .seconds_left = [this, seconds] { return seconds - ++wall; }};
  }
  /// Each clock is read before and after each tolerance.
  [[nodiscard]] int rounds() const { return processor / (2 * static_cast<int>(timed_tolerances.size())); }
};

TEST(CostTiming, IsOfOneShortRoundWhereThereIsNoTime) {
  Clocks clocks;
  const Experiment experiment = shaken_experiment({.transient_periods = 40, .sampled_periods = 60}, 4);
  const CostTiming timing = time_cost(experiment, timed_tolerances, clocks.with_time(0.0), {});
  EXPECT_EQ(clocks.rounds(), 1);
  EXPECT_EQ(timing.realisations, 12U) << "as many as the experiment has";
  EXPECT_EQ(timing.periods, 16);
  ASSERT_EQ(timing.seconds_per_period.size(), timed_tolerances.size());
  for (const double seconds : timing.seconds_per_period) EXPECT_DOUBLE_EQ(seconds, 1.0 / (12 * 16));
}

TEST(CostTiming, DoublesThePeriodsUntilTheyAreTheExperimentsOwnAndKeepsToTheTime) {
  Clocks clocks;
  const Experiment experiment = shaken_experiment({.transient_periods = 10, .sampled_periods = 50}, 2);
  const CostTiming timing = time_cost(experiment, timed_tolerances, clocks.with_time(20.0), {});
  EXPECT_EQ(timing.periods, 60) << "16, 32, 60, 60, ...";
  EXPECT_EQ(clocks.rounds(), 10) << "the clock is read twice a round";
  for (const double seconds : timing.seconds_per_period) EXPECT_DOUBLE_EQ(seconds, 1.0 / (6 * 60));
}

TEST(CostTiming, EndsWhenThereAreEnoughRoundsOfTheLargest) {
  Clocks clocks;
  const Experiment experiment = shaken_experiment({.transient_periods = 10, .sampled_periods = 50}, 2);
  const CostTiming timing = time_cost(experiment, timed_tolerances, clocks.with_time(1e6), {});
  EXPECT_EQ(timing.periods, 60);
  EXPECT_EQ(clocks.rounds(), 2 + 9);
}

TEST(CostTiming, CountsTheLastSizeOnly) {
  Clocks clocks;
  const Experiment experiment = shaken_experiment({.transient_periods = 500, .sampled_periods = 500}, 1);
  const CostTiming timing = time_cost(experiment, timed_tolerances, clocks.with_time(12.0), {});
  EXPECT_EQ(clocks.rounds(), 6);
  EXPECT_EQ(timing.periods, 128) << "16, 32, 64, and three times 128";
  for (const double seconds : timing.seconds_per_period) EXPECT_DOUBLE_EQ(seconds, 1.0 / (3 * 128));
}

TEST(CostTiming, IsTheMedianOfRounds) {
  int reads = 0;  // the third round is disturbed
  const TimingPlan plan{.processor_seconds = [&] { return ++reads > 12 && reads <= 18 ? 100.0 * reads : reads; },
                        .seconds_left = [left = 6.0]() mutable { return left -= 1.0; }};
  const Experiment experiment = shaken_experiment({.transient_periods = 4, .sampled_periods = 8}, 1);
  const CostTiming timing = time_cost(experiment, timed_tolerances, plan, {});
  EXPECT_EQ(reads, 18);
  for (const double seconds : timing.seconds_per_period) EXPECT_DOUBLE_EQ(seconds, 1.0 / (3 * 12));
}

TEST(CostTiming, GivesEachThreadAsManyRealisationsAsARunDoesAndNoMoreThanFillTheLanes) {
  Clocks clocks;
  const Experiment few = shaken_experiment({.transient_periods = 2, .sampled_periods = 2}, 4);
  const CostTiming timing = time_cost(few, timed_tolerances, clocks.with_time(0.0), {.threads = 4, .on_progress = {}});
  EXPECT_EQ(timing.realisations, 3U);
  EXPECT_EQ(timing.periods, 4);
  EXPECT_EQ(clocks.rounds(), 4);
  const Experiment many = shaken_experiment({.transient_periods = 2, .sampled_periods = 2}, 100'000);
  EXPECT_EQ(time_cost(many, timed_tolerances, clocks.with_time(0.0), {}).realisations, 96U);
  clocks.wall = 0;
  EXPECT_EQ(time_cost(many, timed_tolerances, clocks.with_time(100.0), {}).realisations, 768U);
}

TEST(CostTiming, BeginsAnewWhereTheSampleHasAnEnd) {
  Clocks clocks;
  Experiment still = shaken_experiment({.transient_periods = 10, .sampled_periods = 20}, 4);
  for (Condition& condition : still.conditions) condition.scene.initial.tilt = 0.2;
  const CostTiming timing = time_cost(still, timed_tolerances, clocks.with_time(12.0), {});
  EXPECT_EQ(timing.realisations, 3U);
  EXPECT_EQ(timing.periods, 30);
}

TEST(CostTiming, EndsAtOnceWhenItIsAskedToStop) {
  Clocks clocks;
  const std::atomic<bool> stop = true;
  const Experiment experiment = shaken_experiment({.transient_periods = 2, .sampled_periods = 2}, 4);
  const CostTiming timing =
      time_cost(experiment, timed_tolerances, clocks.with_time(1e9), {.on_progress = {}, .stop_requested = &stop});
  EXPECT_EQ(clocks.processor, 1);
  EXPECT_EQ(timing.seconds_per_period, std::vector(timed_tolerances.size(), 0.0));
}

}  // namespace
}  // namespace rocking
