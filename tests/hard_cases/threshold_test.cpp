// Base acceleration and friction at their thresholds to the last bit: A_h psi = tan(psi), mu = tan(psi). Rounding
// decides there between rest, lift and slide. All of these must lead to the same motion, and time must advance.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"
#include "support/split_mix.hpp"

namespace rocking::dynamics {
namespace {

using support::ScriptedCoefficients;
using support::SplitMix;
using support::Stage;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr double quarter = 0.5 * std::numbers::pi;  ///< phase at which the base pushes hardest to the right

/// The double `steps` after x.
double shifted(double x, int steps) {
  const double towards = steps < 0 ? -1e300 : 1e300;
  for (int i = 0; i < std::abs(steps); ++i) x = std::nextafter(x, towards);
  return x;
}

// For a block whose height is its width times a power of two, tan(psi) cos(psi) = sin(psi) to the bit, so that the
// motion of each neighbour follows from theory. Blocks for which no amplitude gives the required peak to the bit are
// left out.
TEST(LiftOff, IsDecidedToTheBitByThePeakOfTheBaseAcceleration) {
  int exact = 0;
  for (const double height : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0}) {
    for (const int above : {-1, 0, 1}) {
      const Stage stage{.block = {.height = height}, .phase = quarter, .periods = 1};
      const double psi = stage.geometry().shape_angle;
      const double peak = shifted(stage.geometry().tangent, above);
      double amplitude = shifted(peak / psi, -4);
      for (int i = 0; i < 8 && amplitude * psi != peak; ++i) amplitude = shifted(amplitude, 1);
      if (amplitude * psi != peak) continue;
      ++exact;
      const ScriptedRun run(stage, {.amplitude_value = amplitude});
      EXPECT_EQ(run.log.story(), above == 1 ? "lift" : "") << height << " " << above;
    }
  }
  EXPECT_GE(exact, 9);
}

// If the peak exceeds tan(psi) by the relative excess x, theta'' = sin(psi) (x - Omega^2 t^2/2) near it. The block
// lifts at t = -t0, t0 = sqrt(2 x)/Omega, lands 4 t0 later at the rate -(8/3) sin(psi) (2 x)^(3/2)/Omega, and comes to
// rest at once. Rounding of the amplitude, the sine and the comparison adds at most 4 units to x.
TEST(LiftOff, WithinUlpsOfTheThresholdIsAHopOfTheClosedForm) {
  std::size_t most_steps = 0;
  double largest = 0.0;
  for (std::uint64_t seed = 0; seed < 3'000; ++seed) {
    SplitMix draw(seed);
    const double phases[] = {quarter, 3.0 * quarter, 0.0, draw.uniform(0.0, 4.0 * quarter)};
    const Stage stage{.block = {.height = std::exp2(draw.uniform(-0.5, 5.0))},
                      .frequency = std::exp2(draw.uniform(-8.0, 5.0)),
                      .phase = phases[draw.below(4)],
                      .periods = 3};
    const Geometry block = stage.geometry();
    const int above = draw.below(7) - 3;
    ScriptedCoefficients coefficients{.amplitude_value = shifted(block.tangent / block.shape_angle, above)};
    if (draw.below(2) == 0) coefficients.statics = {0.9 + block.tangent};
    ScriptedRun run(stage, coefficients);
    run.run();
    ASSERT_EQ(run.motion.termination(), Termination::reached_horizon)
        << "seed " << seed << ": " << run.log.story().substr(0, 200);
    const double excess = (std::abs(above) + 4.0) * ulp;
    const double hop = 8.0 / 3.0 * block.sine * std::pow(2.0 * excess, 1.5) / stage.frequency;
    for (const auto& event : run.log.events) {
      ASSERT_LE(std::abs(event.state.tilt_rate), hop) << "seed " << seed;
      largest = std::max(largest, std::abs(event.state.tilt_rate) / hop);
    }
    most_steps = std::max<std::size_t>(most_steps, run.counts.steps);
  }
  EXPECT_LE(most_steps, 200U) << "3 periods, 6 peaks";
  RecordProperty("largest_over_bound", std::to_string(largest));
}

/// Slip and slip rate after two periods from rest.
struct Place {
  double slip;
  double slip_rate;
  double tilt;
};

Place slid(const Stage& stage, const ScriptedCoefficients& coefficients) {
  ScriptedRun run(stage, coefficients);
  run.run();
  EXPECT_EQ(run.motion.termination(), Termination::reached_horizon) << run.log.story().substr(0, 200);
  EXPECT_EQ(run.motion.contradictions(), 0U) << run.log.story().substr(0, 200);
  double tilt = 0.0;
  for (const State& state : run.log.strobes) tilt = std::max(tilt, std::abs(state.tilt));
  return {.slip = run.log.strobes.back().slip, .slip_rate = run.log.strobes.back().slip_rate, .tilt = tilt};
}

// mu_s = tan(psi): a block that is pushed slides. With a friction one unit higher it lifts first; at the same instant
// friction does not suffice for the lift, and it slides. The instants differ by roundings, and so do slip and slip
// rate.
TEST(StaticFriction, OfTanPsiGivesTheSameSlideOnBothSides) {
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < 1'000; ++seed) {
    SplitMix draw(seed);
    const Stage stage{.block = {.height = draw.uniform(1.0, 10.0)}, .periods = 2};
    const double mu = stage.geometry().tangent;
    const double push = mu * draw.uniform(1.01, 3.0);
    const double amplitude = stage.amplitude_for(draw.below(2) == 0 ? push : -push);
    const double kinetic = mu * draw.uniform(0.0, 1.0);
    const Place exact = slid(stage, {.amplitude_value = amplitude, .statics = {mu}, .kinetics = {kinetic}});
    ASSERT_NE(exact.slip, 0.0);
    for (const int above : {-3, -2, -1, 1, 2, 3}) {
      const Place near =
          slid(stage, {.amplitude_value = amplitude, .statics = {shifted(mu, above)}, .kinetics = {kinetic}});
      ASSERT_NEAR(near.slip, exact.slip, 1e-13) << "seed " << seed << ", ulps " << above;
      ASSERT_NEAR(near.slip_rate, exact.slip_rate, 1e-13) << "seed " << seed << ", ulps " << above;
      worst = std::max({worst, std::abs(near.slip_rate - exact.slip_rate), near.tilt});
    }
  }
  RecordProperty("worst", std::to_string(worst * 1e15));
}

}  // namespace
}  // namespace rocking::dynamics
