// Time as a count of periods and a time within the period.

#include "rocking/dynamics/clock.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"

namespace rocking::dynamics {
namespace {

TEST(Clock, StartsAtItsPhase) {
  const Clock clock(10.0, 1.5);
  EXPECT_EQ(clock.now().period, 0);
  EXPECT_DOUBLE_EQ(clock.now().time, 0.15);
  EXPECT_EQ(clock.tau(), 0.0);
}

TEST(Clock, DoesNotDriftOverAMillionPeriods) {
  Clock clock(10.0, 0.3);
  const double length = clock.period_length();
  for (std::int64_t k = 1; k <= 1'000'000; ++k) {
    clock.advance(0.37 * length);
    clock.advance(clock.until({.period = k, .time = 0.0}));
  }
  EXPECT_LE(std::abs(clock.until({.period = 1'000'000, .time = 0.0})), clock.resolution());
  const double tau = (2.0 * std::numbers::pi * 1e6 - 0.3) / 10.0;
  EXPECT_NEAR(clock.tau(), tau, 4.0 * 0x1p-53 * tau);
}

TEST(Clock, IsAlwaysWithinItsPeriod) {
  Clock clock(7.0, 6.28);
  for (int i = 0; i < 100'000; ++i) {
    clock.advance(0.999 * clock.period_length());
    ASSERT_GE(clock.now().time, 0.0);
    ASSERT_LT(clock.now().time, clock.period_length());
  }
}

TEST(Clock, WrapsAnInstantThatLiesInALaterPeriod) {
  Clock clock(10.0, 0.0);
  clock.set({.period = 3, .time = 1.5 * clock.period_length()});
  EXPECT_EQ(clock.now().period, 4);
  EXPECT_NEAR(clock.now().time, 0.5 * clock.period_length(), 1e-16);
  clock.set({.period = 3, .time = clock.period_length()});
  EXPECT_EQ(clock.now().period, 4);
  EXPECT_EQ(clock.now().time, 0.0);
}

TEST(Clock, TellsTheTimeUntilAnInstantOfAnyPeriod) {
  Clock clock(10.0, 0.0);
  clock.set({.period = 5, .time = 0.25});
  EXPECT_EQ(clock.until({.period = 5, .time = 0.5}), 0.25);
  EXPECT_DOUBLE_EQ(clock.until({.period = 7, .time = 0.25}), 2.0 * clock.period_length());
  EXPECT_LT(clock.until({.period = 4, .time = 0.5}), 0.0);
}

// The base acceleration is zero at every strobe point: its value after a million periods shows any drift.
TEST(Clock, KeepsTheStrobeOnTheZeroOfTheBaseMotionForAMillionPeriods) {
  support::Stage stage{.frequency = 10.0, .tolerance = 1e-6, .periods = 1'000'000};
  support::Simulation simulation(stage, support::ScriptedCoefficients{.amplitude_value = 0.5});
  simulation.run();
  ASSERT_EQ(simulation.log.strobes.size(), 1'000'000U);
  simulation.motion.move_to_last_strobe();
  EXPECT_LE(std::abs(simulation.motion.base_motion().horizontal), 1e-14);
}

}  // namespace
}  // namespace rocking::dynamics
