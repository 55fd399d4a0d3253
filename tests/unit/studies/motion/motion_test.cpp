// Intensity measures and response spectra of ground motions that are linear between samples, against closed forms and a
// separate integration.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/plan/plan.hpp"
#include "rocking/scene/intensity_measures.hpp"
#include "rocking/studies/motion/study.hpp"
#include "support/split_mix.hpp"

namespace {

using namespace rocking;
using std::numbers::pi;
using MotionSamples = std::vector<dynamics::GroundMotionSample>;

constexpr double standard = 9.80665;

/// `cycles` cycles of amplitude * sin(2 pi t/period), with an even number of samples in each.
MotionSamples sampled_sine(double amplitude, double period, int cycles, int per_cycle) {
  MotionSamples samples;
  for (int i = 0; i <= cycles * per_cycle; ++i) {
    samples.push_back({.time = period * i / per_cycle,
                       .horizontal = amplitude * std::sin(2.0 * pi * (i % per_cycle) / per_cycle),
                       .vertical = 0.0});
  }
  return samples;
}

/// A base that accelerates with `a` from 0 to `length`.
MotionSamples rectangle(double a, double length) {
  return {{.time = 0.0, .horizontal = a, .vertical = 0.0}, {.time = length, .horizontal = a, .vertical = 0.0}};
}

void expect_close(double found, double expected, double relative = 1e-12) {
  EXPECT_NEAR(found, expected, relative * std::abs(expected));
}

TEST(IntensityMeasures, OfASampledSineAreItsSums) {
  const int n = 50;
  const double amplitude = 0.3;
  const double period = 0.8;
  const auto found = intensity_measures(sampled_sine(amplitude, period, 7, n), standard);
  const double a = amplitude * standard;
  // Between samples a is linear, so that its square has the mean (2 + cos(2 pi/n))/6 of A^2.
  expect_close(found.arias_m_s, pi / (2.0 * standard) * a * a * 7 * period * (2.0 + std::cos(2.0 * pi / n)) / 6.0);
  // The sum of sin(2 pi k/n) over half a cycle is cot(pi/n).
  const double half_a_cycle = a * period / n / std::tan(pi / n);
  expect_close(found.pgv_m_s, half_a_cycle);
  expect_close(found.cav_m_s, 14 * half_a_cycle);
  expect_close(found.pga_g, amplitude * std::cos(pi / n));  // no sample is at the peak: n is no multiple of 4
}

TEST(IntensityMeasures, AreNotChangedByStillness) {
  const MotionSamples pulse{{0.0, 0.0, 0.0}, {0.1, 0.2, 0.0}, {0.2, 0.0, 0.0}};
  const MotionSamples padded{{0.0, 0.0, 0.0}, {0.1, 0.2, 0.0}, {0.2, 0.0, 0.0}, {0.3, 0.0, 0.0}, {9.0, 0.0, 0.0}};
  const auto found = intensity_measures(pulse, standard), of_padded = intensity_measures(padded, standard);
  expect_close(found.cav_m_s, 0.02 * standard);
  EXPECT_EQ(of_padded.cav_m_s, found.cav_m_s);
  EXPECT_EQ(of_padded.arias_m_s, found.arias_m_s);
}

TEST(IntensityMeasures, OfAFineSineTendToThoseOfASine) {
  const int n = 400'000;  // the error is at most (2 pi/n)^2/6 < 1e-10
  const double a = 2.0;
  const double period = 0.5;
  const auto found = intensity_measures(sampled_sine(a / standard, period, 1, n), standard);
  expect_close(found.arias_m_s, pi / (2.0 * standard) * a * a * period / 2.0, 1e-10);
  expect_close(found.cav_m_s, 2.0 * a * period / pi, 1e-10);
  expect_close(found.pgv_m_s, a * period / pi, 1e-10);
  expect_close(found.pgd_m, a * period * period / (2.0 * pi), 1e-10);  // it drifts by one a T/(2 pi) in a period
  EXPECT_EQ(found.pga_g, a / standard);
  EXPECT_EQ(found.pga_time_s, period / 4);
}

TEST(IntensityMeasures, OfAPushAndABrakeAreThoseOfUniformAcceleration) {
  const double a = 0.2;
  const double t = 0.7;
  const MotionSamples samples{{.time = 0.3, .horizontal = a, .vertical = 0.0},
                              {.time = 0.3 + t, .horizontal = a, .vertical = 0.1},
                              {.time = 0.3 + t, .horizontal = -a, .vertical = -0.3},
                              {.time = 0.3 + 3 * t, .horizontal = -a, .vertical = 0.0}};
  const auto found = intensity_measures(samples, 10.0);
  EXPECT_EQ(found.pga_g, a);
  EXPECT_EQ(found.vertical_pga_g, 0.3);
  expect_close(found.pgv_m_s, 10.0 * a * t);
  // It comes to a stop after 2 t, in the middle of a piece.
  expect_close(found.pgd_m, 10.0 * a * t * t);
  expect_close(found.arias_m_s, pi / 20.0 * 100.0 * a * a * 3 * t);
  expect_close(found.cav_m_s, 10.0 * a * 3 * t);
  expect_close(found.significant_from_s, 0.3 + 0.05 * 3 * t);
  expect_close(found.significant_to_s, 0.3 + 0.95 * 3 * t);
}

TEST(IntensityMeasures, OfAChangeOfSignWithinAPieceAreExact) {
  // From 1 to -3 in 2 s: 0 after 0.5 s.
  const MotionSamples samples{{.time = 0.0, .horizontal = 1.0, .vertical = 0.0},
                              {.time = 2.0, .horizontal = -3.0, .vertical = 0.0}};
  const auto found = intensity_measures(samples, 1.0);
  expect_close(found.cav_m_s, 0.5 * 0.5 * 1.0 + 0.5 * 1.5 * 3.0);
  expect_close(found.pgv_m_s, 2.0);  // at the end: -2; 0.25 at 0.5 s
  expect_close(found.arias_m_s, pi / 2.0 * (0.5 * 1.0 + 1.5 * 9.0) / 3.0);
  // u = t^2/2 - t^3/3: 1/6 where v = 0, at 1 s; -2/3 at the end.
  expect_close(found.pgd_m, 2.0 / 3.0);
  // The integral of a^2 is (1 - (1 - 2 t)^3)/6.
  expect_close(found.significant_from_s, 0.5 * (1.0 + std::cbrt(0.05 * 28.0 - 1.0)), 1e-12);
}

TEST(IntensityMeasures, AgreeWithTheSeriesOfTheBase) {
  const auto samples = sampled_sine(0.4, 1.0, 3, 20);
  const auto points = base_motion_of(samples, standard);
  ASSERT_EQ(points.size(), samples.size());
  const auto found = intensity_measures(samples, standard);
  double velocity = 0.0;
  double displacement = 0.0;
  for (const BasePoint& point : points) {
    velocity = std::max(velocity, std::abs(point.velocity));
    displacement = std::max(displacement, std::abs(point.displacement));
  }
  expect_close(velocity, found.pgv_m_s);
  expect_close(displacement, found.pgd_m);
}

TEST(UpliftScale, IsWhereTheAccelerationReachesTheSlopeOfTheDiagonal) {
  const dynamics::Geometry block = dynamics::geometry_of({.width = 0.35, .height = 1.6, .gravity = 9.81});
  MotionSamples samples{{.time = 0.0, .horizontal = 0.1, .vertical = 0.0},
                        {.time = 1.0, .horizontal = -0.4, .vertical = 0.0}};
  EXPECT_DOUBLE_EQ(least_uplift_scale(samples, block.tangents()).value(), 0.35 / 1.6 / 0.4);
  samples[0].vertical = -2.0;  // k 0.1 > (B/H) (1 - 2 k)
  EXPECT_DOUBLE_EQ(least_uplift_scale(samples, block.tangents()).value(), 0.35 / 1.6 / (0.1 + 2.0 * 0.35 / 1.6));
  samples = {{.time = 0.0, .horizontal = 0.1, .vertical = 1.0}, {.time = 1.0, .horizontal = 0.0, .vertical = 0.0}};
  EXPECT_FALSE(least_uplift_scale(samples, block.tangents()));
}

TEST(ResponseSpectrum, OfALongPushIsThatOfAStep) {
  const double a = 3.0;
  for (const double damping : {0.0, 0.05, 0.3}) {
    for (const double period : {0.013, 0.4, 1.0, 3.0}) {
      const double omega = 2.0 * pi / period;
      const double root = std::sqrt(1.0 - damping * damping);
      // After 200 periods it is at rest, without damping in its first position, so that the end adds nothing larger.
      const auto found = spectral_point(rectangle(a, 200.0 * period), 1.0, period, damping);
      expect_close(found.sd_m, a / (omega * omega) * (1.0 + std::exp(-pi * damping / root)), 1e-10);
      const double phase = std::atan2(root, damping);
      expect_close(found.sv_m_s, a / omega * std::exp(-damping * phase / root), 1e-10);
      // A/a = 1 - exp(-z w t) (cos(w_d t) - z/sqrt(1 - z^2) sin(w_d t)), which turns at twice that phase.
      expect_close(found.sa_absolute_g, a * (1.0 + std::exp(-damping * (2.0 * phase) / root)), 1e-10);
    }
  }
}

TEST(SpectralAcceleration, IsThePseudoAccelerationUnlessTheAbsoluteOneIsAskedFor) {
  // A long push on an oscillator with 5 % damping: the displacement overshoots by exp(-pi z/sqrt(1 - z^2)), the absolute
  // acceleration by the exponential of the later time at which it turns.
  const double a = 0.3;
  const double damping = 0.05;
  const double root = std::sqrt(1.0 - damping * damping);
  const double pseudo = a * (1.0 + std::exp(-pi * damping / root));
  const double absolute = a * (1.0 + std::exp(-2.0 * std::atan2(root, damping) * damping / root));
  EXPECT_GT(absolute - pseudo, 1e-3);
  for (const double period : {0.05, 0.5, 3.0}) {
    const auto push = rectangle(a, 200.0 * period);
    expect_close(spectral_acceleration(push, period, OscillatorAcceleration::pseudo), pseudo, 1e-10);
    expect_close(spectral_acceleration(push, period, OscillatorAcceleration::absolute), absolute, 1e-10);
    expect_close(average_spectral_acceleration(push, 0.5 * period, period), pseudo, 1e-10);
  }
}

TEST(ResponseSpectrum, OfAShortPushIsThatOfFreeVibrationAfterIt) {
  const double a = 2.0;
  const double length = 0.1;
  for (const double period : {0.25, 0.5, 1.0, 5.0}) {  // the push ends before half a period
    const double omega = 2.0 * pi / period;
    const double swing = 2.0 * a / omega * std::sin(0.5 * omega * length);  // largest velocity of the free vibration
    const auto found = spectral_point(rectangle(a, length), 1.0, period, 0.0);
    expect_close(found.sd_m, swing / omega, 1e-10);
    expect_close(found.sv_m_s, swing, 1e-10);
    expect_close(found.sa_absolute_g, omega * swing, 1e-10);
  }
}

TEST(ResponseSpectrum, OfARampIsItsOwn) {
  // a = s t: u = -s (t - sin(omega t)/omega)/omega^2, which grows; its velocity is largest at half a period.
  const double slope = 4.0;
  const double period = 0.5;
  const double omega = 2.0 * pi / period;
  const MotionSamples ramp{{.time = 0.0, .horizontal = 0.0, .vertical = 0.0},
                           {.time = 1.0, .horizontal = slope, .vertical = 0.0},
                           {.time = 1.0, .horizontal = slope, .vertical = 0.0}};
  const auto found = spectral_point(ramp, 1.0, period, 0.0);
  expect_close(found.sd_m, slope / (omega * omega), 1e-10);  // after two periods it swings about 0 with that amplitude
  expect_close(found.sv_m_s, omega * slope / (omega * omega), 1e-10);
}

TEST(ResponseSpectrum, DoesNotChangeWhereAPieceIsDivided) {
  const auto coarse = rectangle(1.5, 1.0);
  MotionSamples fine;
  for (int i = 0; i <= 37; ++i) fine.push_back({.time = i / 37.0, .horizontal = 1.5, .vertical = 0.0});
  for (const double period : {0.3, 1.0}) {
    const auto one = spectral_point(coarse, 1.0, period, 0.05);
    const auto many = spectral_point(fine, 1.0, period, 0.05);
    expect_close(many.sd_m, one.sd_m, 1e-12);
    expect_close(many.sv_m_s, one.sv_m_s, 1e-12);
    expect_close(many.sa_absolute_g, one.sa_absolute_g, 1e-12);
  }
}

/// The same by the classical Runge-Kutta method with `parts` steps in each piece, at the ends of the steps only.
SpectralPoint by_runge_kutta(const MotionSamples& samples, double period, double damping, int parts) {
  const double omega = 2.0 * pi / period;
  double u = 0.0;
  double v = 0.0;
  SpectralPoint most{.period_s = period};
  const auto piece = [&](double length, double from, double to) {
    const double h = length / parts;
    for (int i = 0; i < parts; ++i) {
      const auto rate = [&](double t, double x, double y) {
        return -(from + (to - from) * t / length) - 2.0 * damping * omega * y - omega * omega * x;
      };
      const double t = i * h;
      const double k1 = rate(t, u, v);
      const double k2 = rate(t + h / 2, u + h / 2 * v, v + h / 2 * k1);
      const double k3 = rate(t + h / 2, u + h / 2 * (v + h / 2 * k1), v + h / 2 * k2);
      const double k4 = rate(t + h, u + h * (v + h / 2 * k2), v + h * k3);
      u += h * v + h * h / 6 * (k1 + k2 + k3);
      v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      most.sd_m = std::max(most.sd_m, std::abs(u));
      most.sv_m_s = std::max(most.sv_m_s, std::abs(v));
      most.sa_absolute_g = std::max(most.sa_absolute_g, std::abs(2.0 * damping * omega * v + omega * omega * u));
    }
  };
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    piece(samples[i + 1].time - samples[i].time, samples[i].horizontal, samples[i + 1].horizontal);
  }
  piece(period, 0.0, 0.0);
  return most;
}

TEST(ResponseSpectrum, AgreesWithASeparateIntegrationOfAnIrregularMotion) {
  support::SplitMix numbers(21);
  MotionSamples samples;
  double time = 0.0;
  for (int i = 0; i < 80; ++i) {
    samples.push_back({.time = time, .horizontal = numbers.uniform(-4.0, 4.0), .vertical = 0.0});
    time += numbers.uniform(0.01, 0.05);
  }
  for (const double period : {0.05, 0.2, 0.9, 4.0}) {
    for (const double damping : {0.0, 0.05}) {
      const auto found = spectral_point(samples, 1.0, period, damping);
      const auto expected = by_runge_kutta(samples, period, damping, 4000);
      // Between two steps it misses at most (omega h)^2/8 of a peak.
      expect_close(expected.sd_m, found.sd_m, 1e-6);
      expect_close(expected.sv_m_s, found.sv_m_s, 1e-6);
      expect_close(expected.sa_absolute_g, found.sa_absolute_g, 1e-6);
      if (damping != 0.05) continue;
      const double omega = 2.0 * pi / period;
      expect_close(spectral_acceleration(samples, period, OscillatorAcceleration::pseudo),
                   omega * omega * expected.sd_m, 1e-6);
    }
  }
}

}  // namespace
