// Friction at the ends of its range: none, kinetic equal to static, and 4/3, where the equations of rock-slide lose
// their solution.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"
#include "support/split_mix.hpp"
#include "support/walk.hpp"

namespace rocking::dynamics {
namespace {

using support::ScriptedCoefficients;
using support::SplitMix;
using support::Stage;
using support::WalkPiece;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

const ScriptedCoefficients no_friction{.statics = {0.0}, .kinetics = {0.0}};

// Without friction a block in full contact does not move in space: V = V0 + (4/3) A (cos(Omega tau + Phi) -
// cos(Phi))/Omega, through any number of stops. A period has about ten steps, two of them with a stop; each costs a few
// roundings of the terms.
TEST(NoFriction, LeavesABlockAtItsPlaceInSpaceThroughAllReversals) {
  double worst = 0.0;
  std::size_t reversals = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SplitMix draw(seed);
    const double phases[] = {0.0, 0.5 * std::numbers::pi, std::numbers::pi, draw.uniform(0.0, 6.28)};
    Stage stage{
        .frequency = draw.uniform(1.0, 20.0), .phase = phases[draw.below(4)], .tolerance = 1e-17, .periods = 50};
    const double peak = draw.uniform(0.01, 3.0);
    if (draw.below(2) == 0) stage.start.slip_rate = draw.uniform(-0.5, 0.5) * peak / stage.frequency;
    ScriptedCoefficients coefficients = no_friction;
    coefficients.amplitude_value = stage.amplitude_for(peak);
    ScriptedRun run(stage, coefficients);
    run.run();
    ASSERT_EQ(run.motion.termination(), Termination::reached_horizon) << "seed " << seed;
    const double swing = 4.0 / 3.0 * peak / stage.frequency;
    for (std::size_t k = 0; k < run.log.strobes.size(); ++k) {  // a whole number of periods after tau = 0
      const double error = std::abs(run.log.strobes[k].slip_rate - stage.start.slip_rate);
      worst = std::max(worst, error / swing);
      ASSERT_LE(error, 32.0 * static_cast<double>(k + 1) * 0x1p-52 * swing) << "seed " << seed << ", period " << k;
    }
    reversals += run.log.count(EventKind::slip_reverse);
  }
  EXPECT_GT(reversals, 4'000U);
  RecordProperty("worst", std::to_string(worst * 1e15));
}

// Without a horizontal force the base motion has no effect on the tilt. (1/6 + sin^2(phi)/2) w^2 + (4/3) cos(phi) is
// constant between impacts. Each impact slips and multiplies the rate by (1 - 3 q)/(1 + 3 q), q = sin^2(psi). V - w
// cos(phi) follows the base throughout.
TEST(NoFriction, KeepsShakingFromTheTiltAndTheMomentumThroughImpacts) {
  double worst_rate = 0.0;
  double worst_momentum = 0.0;
  for (const double height : {2.0, 4.0, 8.0}) {
    for (const double amplitude : {0.0, 1.0, 5.0, 20.0}) {
      Stage stage{.block = {.height = height}, .periods = 20};
      const Geometry block = stage.geometry();
      stage.start.tilt = 0.4 * block.shape_angle;
      ScriptedCoefficients coefficients = no_friction;
      coefficients.amplitude_value = amplitude;
      ScriptedRun run(stage, coefficients);
      run.run();
      const double q = block.sine * block.sine;
      double rate = std::sqrt(4.0 / 3.0 * (std::cos(0.6 * block.shape_angle) - block.cosine) / (1.0 / 6.0 + 0.5 * q));
      const testing::ScopedTrace trace(__FILE__, __LINE__, std::to_string(height) + " " + std::to_string(amplitude));
      std::size_t impacts = 0;
      for (const auto& event : run.log.events) {
        if (event.kind != EventKind::impact_slip || impacts == 5) continue;
        ++impacts;
        rate *= (1.0 - 3.0 * q) / (1.0 + 3.0 * q);
        // Tolerance of the steps, 1e-13 psi, about ten of them per hop.
        EXPECT_NEAR(std::abs(event.state.tilt_rate), rate, 10.0 * 1e-13) << "impact " << impacts;
        worst_rate = std::max(worst_rate, std::abs(std::abs(event.state.tilt_rate) - rate));
        const double base = 4.0 / 3.0 * amplitude * block.shape_angle / stage.frequency;
        const double momentum = event.state.slip_rate - event.state.tilt_rate * block.cosine;
        EXPECT_NEAR(momentum, base * (std::cos(stage.frequency * event.tau) - 1.0), 1e-12 * (1.0 + base));
        worst_momentum =
            std::max(worst_momentum, std::abs(momentum - base * (std::cos(stage.frequency * event.tau) - 1.0)));
      }
      EXPECT_GE(impacts, 4U) << run.log.story().substr(0, 200);
    }
  }
  RecordProperty("worst", std::to_string(worst_rate * 1e15) + " " + std::to_string(worst_momentum * 1e15));
}

State after_a_period(double amplitude, double mu_s, double mu_k) {
  ScriptedRun run({.periods = 1}, {.amplitude_value = amplitude, .statics = {mu_s}, .kinetics = {mu_k}});
  run.run();
  EXPECT_EQ(run.motion.contradictions(), 0U) << amplitude;
  return run.log.strobes.back();
}

// mu_k = mu_s is handled separately: V' = 0 at the onset of slip. It is the limit of mu_k < mu_s: the difference
// between the two motions halves with mu_s - mu_k.
TEST(KineticFriction, OfTheStaticOneIsTheLimitOfLess) {
  int slipped = 0;
  int compared = 0;
  for (int i = 0; i < 60; ++i) {
    const double amplitude = (i % 2 == 0 ? 1.0 : -1.0) * (2.0 + 0.17 * i);
    for (const double mu : {0.2, 0.35, 0.6}) {
      const State limit = after_a_period(amplitude, mu, mu);
      if (limit.slip == 0.0) continue;
      ++slipped;
      const double far = after_a_period(amplitude, mu, mu * (1.0 - 0x1p-20)).slip - limit.slip;
      const double near = after_a_period(amplitude, mu, mu * (1.0 - 0x1p-21)).slip - limit.slip;
      // The next order is 2^-20 of it times the second derivative; rounding is 1e-13 of at least 1e-8.
      if (std::abs(near) > 1e-9) {
        ++compared;
        EXPECT_NEAR(far / near, 2.0, 1e-2) << "A_h = " << amplitude << ", mu = " << mu;
      }
      EXPECT_LT(std::abs(near), 1e-5) << "A_h = " << amplitude << ", mu = " << mu;
    }
  }
  EXPECT_GT(slipped, 60);
  EXPECT_GT(compared, 60);
}

/// A block tilted over its left edge that slips to the left on a base at rest: rock-slide with S s = -1. Its
/// determinant D is smallest, J + 1/2 - sqrt(1 + mu_k^2)/2, at phi = atan(mu_k)/2. The block passes this angle as it
/// turns over.
struct ThrownOver {
  Stage stage{};
  double mu_k;

