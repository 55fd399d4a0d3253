// Peaks of a motion: against closed forms, and against samples so dense that the parabola through a peak is resolved.

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/motion.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

Condition shaken_from(double amplitude, double tilt, std::optional<Friction> friction = std::nullopt) {
  Condition condition = support::shaken(amplitude, friction);
  condition.scene.initial.tilt = tilt;
  return condition;
}

// Released at rest it never tilts further. phi'' = sin(phi): the rate at the first impact is w^2 = 2 (cos(phi0) -
// cos(psi)), and each later one is smaller.
TEST(Peaks, OfFreeRockingAreTheInitialTiltAndTheRateOfTheFirstImpact) {
  for (const double tilt : {0.05, 0.3, 0.7, 0.95, -0.7}) {
    const Condition condition = shaken_from(0.0, tilt);
    const auto block = dynamics::geometry_of(mean_block(condition.scene));
    const PeakValues peaks = run(condition, 40).peaks;
    EXPECT_EQ(peaks.tilt, std::abs(tilt));
    const double rate = std::sqrt(2.0 * (std::cos(block.shape_angle * (1.0 - std::abs(tilt))) - block.cosine));
    EXPECT_NEAR(peaks.tilt_rate, rate / block.shape_angle, 1e-12 / std::abs(tilt)) << tilt;
    EXPECT_EQ(peaks.slip, 0.0);
  }
}

// Set off from its base at the rate w0 it turns where 1 - cos(phi) has the energy: cos(phi) = cos(psi) + w0^2/2.
TEST(Peaks, OfABlockThatIsSetOffLieWhereItsEnergySays) {
  for (const double rate : {0.1, -0.4, 0.9}) {
    Condition condition = shaken_from(0.0, 0.0);
    condition.scene.initial.tilt_rate = rate;
    const auto block = dynamics::geometry_of(mean_block(condition.scene));
    const double w = rate * block.shape_angle;
    const double tilt = block.shape_angle - std::acos(block.cosine + 0.5 * w * w);
    EXPECT_NEAR(run(condition, 30).peaks.tilt, tilt / block.shape_angle, 1e-12) << rate;
  }
}

// V = V0 - (4/3) mu_k tau until it stops: X = (3/8) V0^2/mu_k.
TEST(Peaks, OfASlipThatIsBrakedAreItsLength) {
  Condition condition = shaken_from(0.0, 0.0, Friction{.static_coefficient = 0.2, .kinetic_coefficient = 0.15});
  condition.scene.initial.slip_rate = -0.3;
  const PeakValues peaks = run(condition, 40).peaks;
  const auto block = dynamics::geometry_of(mean_block(condition.scene));
  EXPECT_NEAR(peaks.slip, 3.0 / 8.0 * 0.09 / 0.15, 1e-13);
  EXPECT_EQ(peaks.final_slip, -peaks.slip);
  EXPECT_EQ(peaks.slip_m, peaks.slip * block.half_diagonal);
  EXPECT_EQ(peaks.final_slip_m, peaks.final_slip * block.half_diagonal);
}

TEST(Peaks, OfAnOverturnedBlockEndWhereItOverturned) {
  const Condition condition = shaken_from(0.0, 1.1);
  const auto block = dynamics::geometry_of(mean_block(condition.scene));
  const Trajectory trajectory = run(condition, 40);
  ASSERT_EQ(trajectory.termination, Termination::overturned);
  EXPECT_NEAR(trajectory.peaks.tilt, 0.5 * pi / block.shape_angle, 1e-12);
}

struct PeakCase {
  std::string name;
  Condition condition;
};

