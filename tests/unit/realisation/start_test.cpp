// Start of a realisation: phase and initial state, from numbers or laws.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "rocking/realisation/start.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
const random::Draws draws_of_start(7, 0);

TEST(Start, WrapsThePhaseIntoOnePeriod) {
  for (const double phase : {0.0, 1.0, 6.28, -1.0, 7.0, -two_pi, two_pi, 100.0, -1e-20, 3.0 * two_pi, 1e6}) {
    Scene scene;
    support::harmonic(scene).phase = phase;
    const double wrapped = start_of(scene, draws_of_start).phase;
    EXPECT_GE(wrapped, 0.0) << phase;
    EXPECT_LT(wrapped, two_pi) << phase;
    EXPECT_NEAR(std::sin(wrapped), std::sin(phase), 1e-15 * std::fmax(1.0, std::abs(phase))) << phase;
    EXPECT_NEAR(std::cos(wrapped), std::cos(phase), 1e-15 * std::fmax(1.0, std::abs(phase))) << phase;
  }
}

TEST(Start, LeavesAPhaseWithinThePeriodAsItIs) {
  for (const double phase : {0.0, 1e-300, 1.0, 3.0, 6.2831853}) {
    Scene scene;
    support::harmonic(scene).phase = phase;
    EXPECT_EQ(start_of(scene, draws_of_start).phase, phase);
  }
}

TEST(Start, TurnsTiltsIntoRadians) {
  Scene scene;
  scene.initial = {.tilt = 0.5, .tilt_rate = -2.0, .slip_rate = 0.25};
  const Start start = start_of(scene, draws_of_start);
  const double psi = dynamics::geometry_of(mean_block(scene)).shape_angle;
  EXPECT_EQ(start.state.tilt, 0.5 * psi);
  EXPECT_EQ(start.state.tilt_rate, -2.0 * psi);
  EXPECT_EQ(start.state.slip_rate, 0.25);
  EXPECT_EQ(start.state.slip, 0.0);
  EXPECT_EQ(start.draws, 0U);
}

TEST(Start, DrawsEachLawFromItsOwnSource) {
  Scene scene;
  support::harmonic(scene).phase = Uniform{1.0, 3.0};
  scene.initial = {.tilt = Normal{0.1, 0.2}, .tilt_rate = Uniform{-1.0, 1.0}, .slip_rate = Normal{0.0, 2.0}};
  const double psi = dynamics::geometry_of(mean_block(scene)).shape_angle;
  for (std::uint64_t realisation = 0; realisation < 100; ++realisation) {
    const random::Draws mine(7, realisation);
    const Start start = start_of(scene, mine);
    EXPECT_EQ(start.draws, 4U);
    EXPECT_DOUBLE_EQ(start.phase, 1.0 + 2.0 * mine.uniform(random::Source::phase, 0));
    EXPECT_DOUBLE_EQ(start.state.tilt, psi * (0.1 + 0.2 * mine.standard_normal(random::Source::tilt, 0)));
    EXPECT_DOUBLE_EQ(start.state.tilt_rate, psi * (2.0 * mine.uniform(random::Source::tilt_rate, 0) - 1.0));
    EXPECT_DOUBLE_EQ(start.state.slip_rate, 2.0 * mine.standard_normal(random::Source::slip_rate, 0));
  }
}

// Each SI number is that of the realisation's own block; the sign of the tilt chooses its unit of a mixed pair.
TEST(Start, TakesNumbersInSiUnits) {
  Scene scene;
  scene.block.mass = GivenEdges{.edges = {0.3, 0.5}, .centre_height = 1.6, .radius_of_gyration = 0.9};
  scene.initial = {.tilt = -0.05, .tilt_rate = 0.2, .slip = Uniform{-0.4, 0.4}, .slip_rate = 0.25};
  scene.initial.units = {StateUnit::si, StateUnit::si, StateUnit::si, StateUnit::si};
  const Start start = start_of(scene, draws_of_start);
  const dynamics::Geometry block = start.geometry;
  const double p = block.frequency_parameter, radius = block.half_diagonal;
  EXPECT_EQ(start.state.tilt, -0.05);
  EXPECT_EQ(start.state.tilt_rate, 0.2 / p);
  EXPECT_EQ(start.state.slip, (-0.4 + 0.8 * draws_of_start.uniform(random::Source::slip, 0)) / radius);
  EXPECT_EQ(start.state.slip_rate, 0.25 / (p * radius));
  scene.initial.units.tilt = StateUnit::normalised;
  EXPECT_EQ(start_of(scene, draws_of_start).state.tilt, -0.05 * std::atan(0.5 / 1.6)) << "the right edge";
  scene.initial.units.tilt = StateUnit::degrees;
  EXPECT_DOUBLE_EQ(start_of(scene, draws_of_start).state.tilt, -0.05 * std::acos(-1.0) / 180.0);
  scene.initial.units = {.tilt = StateUnit::si};
  scene.initial.slip = 0.75;
  EXPECT_EQ(start_of(scene, draws_of_start).state.tilt_rate, 0.2 * std::atan(0.5 / 1.6)) << "the side of the tilt";
  EXPECT_EQ(start_of(scene, draws_of_start).state.slip, 0.75);
}

TEST(Start, IsDrawnAloneWhereOneQuantityIsALaw) {
  Scene scene;
  scene.initial.tilt = Uniform{-0.5, 0.5};
  EXPECT_EQ(start_of(scene, draws_of_start).draws, 1U);
  EXPECT_TRUE(is_random(scene));
  EXPECT_FALSE(is_random(Scene{}));
}

}  // namespace
}  // namespace rocking