  [[nodiscard]] double edge_angle(const State& state) const { return stage.geometry().shape_angle - state.tilt; }

  /// V - w cos(phi) + s mu_k (w sin(phi) + (4/3) tau): constant whatever N is, because friction is mu_k N.
  [[nodiscard]] double momentum(const State& state, double tau) const {
    const double phi = edge_angle(state);
    return state.slip_rate - state.tilt_rate * std::cos(phi) -
           mu_k * (state.tilt_rate * std::sin(phi) + 4.0 / 3.0 * tau);
  }

  [[nodiscard]] double energy(const State& state) const {
    const double phi = edge_angle(state);
    const double x = state.slip_rate - state.tilt_rate * std::cos(phi);
    const double y = state.tilt_rate * std::sin(phi);
    return 0.5 * (x * x + y * y + state.tilt_rate * state.tilt_rate / 3.0) + 4.0 / 3.0 * std::cos(phi);
  }

  /// Whether N, proportional to 4/3 - w^2 cos(phi), is > 0 throughout. If N < 0, in the fall, friction would accelerate
  /// the slip.
  [[nodiscard]] bool presses(const WalkPiece& piece) const {
    return std::all_of(piece.nodes.begin(), piece.nodes.end(), [this](const support::WalkNode& node) {
      return node.state.tilt_rate * node.state.tilt_rate * std::cos(edge_angle(node.state)) < 4.0 / 3.0;
    });
  }

