// Slender and squat blocks, from very weak excitation to a thousand times the threshold, at low and high frequencies.
// The energy balance holds within the tolerance, impacts follow the closed form, and strobe points are at the right
// phase.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "support/simulation.hpp"
#include "support/walk.hpp"

namespace rocking::dynamics {
namespace {

using support::Stage;
using ShakenBlock = support::Simulation<ConstantCoefficients>;

/// Energy and power, over m R^2 p^2, relative to the base.
struct Balance {
  double energy;
  double power;  ///< of the base acceleration and of friction
};

/// With the velocity of the centre of mass u = V - w cos(phi), v = S w sin(phi): E = (u^2 + v^2)/2 + w^2/6 + (4/3)
/// cos(phi) and dE/dtau = -(4/3) alpha u - mu_k N abs(V), N as in lib/docs/model.md, section 2.
Balance balance_of(const State& state, double alpha, double mu_k, const Geometry& block) {
  const bool rocks = state.contact == ContactState::rock || state.contact == ContactState::rock_slide;
  const double phi = block.shape_angle - std::abs(state.tilt);
  const double s = rocks ? std::sin(phi) : block.sine;
  const double c = rocks ? std::cos(phi) : block.cosine;
  const double w = rocks ? state.tilt_rate : 0.0;
  const bool slips = state.contact == ContactState::slide || state.contact == ContactState::rock_slide;
  const double u = (slips ? state.slip_rate : 0.0) - w * c;
  double normal = 4.0 / 3.0;
  if (state.contact == ContactState::rock_slide) {
    const double arm = s + state.side * state.slip_direction * mu_k * c;
    normal = (4.0 / 3.0 - w * w * c) / 3.0 / (1.0 / 3.0 + s * arm);
  }
  const double loss = slips ? mu_k * normal * std::abs(state.slip_rate) : 0.0;
  return {.energy = 0.5 * (u * u + w * w * s * s) + w * w / 6.0 + 4.0 / 3.0 * c,
          .power = -4.0 / 3.0 * alpha * u - loss};
}

/// Largest violation of the balance over the pieces of a run, divided by the allowed error of a step.
///
/// A step neglects terms of w and V below the tolerance times psi, and the same amount beyond the last two terms; the
/// errors of theta and X are these times the length of the step. The derivatives of E by w, V and theta are below 3
/// (abs(w) + abs(V)), the same, and 2 + w^2 + abs(w V). Roundings: a hundred times the size of the terms.
double worst_violation(ShakenBlock& run, const Stage& stage, double amplitude, double end) {
  const Geometry block = stage.geometry();
  double worst = 0.0;
  const auto visit = [&](const support::WalkPiece& piece) {
    double work = 0.0;
    double gross = 0.0;
    double demand = 0.0;
    for (const support::WalkNode& node : piece.nodes) {
      const double alpha = stage.base_acceleration(amplitude, node.tau);
      const double power = balance_of(node.state, alpha, piece.kinetic_friction, block).power;
      work += node.weight * power;
      gross += node.weight * (std::abs(power) + std::abs(alpha * node.state.slip_rate));
      const double w = std::abs(node.state.tilt_rate);
      const double v = std::abs(node.state.slip_rate);
      demand = std::max(demand, 6.0 * (w + v) + 2.0 + w * w + w * v);
    }
    const double before = balance_of(piece.start, 0.0, 0.0, block).energy;
    const double change = balance_of(piece.end, 0.0, 0.0, block).energy - before;
    const double bound = 2.0 * stage.tolerance * block.shape_angle * demand + 0x1p-46 * (before + gross + demand);
    worst = std::max(worst, std::abs(change - work) / bound);
  };
  EXPECT_TRUE(walk(run, end, 200'000, visit)) << "time stands still";
  return worst;
}

// --- shapes
// ------------------------------------------------------------------------------------------------------------

struct Shape {
  double height;  ///< over the width
  double restitution;
};

class FreeShape : public ::testing::TestWithParam<Shape> {};

// Between impacts the energy is constant, so that the next impact occurs at the rate after the last one; there w2 =
// delta w1, delta = 1 - (3/2) (1 + e) sin^2(psi). If delta < 0, the block turns about the same edge again. Each step
// keeps w to the tolerance.
TEST_P(FreeShape, HasTheRatesOfTheClosedFormImpactAfterImpact) {
  const auto [height, restitution] = GetParam();
  const Stage stage{
      .block = {.width = 1.0, .height = height}, .frequency = 5.0, .start = {.tilt_rate = 0.01}, .periods = 100};
  const double sine = 1.0 / std::sqrt(1.0 + height * height);
  const double delta = 1.0 - 1.5 * (1.0 + restitution) * sine * sine;
  ConstantCoefficients coefficients;
  coefficients.restitution_value = restitution;
  ShakenBlock run(stage, coefficients);
  run.run();
  std::size_t impacts = 0;
  for (const auto& event : run.log.events) {
    if (event.kind != EventKind::impact_stick) break;
    EXPECT_EQ(std::signbit(event.state.tilt_rate), std::signbit(event.state.side)) << impacts;
    // On alternating edges, or always on the same one.
    EXPECT_EQ(event.state.side, delta < 0.0 || impacts % 2 == 1 ? 1.0 : -1.0) << impacts;
    const double rate = event.state.tilt_rate;
    ++impacts;
    const double expected = 0.01 * std::pow(std::abs(delta), static_cast<double>(impacts));
    EXPECT_NEAR(std::abs(rate), expected, 4e-13 * stage.geometry().shape_angle * static_cast<double>(impacts))
        << impacts;
  }
  EXPECT_GE(impacts, 4U) << run.log.story();
  EXPECT_NE(run.motion.termination(), Termination::stopped);
  if (height < 2.0) {
    EXPECT_EQ(run.motion.state().contact, ContactState::rest) << "soon";
    EXPECT_EQ(run.log.count(EventKind::to_rest), 1U);
  }
}

std::string name_of(const ::testing::TestParamInfo<Shape>& shape) {
  return "HeightOverWidth" + std::to_string(std::lround(10.0 * shape.param.height)) + "TenthsRestitution" +
         std::to_string(std::lround(10.0 * shape.param.restitution)) + "Tenths";
}

INSTANTIATE_TEST_SUITE_P(Extremes, FreeShape,
                         ::testing::Values(Shape{50.0, 0.0}, Shape{0.8, 0.0}, Shape{0.8, 0.2}, Shape{0.6, 0.0}),
                         name_of);

TEST(SlenderAndSquatBlocks, BalanceTheirEnergyUnderShaking) {
  for (const double height : {0.6, 0.8, 50.0}) {
    for (const double mu : {0.0, 0.1, 0.5, 1.2, 5.0}) {
      for (const double over_threshold : {0.5, 1.5, 4.0}) {
        const Stage stage{.block = {.width = 1.0, .height = height}, .frequency = 6.0, .periods = 1'000'000};
        const double amplitude = stage.amplitude_for(over_threshold / height);
        ConstantCoefficients coefficients;
        coefficients.amplitude_value = amplitude;
        if (mu < 5.0) {
          coefficients.static_value = mu;
          coefficients.kinetic_value = 0.8 * mu;
        }
        ShakenBlock run(stage, coefficients);
        EXPECT_LE(worst_violation(run, stage, amplitude, 20.0), 1.0) << height << " " << mu << " " << over_threshold;
        EXPECT_NE(run.motion.termination(), Termination::stopped);
      }
    }
  }
}

// --- shaking
// -----------------------------------------------------------------------------------------------------------

constexpr std::array<double, 10> amplitudes{1e-6, 1e-3, 0.5, 1.03, 1.5, 4.0, 9.0, 30.0, 200.0, 1e3};
constexpr std::array<double, 9> frequencies{0.05, 0.2, 1.0, 3.0, 10.0, 30.0, 100.0, 250.0, 500.0};

ConstantCoefficients coefficients_of(double amplitude, int friction) {
  ConstantCoefficients coefficients;
  coefficients.amplitude_value = amplitude;
  if (friction > 0) {
    coefficients.static_value = friction == 1 ? 0.4 : 0.15;
    coefficients.kinetic_value = friction == 1 ? 0.35 : 0.15;
  }
  return coefficients;
}

TEST(AmplitudeAndFrequency, OverManyDecadesBalanceEnergyAndNeverStopTheRun) {
  double worst = 0.0;
  for (const double amplitude : amplitudes) {
    for (const double frequency : frequencies) {
      for (const int friction : {0, 1, 2}) {
        const Stage stage{.frequency = frequency, .phase = 0.5, .periods = 1'000'000};
        ShakenBlock run(stage, coefficients_of(amplitude, friction));
        const double violation = worst_violation(run, stage, amplitude, 6.0 * stage.period_length());
        EXPECT_LE(violation, 1.0) << "A_h = " << amplitude << ", Omega_h = " << frequency << ", friction " << friction;
        EXPECT_NE(run.motion.termination(), Termination::stopped);
        EXPECT_NE(run.motion.termination(), Termination::painleve);
        worst = std::max(worst, violation);
      }
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

// At the end of a run that reaches its horizon the clock is on the last strobe point: a whole number of periods after
// the start and at the same phase, to the clock's resolution.
TEST(AmplitudeAndFrequency, OverManyDecadesKeepTheStrobeOnItsPhase) {
  int reached = 0;
  for (const double amplitude : amplitudes) {
    for (const double frequency : frequencies) {
      const Stage stage{.frequency = frequency, .phase = 0.5, .periods = 20};
      ShakenBlock run(stage, coefficients_of(amplitude, 2));
      run.run();
      ASSERT_NE(run.motion.termination(), Termination::stopped) << amplitude << " " << frequency;
      if (run.motion.termination() != Termination::reached_horizon) continue;
      ++reached;
      run.motion.move_to_last_strobe();
      const Instant now = run.motion.clock().now();
      EXPECT_EQ(run.log.strobes.size(), 20U);
      EXPECT_EQ(now.period, 20) << amplitude << " " << frequency;
      EXPECT_NEAR(now.time, 0.5 / frequency, run.motion.clock().resolution()) << amplitude << " " << frequency;
    }
  }
  EXPECT_GE(reached, 80) << "mu = 0.15 slides before it rocks: it stays upright, however hard the base pushes";
}

}  // namespace
}  // namespace rocking::dynamics