std::vector<PeakCase> cases() {
  const Friction rough{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  std::vector<PeakCase> all{
      {"no sliding", shaken_from(4.5, 0.1)},
      {"barely lifts", shaken_from(1.03, 0.0)},
      {"slips", shaken_from(7.0, 0.0, rough)},
      {"slides", shaken_from(9.0, 0.0, Friction{.static_coefficient = 0.2, .kinetic_coefficient = 0.15})},
      {"friction fluctuates", shaken_from(7.0, 0.0, rough)},
      {"amplitude fluctuates", shaken_from(5.0, 0.1)},
      {"pulse", shaken_from(1.0, 0.0)}};
  support::harmonic(all[1].condition.scene).frequency_ratio = 2.0;
  all[4].condition.scene.fluctuation.static_friction = all[4].condition.scene.fluctuation.kinetic_friction = 0.03;
  all[4].condition.scene.fluctuation.refreshes_per_period = 200;
  all[5].condition.scene.fluctuation.amplitude = 0.5;
  all[6].condition.scene.excitation =
      Pulse{.shape = dynamics::PulseShape::ricker, .amplitude = 4.0, .frequency_ratio = 5.0};
  return all;
}

double largest(const Trajectory& trajectory, const std::function<double(const HistorySample&)>& value) {
  double most = 0.0;
  for (const HistorySample& sample : trajectory.history) most = std::max(most, std::abs(value(sample)));
  for (const TrajectoryEvent& event : trajectory.events) {
    most = std::max(most, std::abs(value({.tau = event.tau,
                                          .tilt = event.tilt,
                                          .tilt_rate = event.tilt_rate,
                                          .slip = event.slip,
                                          .slip_rate = event.slip_rate,
                                          .contact = {},
                                          .base_acceleration = 0.0})));
  }
  return most;
}

// Between samples d apart a peak is missed by at most max abs(f'') d^2/8, and by abs(f') d before an impact. With
// abs(Theta'') < 30, abs(Theta''') < 300 and abs(V) < 3 in these motions.
TEST(Peaks, AreThoseOfDenseSamples) {
  constexpr int samples = 2000;
  for (const PeakCase& one : cases()) {
    const Trajectory trajectory = trajectory_of(one.condition, 7, 3, {20, samples});
    const double frequency = support::mean_frequency_ratio(one.condition.scene);
    const double d = 2.0 * pi / frequency / samples;
    const double tilt = largest(trajectory, [](const HistorySample& sample) { return sample.tilt; });
    const double rate = largest(trajectory, [](const HistorySample& sample) { return sample.tilt_rate; });
    const double slip = largest(trajectory, [](const HistorySample& sample) { return sample.slip; });
    constexpr double rounding = 1e-13;
    EXPECT_GE(trajectory.peaks.tilt, tilt - rounding) << one.name;
    EXPECT_LE(trajectory.peaks.tilt, tilt + 30.0 * d * d / 8.0) << one.name;
    EXPECT_GE(trajectory.peaks.tilt_rate, rate - rounding) << one.name;
    EXPECT_LE(trajectory.peaks.tilt_rate, rate + 30.0 * d) << one.name << ": before an impact";
    EXPECT_GE(trajectory.peaks.slip, slip - rounding) << one.name;
    EXPECT_LE(trajectory.peaks.slip, slip + 3.0 * d) << one.name;
    EXPECT_EQ(trajectory.peaks.final_slip, trajectory.strobe.back().slip) << one.name;
  }
}

// At the instant of a smooth peak the rate vanishes: a peak found at a wrong instant would be too low by the square of
// the error. A tighter tolerance has shorter steps, in which the peaks lie elsewhere.
TEST(Peaks, DoNotDependOnTheStepsInWhichTheyLie) {
  for (const PeakCase& one : cases()) {
    Condition finer = one.condition;
    Condition coarser = one.condition;
    finer.tolerance = 1e-15;
    coarser.tolerance = 1e-11;
    // Two periods: the errors of the motion itself have not grown yet.
    const PeakValues a = trajectory_of(finer, 7, 3, 2).peaks;
    const PeakValues b = trajectory_of(coarser, 7, 3, 2).peaks;
    EXPECT_NEAR(a.tilt, b.tilt, 1e-9) << one.name;
    EXPECT_NEAR(a.tilt_rate, b.tilt_rate, 1e-9) << one.name;
    EXPECT_NEAR(a.slip, b.slip, 1e-9) << one.name;
  }
}

}  // namespace
}  // namespace rocking