  [[nodiscard]] double determinant(const State& state) const {
    const double phi = edge_angle(state);
    return 1.0 / 3.0 + std::sin(phi) * (std::sin(phi) - mu_k * std::cos(phi));
  }
};

ThrownOver thrown_over(double height, double tilt, double excess) {
  return {.stage = {.block = {.height = height}, .start = {.tilt = tilt, .slip_rate = -6.0}, .periods = 1'000'000'000},
          .mu_k = 4.0 / 3.0 * (1.0 + excess)};
}

ScriptedCoefficients rough(double mu_k) { return {.statics = {2.0}, .kinetics = {mu_k}}; }

// mu_k below 4/3 by a relative 2^-2 to 2^-32: the smallest D is 1e-10, and the solution exists throughout. Rounding in
// N is multiplied by 1/D, but not in the momentum, since friction is proportional to N. Allowed: some hundred steps
// with a rounding of 6 + 4 mu_k each.
TEST(BelowPainleve, IsPassedWithMomentumKeptAndEnergyLost) {
  double worst = 0.0;
  for (const double height : {1.2, 1.5}) {
    for (const double tilt : {0.01, 0.06}) {
      for (int k = 2; k <= 32; k += 6) {
        const ThrownOver block = thrown_over(height, tilt, -std::ldexp(1.0, -k));
        const testing::ScopedTrace trace(__FILE__, __LINE__, std::to_string(height) + ", 2^-" + std::to_string(k));
        ScriptedRun run(block.stage, rough(block.mu_k));
        double least = 1.0;
        double departure = 0.0;
        const bool arrived = support::walk(run, 3.0, 100'000, [&](const WalkPiece& piece) {
          departure = std::max(departure, std::abs(block.momentum(piece.end, piece.end_tau) + 6.0));
          least = std::min(least, block.determinant(piece.end));
          for (const auto& node : piece.nodes) least = std::min(least, block.determinant(node.state));
          if (block.presses(piece)) {
            EXPECT_LE(block.energy(piece.end), block.energy(piece.start) + 1e-12);
          }
        });
        ASSERT_TRUE(arrived);
        EXPECT_EQ(run.motion.termination(), Termination::overturned);
        EXPECT_LE(departure, 100.0 * 0x1p-52 * (6.0 + 4.0 * block.mu_k));
        const double closed_form = 5.0 / 6.0 - 0.5 * std::sqrt(1.0 + block.mu_k * block.mu_k);
        const bool passes = 0.5 * std::atan(block.mu_k) < block.stage.geometry().shape_angle - tilt;
        if (passes) {
          EXPECT_NEAR(least, closed_form, 1e-2 * closed_form + 1e-15);
        }
        worst = std::max(worst, departure);
      }
    }
  }
  RecordProperty("worst", std::to_string(worst * 1e15));
}

// Above 4/3 D becomes zero on the way: the run ends there with the reason.
TEST(AbovePainleve, EndsWhereTheDeterminantVanishes) {
  for (const double height : {1.2, 1.5}) {
    for (int k = 6; k <= 16; k += 2) {
      const ThrownOver block = thrown_over(height, 0.01, std::ldexp(1.0, -k));
      ScriptedRun run(block.stage, rough(block.mu_k));
      run.run();
      EXPECT_EQ(run.motion.termination(), Termination::painleve) << height << ", 2^-" << k;
      EXPECT_NEAR(block.determinant(run.motion.state()), 0.0, 1e-14) << height << ", 2^-" << k;
    }
  }
}

// At exactly 4/3 neither is possible: the steps shrink with D. The run ends in one of the ways that are counted.
TEST(AtPainleve, EndsInACountedWayWithinTheBudget) {
  const ThrownOver block = thrown_over(1.5, 0.01, 0.0);
  ScriptedRun run(block.stage, rough(block.mu_k));
  run.run();
  const Termination end = run.motion.termination().value();
  EXPECT_TRUE(end == Termination::painleve || end == Termination::stopped) << to_string(end);
  EXPECT_LE(run.counts.steps, 1'000'001U);
  EXPECT_TRUE(std::isfinite(run.motion.state().tilt_rate));
}

}  // namespace
}  // namespace rocking::dynamics
