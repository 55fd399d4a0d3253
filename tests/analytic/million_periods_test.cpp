// A million periods: a periodic orbit stays where it was, and the error of the clock is limited to its roundings.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "rocking/dynamics/clock.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "support/excitation.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using dynamics::Clock;
using dynamics::ContactState;

constexpr std::int64_t million = 1'000'000;

Condition with_phase(double amplitude) {
  Condition condition = support::shaken(amplitude);
  support::harmonic(condition.scene).phase = 1.0;
  return condition;
}

const TrajectorySample& at(const Trajectory& trajectory, std::int64_t period) {
  return trajectory.strobe.at(static_cast<std::size_t>(period - 1));
}

/// Largest distance of later points from the one after a thousand periods.
double drift_of(const Trajectory& trajectory) {
  const TrajectorySample& reference = at(trajectory, 1'000);
  double largest = 0.0;
  for (std::int64_t period = 1'000; period <= million; ++period) {
    const TrajectorySample& now = at(trajectory, period);
    largest = std::max({largest, std::abs(now.tilt - reference.tilt), std::abs(now.tilt_rate - reference.tilt_rate),
                        std::abs(now.slip_rate - reference.slip_rate)});
  }
  return largest;
}

// A (1,1) orbit attracts nearby motions by a factor delta^2 = 0.83 per period. After a thousand periods the remaining
// error is the rounding of one period (some tens of steps and two impacts, 2^-53 times numbers below 1 each) plus what
// the attraction leaves of earlier ones, 1/(1 - 0.83) times as much. If the strobe drifted by 1e-16 of a period in each
// period, the point would have moved by 1e-10 Theta''.
TEST(MillionPeriods, OfAPeriodicOrbitEndWhereTheFirstThousandDid) {
  Condition condition = with_phase(2.0);
  condition.tolerance = 1e-6;
  const Trajectory trajectory = trajectory_of(condition, 0, 0, million);
  ASSERT_EQ(trajectory.strobe.size(), static_cast<std::size_t>(million));
  EXPECT_GT(std::abs(at(trajectory, million).tilt_rate), 0.01) << "it rocks";
  EXPECT_LE(drift_of(trajectory), 50 * 2 * 0x1p-53 / (1.0 - 0.83));
}

// Sliding to and fro under mu = 0.15 loses its history in each reversal.
TEST(MillionPeriods, OfSlidingToAndFroEndWhereTheFirstThousandDid) {
  Condition condition = with_phase(4.0);
  condition.tolerance = 1e-6;
  condition.scene.friction = Friction{.static_coefficient = 0.15, .kinetic_coefficient = 0.15};
  const Trajectory trajectory = trajectory_of(condition, 0, 0, million);
  ASSERT_EQ(trajectory.strobe.size(), static_cast<std::size_t>(million));
  EXPECT_EQ(at(trajectory, million).contact, ContactState::slide);
  EXPECT_LE(drift_of(trajectory), 50 * 0x1p-53);
}

// --- the clock against integers
// ----------------------------------------------------------------------------------------

__extension__ using Integer = __int128;

/// A double that is a multiple of 2^-60, as an integer multiple of it.
Integer exactly(double value) {
  const double scaled = std::ldexp(value, 60);
  EXPECT_EQ(scaled, std::floor(scaled));
  return static_cast<Integer>(scaled);
}

double as_double(Integer value) { return std::ldexp(static_cast<double>(value), -60); }

// Millions of steps of any length: the clock and the exact sum of the steps differ by the roundings of times within a
// period. Each is at most 2^-54, since these times are below 1. A single rounding of a time of a million periods would
// be 2^-34.
TEST(ClockArithmetic, OverAMillionPeriodsDiffersFromExactIntegersByTheRoundingsOfOneOnly) {
  Clock clock(10.0, 0.0);  // a period of 0.63: times and steps sum to less than 1
  const Integer length = exactly(clock.period_length());
  support::SplitMix random(20121107);
  Integer sum = 0;
  std::int64_t steps = 0;
  Integer worst = 0;
  while (clock.now().period < million) {
    // In multiples of 2^-60, the spacing of the smallest of them.
    const double step = std::ldexp(std::floor(std::ldexp(random.uniform(0.05, 0.3), 60)), -60);
    clock.advance(step);
    sum += exactly(step);
    ++steps;
    const Integer shown = length * clock.now().period + exactly(clock.now().time);
    const Integer error = shown > sum ? shown - sum : sum - shown;
    worst = std::max(worst, error);
  }
  EXPECT_LE(as_double(worst), static_cast<double>(steps) * 0x1p-54);
  EXPECT_GT(steps, 3 * million);
}

// Strobe instants are integers and have no rounding error, wherever within a period the clock is.
TEST(ClockArithmetic, TellsTheTimeUntilAStrobeAMillionPeriodsOnToOneRounding) {
  Clock clock(10.0, 0.0);
  const Integer length = exactly(clock.period_length());
  support::SplitMix random(20121108);
  for (int i = 0; i < 1'000; ++i) {
    clock.advance(std::ldexp(std::floor(std::ldexp(random.uniform(0.05, 0.6), 60)), -60));
    for (const std::int64_t period : {clock.now().period + 1, million, 1'000 * million}) {
      const Integer exact = length * (period - clock.now().period) - exactly(clock.now().time);
      const double until = clock.until({.period = period, .time = 0.0});
      EXPECT_NEAR(until / as_double(exact), 1.0, 0x1p-51) << period;
    }
  }
}

}  // namespace
}  // namespace rocking
