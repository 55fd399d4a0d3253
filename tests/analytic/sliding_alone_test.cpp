// Sliding alone: blocks so squat that they neither lift nor rock, under pulses of the base, against Newmark's closed forms.

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/motion.hpp"

namespace rocking::sliding_alone {
namespace {

constexpr double g = 9.81;
constexpr double mu = 0.2;
constexpr double yield = mu * g;  ///< acceleration at which it slides [m/s^2]

/// tan(psi) = 4: no acceleration below 4 g lifts it. Friction 0.2, at rest.
Condition squat(const Excitation& excitation) {
  Condition condition;
  condition.scene.block = {.width = 2.0, .height = 0.5, .gravity = g};
  condition.scene.friction = Friction{.static_coefficient = mu, .kinetic_coefficient = mu};
  condition.scene.excitation = excitation;
  condition.horizon = {.transient_periods = 0, .sampled_periods = 10};
  return condition;
}

// --- a rectangular pulse of height A and duration T
//
// The base gains V = A T and keeps it. The block is accelerated by mu g and lags: while the pulse lasts by
// (A - mu g) T^2/2, and until its velocity has reached V, for V/(mu g) - T more, by the rest:
//
//     slip = V^2/(2 mu g) (1 - mu g/A)                                      Newmark (1965), Geotechnique 15(2) 139-160

double newmark_slip(double acceleration, double duration) {
  const double velocity = acceleration * duration;
  return velocity * velocity / (2.0 * yield) * (1.0 - yield / acceleration);
}

// A recorded motion is linear between its samples, so that the pulse has ramps of one sample. A base that accelerates more
// at every instant drags the block further: the slip lies between that of the pulses that are contained in it and contain it.
TEST(SlidingAlone, UnderARectangularPulseIsAsNewmarkSays) {
  constexpr double ramp = 1e-5;
  for (const double pga : {0.25, 0.4, 1.5}) {
    for (const double duration : {0.05, 0.3}) {
      Recorded pulse;
      const std::vector<dynamics::GroundMotionSample> samples{{0.0, 0.0, 0.0},
                                                              {1.0, 0.0, 0.0},
                                                              {1.0 + ramp, pga, 0.0},
                                                              {1.0 + duration, pga, 0.0},
                                                              {1.0 + duration + ramp, 0.0, 0.0},
                                                              {9.0, 0.0, 0.0}};
      pulse.ground_motion = std::make_shared<const GroundMotion>(GroundMotion{.samples = samples});
      const Trajectory trajectory = run(squat(pulse), 10);
      const double least = newmark_slip(pga * g, duration - ramp);
      const double most = newmark_slip(pga * g, duration + ramp);
      EXPECT_LE(least, trajectory.peaks.slip_m) << pga << ' ' << duration;
      EXPECT_GE(most, trajectory.peaks.slip_m) << pga << ' ' << duration;
      EXPECT_LT(most - least, 2e-3 * most);  // the test can tell
      EXPECT_EQ(std::abs(trajectory.peaks.final_slip_m), trajectory.peaks.slip_m);
      EXPECT_EQ(trajectory.peaks.tilt, 0.0);
    }
  }
}

// --- one cycle of a sine, A sin(w t)
//
// It slides from sin(w t1) = mu g/A on. Relative to the base
//
//     v(t) = mu g (t - t1) - (A/w) (cos(w t1) - cos(w t))                   up to v = 0, t > t1
//     x(t) = mu g (t - t1)^2/2 - (A/w) cos(w t1) (t - t1) + (A/w^2) (sin(w t) - sin(w t1))
//
// and then, where -A sin(w t) exceeds mu g at once or later, back by the same equations with the other sign. After the cycle
// the base stands still.

struct Slid {
  double peak = 0.0;
  double end = 0.0;
};

/// Slip over one phase of sliding from time t1 on, in the direction in which `sign` A sin(w t) pushes.
struct Phase {
  double amplitude, w, t1, sign;

  [[nodiscard]] double last() const { return 2.0 * pi / w; }
  // The base stands still after the cycle.
  [[nodiscard]] double base_velocity(double t) const {
    const double u = std::min(t, last());
    return sign * amplitude / w * (std::cos(w * t1) - std::cos(w * u));
  }
  [[nodiscard]] double base_path(double t) const {
    const double u = std::min(t, last());
    const double within = amplitude / w * (std::cos(w * t1) * (u - t1) - (std::sin(w * u) - std::sin(w * t1)) / w);
    return sign * within + base_velocity(last()) * (t - u);
  }
  [[nodiscard]] double velocity(double t) const { return yield * (t - t1) - base_velocity(t); }
  [[nodiscard]] double path(double t) const { return 0.5 * yield * (t - t1) * (t - t1) - base_path(t); }
  /// When it sticks: v < 0 before, v > 0 after.
  [[nodiscard]] double end() const {
    double low = t1 + 1e-6, high = t1 + 100.0 / w;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (velocity(middle) < 0.0 ? low : high) = middle;
    }
    return high;
  }
};

Slid sine_slip(double amplitude, double frequency_hz) {
  const double w = 2.0 * pi * frequency_hz;
  const double first = std::asin(yield / amplitude) / w;
  const Phase forth{amplitude, w, first, 1.0};
  const double t2 = forth.end();
  Slid slid{.peak = std::abs(forth.path(t2)), .end = forth.path(t2)};
  // It sticks while abs(A sin) stays below mu g, and slides again at once where that does not.
  const double back_from = std::max(t2, pi / w + first);
  if (back_from >= 2.0 * pi / w - first) return slid;
  const Phase back{amplitude, w, back_from, -1.0};
  slid.end -= back.path(back.end());
  slid.peak = std::max(slid.peak, std::abs(slid.end));
  return slid;
}

TEST(SlidingAlone, UnderOneCycleOfASineIsThatOfTwoPhasesOfSliding) {
  for (const double pga : {0.21, 0.3, 0.5, 1.5}) {
    for (const double frequency : {0.5, 3.0}) {
      const Pulse pulse{.shape = dynamics::PulseShape::sine,
                        .amplitude = pga,
                        .frequency_ratio = 1.0,
                        .physical_amplitude = PhysicalAmplitude{.value = pga, .unit = AccelerationUnit::gravity},
                        .physical_frequency = PhysicalFrequency{.value = frequency, .unit = FrequencyUnit::hertz}};
      const Trajectory trajectory = run(squat(pulse), 10);
      const Slid slid = sine_slip(pga * g, frequency);
      // The tolerance of a step, 1e-10, is one in Theta; some hundred steps.
      const double allowed = 1e-8 * slid.peak + 1e-10;
      EXPECT_NEAR(trajectory.peaks.slip_m, slid.peak, allowed) << pga << ' ' << frequency;
      EXPECT_NEAR(trajectory.peaks.final_slip_m, slid.end, allowed) << pga << ' ' << frequency;
    }
  }
}

}  // namespace
}  // namespace rocking::sliding_alone
