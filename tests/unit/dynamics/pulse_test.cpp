// The shapes of a pulse, their ends and their Taylor series, for one motion.

#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "rocking/dynamics/excitation/excitation.hpp"

namespace rocking::dynamics {
namespace {

constexpr double pulse_frequency = 3.0;
constexpr std::array pulse_forms{PulseForm{PulseShape::sine},
                                 PulseForm{PulseShape::cosine},
                                 PulseForm{PulseShape::ricker},
                                 PulseForm{PulseShape::half_sine},
                                 PulseForm{PulseShape::sine, 0.8},
                                 PulseForm{PulseShape::cosine, -2.3},
                                 PulseForm{PulseShape::type_c, 0.0, 1.0},
                                 PulseForm{PulseShape::type_c, 0.0, 2.0},
                                 PulseForm{PulseShape::mavroeidis_papageorgiou, 0.0, 1.0},
                                 PulseForm{PulseShape::mavroeidis_papageorgiou, 0.7, 1.6},
                                 PulseForm{PulseShape::mavroeidis_papageorgiou, -1.5, 3.0}};

Clock clock_at_x(double x) {
  Clock clock(pulse_frequency, 0.0);
  clock.advance(x / pulse_frequency);
  return clock;
}

/// phi of Makris (1997), cot(phi) = (n + 1/2) pi - phi, by bisection: after the acceleration cos(x + phi) up to x = (2 n +
/// 1) pi - 2 phi the velocity sin(x + phi) - sin(phi) and the displacement cos(phi) - cos(x + phi) - x sin(phi) are 0.
long double phase_of_type_c(double n) {
  const long double middle = (n + 0.5L) * std::numbers::pi_v<long double>;
  long double low = 0.001L, high = 0.5L;
  for (int i = 0; i < 80; ++i) {
    const long double phi = 0.5L * (low + high);
    (std::cos(phi) > (middle - phi) * std::sin(phi) ? low : high) = phi;
  }
  return low;
}

/// In 2 pi/Omega_h, as the sources state it.
double expected_length(const PulseForm& form) {
  switch (form.shape) {
    case PulseShape::ricker: return 2.0 * ricker_half_length;
    case PulseShape::half_sine: return 0.5;
    case PulseShape::type_c:
      return static_cast<double>(form.cycles + 0.5L - phase_of_type_c(form.cycles) / std::numbers::pi_v<long double>);
    case PulseShape::mavroeidis_papageorgiou: return form.cycles;
    default: return 1.0;
  }
}

/// Velocity of Mavroeidis & Papageorgiou (2003) over A, x after its beginning.
long double near_fault_velocity(const PulseForm& form, long double x) {
  const long double y = x - std::numbers::pi_v<long double> * form.cycles;
  return 0.5L * (1.0L + std::cos(y / form.cycles)) * std::cos(y + form.phase);
}

/// f at x since the pulse began, by the C library.
double expected_value(const PulseForm& form, long double x) {
  switch (form.shape) {
    case PulseShape::cosine: return static_cast<double>(std::cos(x + form.phase));
    case PulseShape::type_c: return static_cast<double>(std::cos(x + phase_of_type_c(form.cycles)));
    case PulseShape::ricker: {
      const long double y = x - 2.0L * std::numbers::pi_v<long double> * ricker_half_length;
      return static_cast<double>((1.0L - 0.5L * y * y) * std::exp(-0.25L * y * y));
    }
    case PulseShape::mavroeidis_papageorgiou: {
      const long double y = x - std::numbers::pi_v<long double> * form.cycles;
      return static_cast<double>(-0.5L * (std::sin(y / form.cycles) / form.cycles * std::cos(y + form.phase) +
                                          (1.0L + std::cos(y / form.cycles)) * std::sin(y + form.phase)));
    }
    default: return static_cast<double>(std::sin(x + form.phase));
  }
}

double value_at(const PulseForm& form, double x) {
  return PulseExcitation(form, clock_at_x(0.0)).horizontal(clock_at_x(x), 1.0);
}

// x is rounded to 2^-52 of a period, about 1.4e-15 at most; abs(f') <= 1.4.
TEST(Pulse, HasItsShapeWhileItLastsAndNothingAfterIt) {
  for (const PulseForm& form : pulse_forms) {
    const double length = 2.0 * std::numbers::pi * expected_length(form);
    for (double x = 0.0; x < 3.0 * length; x += 0.0137) {
      EXPECT_NEAR(value_at(form, x), x < length ? expected_value(form, x) : 0.0, 1e-14)
          << static_cast<int>(form.shape) << " " << x;
      EXPECT_LE(std::abs(value_at(form, x)), 1.0 + 1e-15);
    }
    EXPECT_EQ(value_at(form, 1e4 * length), 0.0);
  }
}

TEST(Pulse, EndsAtItsOnlyBreakpoint) {
  for (const PulseForm& form : pulse_forms) {
    const PulseExcitation pulse(form, clock_at_x(0.0));
    Clock clock = clock_at_x(0.1);
    const auto end = pulse.next_change(clock);
    ASSERT_TRUE(end);
    EXPECT_NEAR(clock.until(*end) * pulse_frequency + 0.1, 2.0 * std::numbers::pi * expected_length(form), 1e-14);
    EXPECT_NEAR(pulse_length(form), expected_length(form), 1e-15);
    clock.set(*end);
    EXPECT_FALSE(pulse.next_change(clock)) << "the base is still from there on";
    EXPECT_EQ(pulse.horizontal(clock, 1.0), 0.0);
  }
}

TEST(RickerPulse, IsCutWhereItFallsBelowAMillionthOfItsPeak) {
  const double half = 2.0 * std::numbers::pi * ricker_half_length;
  EXPECT_NEAR((0.5 * half * half - 1.0) * std::exp(-0.25 * half * half), 1e-6, 1e-20);
  EXPECT_NEAR(value_at({PulseShape::ricker}, 0.0), -1e-6, 1e-20);
  EXPECT_EQ(value_at({PulseShape::ricker}, half), 1.0) << "the peak is in the middle";
}

// Omega_h is where the spectrum of the acceleration is largest.
TEST(RickerPulse, HasItsPredominantFrequencyAtTheFrequencyRatio) {
  const auto spectrum = [](double omega) {
    double sum = 0.0;
    const double half = 2.0 * std::numbers::pi * ricker_half_length;
    for (double y = -half + 0.005; y < half; y += 0.01) {
      sum += 0.01 * value_at({PulseShape::ricker}, y + half) * std::cos(omega * y);
    }
    return sum;
  };
  EXPECT_GT(spectrum(1.0), spectrum(0.99));
  EXPECT_GT(spectrum(1.0), spectrum(1.01));
}

// The first term left out, of order 15, is below 1.1 sqrt(17!) 2^-7.5 0.3^15/15! = 2e-15 (Cramer's bound for the
// derivatives of a Gaussian); the rest is rounding.
TEST(Pulse, HasSeriesThatMeetItsValuesLater) {
  for (const PulseForm& form : pulse_forms) {
    const PulseExcitation pulse(form, clock_at_x(0.0));
    const double length = 2.0 * std::numbers::pi * expected_length(form);
    for (double x = 0.0; x + 0.3 < length; x += 0.07) {
      MotionSeries<double> series;
      const Clock now = clock_at_x(x);
      PulseExcitation::expand<full_order>(series, pulse.piece(now), -2.0, moment_of(now));
      double sum = 0.0;
      for (int k = full_order; k >= 0; --k)
        sum = sum * (0.3 / pulse_frequency) + series.base[static_cast<std::size_t>(k)];
      EXPECT_NEAR(sum, -2.0 * expected_value(form, x + 0.3), 2e-14) << static_cast<int>(form.shape) << " " << x;
    }
  }
}

/// The integral of f from 0 to `end`, and that of the integral, by the midpoints of 20000 intervals.
std::array<double, 2> integrals_to(const PulseForm& form, double end) {
  constexpr int intervals = 20000;
  const double h = end / intervals;
  double velocity = 0.0, displacement = 0.0;
  for (int i = 0; i < intervals; ++i) {
    const double f = value_at(form, (i + 0.5) * h);
    displacement += h * (velocity + 0.5 * h * f);
    velocity += h * f;
  }
  return {velocity, displacement};
}

TEST(TypeCPulse, LeavesNoVelocityAndNoDisplacement) {
  for (const double n : {1.0, 2.0, 3.0}) {
    const PulseForm form{PulseShape::type_c, 0.0, n};
    const auto [velocity, displacement] = integrals_to(form, 2.0 * std::numbers::pi * pulse_length(form));
    EXPECT_NEAR(velocity, 0.0, 1e-6) << n;
    EXPECT_NEAR(displacement, 0.0, 1e-5) << n;
  }
}

TEST(MavroeidisPapageorgiouPulse, IsTheDerivativeOfTheVelocityOfItsSource) {
  for (const PulseForm& form : {PulseForm{PulseShape::mavroeidis_papageorgiou, 0.7, 1.6},
                                PulseForm{PulseShape::mavroeidis_papageorgiou, 4.0, 2.5}}) {
    for (const double share : {0.2, 0.5, 0.9, 1.0}) {
      const double x = share * 2.0 * std::numbers::pi * form.cycles;
      EXPECT_NEAR(integrals_to(form, x)[0], static_cast<double>(near_fault_velocity(form, x)), 1e-6) << share;
    }
  }
}

// The bell of ricker is out of the reach of the exponential function there.
TEST(Pulse, HasItsShapeFarFromItsMiddle) {
  for (const PulseForm& form :
       {PulseForm{PulseShape::type_c, 0.0, 40.0}, PulseForm{PulseShape::mavroeidis_papageorgiou, 0.3, 40.0}}) {
    for (const double x : {0.01, 20.0, 125.0, 250.0})
      EXPECT_NEAR(value_at(form, x), expected_value(form, x), 1e-12) << x;
  }
}

TEST(Pulse, HasSeriesOfNothingAfterIt) {
  const PulseExcitation pulse({PulseShape::cosine}, clock_at_x(0.0));
  const Clock now = clock_at_x(1e5);
  MotionSeries<double> series;
  PulseExcitation::expand<full_order>(series, pulse.piece(now), 5.0, moment_of(now));
  for (std::size_t k = 0; k <= full_order; ++k) EXPECT_EQ(series.base[k], 0.0) << k;
}

}  // namespace
}  // namespace rocking::dynamics
