// The shapes of a pulse, their ends and their Taylor series, for one motion.

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "rocking/dynamics/excitation/excitation.hpp"

namespace rocking::dynamics {
namespace {

constexpr double pulse_frequency = 3.0;
constexpr std::array pulse_shapes{PulseShape::sine, PulseShape::cosine, PulseShape::ricker};

Clock clock_at_x(double x) {
  Clock clock(pulse_frequency, 0.0);
  clock.advance(x / pulse_frequency);
  return clock;
}

/// f at x since the pulse began, by the C library.
double expected_value(PulseShape shape, double x) {
  if (shape == PulseShape::sine) return std::sin(x);
  if (shape == PulseShape::cosine) return std::cos(x);
  const double y = x - std::numbers::pi * pulse_length(shape);
  return (1.0 - 0.5 * y * y) * std::exp(-0.25 * y * y);
}

double value_at(PulseShape shape, double x) {
  return PulseExcitation(shape, clock_at_x(0.0)).horizontal(clock_at_x(x), 1.0);
}

// x is rounded to 2^-52 of a period, about 1.4e-15 at most; abs(f') <= 1.4.
TEST(Pulse, HasItsShapeWhileItLastsAndNothingAfterIt) {
  for (const PulseShape shape : pulse_shapes) {
    const double length = 2.0 * std::numbers::pi * pulse_length(shape);
    for (double x = 0.0; x < 3.0 * length; x += 0.0137) {
      EXPECT_NEAR(value_at(shape, x), x < length ? expected_value(shape, x) : 0.0, 1e-14)
          << static_cast<int>(shape) << " " << x;
    }
    EXPECT_EQ(value_at(shape, 1e4 * length), 0.0);
  }
}

TEST(Pulse, EndsAtItsOnlyBreakpoint) {
  for (const PulseShape shape : pulse_shapes) {
    const PulseExcitation pulse(shape, clock_at_x(0.0));
    Clock clock = clock_at_x(0.1);
    const auto end = pulse.next_change(clock);
    ASSERT_TRUE(end);
    EXPECT_NEAR(clock.until(*end) * pulse_frequency + 0.1, 2.0 * std::numbers::pi * pulse_length(shape), 1e-14);
    clock.set(*end);
    EXPECT_FALSE(pulse.next_change(clock)) << "the base is still from there on";
    EXPECT_EQ(pulse.horizontal(clock, 1.0), 0.0);
  }
}

TEST(RickerPulse, IsCutWhereItFallsBelowAMillionthOfItsPeak) {
  const double half = 2.0 * std::numbers::pi * ricker_half_length;
  EXPECT_NEAR((0.5 * half * half - 1.0) * std::exp(-0.25 * half * half), 1e-6, 1e-20);
  EXPECT_NEAR(value_at(PulseShape::ricker, 0.0), -1e-6, 1e-20);
  EXPECT_EQ(value_at(PulseShape::ricker, half), 1.0) << "the peak is in the middle";
}

// Omega_h is where the spectrum of the acceleration is largest.
TEST(RickerPulse, HasItsPredominantFrequencyAtTheFrequencyRatio) {
  const auto spectrum = [](double omega) {
    double sum = 0.0;
    const double half = 2.0 * std::numbers::pi * ricker_half_length;
    for (double y = -half + 0.005; y < half; y += 0.01) {
      sum += 0.01 * value_at(PulseShape::ricker, y + half) * std::cos(omega * y);
    }
    return sum;
  };
  EXPECT_GT(spectrum(1.0), spectrum(0.99));
  EXPECT_GT(spectrum(1.0), spectrum(1.01));
}

// The first term left out, of order 15, is below 1.1 sqrt(17!) 2^-7.5 0.3^15/15! = 2e-15 (Cramer's bound for the
// derivatives of a Gaussian); the rest is rounding.
TEST(Pulse, HasSeriesThatMeetItsValuesLater) {
  for (const PulseShape shape : pulse_shapes) {
    const PulseExcitation pulse(shape, clock_at_x(0.0));
    const double length = 2.0 * std::numbers::pi * pulse_length(shape);
    for (double x = 0.0; x + 0.3 < length; x += 0.07) {
      MotionSeries<double> series;
      const Clock now = clock_at_x(x);
      PulseExcitation::expand<full_order>(series, pulse.piece(now), -2.0, moment_of(now));
      double sum = 0.0;
      for (int k = full_order; k >= 0; --k)
        sum = sum * (0.3 / pulse_frequency) + series.base[static_cast<std::size_t>(k)];
      EXPECT_NEAR(sum, -2.0 * expected_value(shape, x + 0.3), 2e-14) << static_cast<int>(shape) << " " << x;
    }
  }
}

TEST(Pulse, HasSeriesOfNothingAfterIt) {
  const PulseExcitation pulse(PulseShape::cosine, clock_at_x(0.0));
  const Clock now = clock_at_x(1e5);
  MotionSeries<double> series;
  PulseExcitation::expand<full_order>(series, pulse.piece(now), 5.0, moment_of(now));
  for (std::size_t k = 0; k <= full_order; ++k) EXPECT_EQ(series.base[k], 0.0) << k;
}

}  // namespace
}  // namespace rocking::dynamics
