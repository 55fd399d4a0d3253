// One realisation: what it depends on, what it does not depend on, and what it counts.

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

using dynamics::EventKind;

Condition fifty_periods(double amplitude) {
  Condition condition = support::shaken(amplitude);
  condition.horizon = {.transient_periods = 20, .sampled_periods = 30};
  return condition;
}

Condition with_friction(Condition condition, double mu_s, double mu_k) {
  condition.scene.friction = Friction{.static_coefficient = mu_s, .kinetic_coefficient = mu_k};
  return condition;
}

Condition fluctuating(Condition condition, double sigma) {
  condition.scene.fluctuation.static_friction = sigma;
  condition.scene.fluctuation.kinetic_friction = sigma;
  return condition;
}

std::uint64_t draws_of(const OperationCounts& operations) {
  return operations.static_friction_draws + operations.kinetic_friction_draws + operations.restitution_draws +
         operations.amplitude_draws + operations.initial_draws;
}

void expect_same_bits(const Trajectory& a, const Trajectory& b) {
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    ASSERT_EQ(a.events[i].kind, b.events[i].kind) << i;
    ASSERT_EQ(a.events[i].tau, b.events[i].tau) << i;
    ASSERT_EQ(a.events[i].tilt_rate, b.events[i].tilt_rate) << i;
  }
  ASSERT_EQ(a.strobe.size(), b.strobe.size());
  for (std::size_t i = 0; i < a.strobe.size(); ++i) {
    ASSERT_EQ(a.strobe[i].tilt, b.strobe[i].tilt) << i;
    ASSERT_EQ(a.strobe[i].tilt_rate, b.strobe[i].tilt_rate) << i;
    ASSERT_EQ(a.strobe[i].slip, b.strobe[i].slip) << i;
  }
}

TEST(Realisation, IsAPureFunctionOfItsArguments) {
  const Condition condition = fluctuating(with_friction(fifty_periods(4.5), 0.35, 0.3), 0.03);
  const RealisationResult first = realise(condition, 1, 5);
  static_cast<void>(realise(condition, 2, 7));
  const RealisationResult again = realise(condition, 1, 5);
  EXPECT_EQ(digest_of(first, 5), digest_of(again, 5));
  EXPECT_NE(digest_of(first, 5), digest_of(realise(condition, 1, 6), 5)) << "another realisation, other draws";
  EXPECT_NE(digest_of(first, 5), digest_of(realise(condition, 2, 5), 5)) << "another seed, other draws";
}

TEST(Realisation, WithFrictionThatNeverGivesWayHasTheBitsOfOneWithout) {
  for (const double amplitude : {1.5, 4.2, 6.6, 9.0}) {
    const Condition without = fifty_periods(amplitude);
    const Condition with = with_friction(without, 5.0, 1.0);
    expect_same_bits(trajectory_of(with, 0, 0, 50), trajectory_of(without, 0, 0, 50));
    const RealisationResult result = realise(with, 0, 0);
    EXPECT_EQ(result.operations.slip_steps, 0U);
    EXPECT_EQ(result.operations.steps, realise(without, 0, 0).operations.steps);
  }
}

TEST(Realisation, DrawsNothingWhereNothingIsRandom) {
  for (const Condition& condition : {fifty_periods(4.2), with_friction(fifty_periods(7.0), 0.4, 0.35)}) {
    const RealisationResult result = realise(condition, 0, 0);
    EXPECT_EQ(draws_of(result.operations), 0U);
    EXPECT_EQ(digest_of(result, 0), digest_of(realise(condition, 99, 0), 0)) << "the seed says nothing";
  }
}

TEST(Realisation, WithoutFrictionComputesNothingOfSliding) {
  const RealisationResult result = realise(fifty_periods(5.0), 0, 0);
  EXPECT_EQ(result.operations.slip_steps, 0U);
  for (const EventKind kind : {EventKind::slip_start, EventKind::slide_start, EventKind::impact_slip}) {
    EXPECT_EQ(result.operations.events[static_cast<std::size_t>(kind)], 0U);
  }
}

TEST(Realisation, ThatNeverSlipsDrawsNoKineticFriction) {
  const RealisationResult result = realise(fluctuating(with_friction(fifty_periods(4.2), 5.0, 1.0), 0.03), 0, 0);
  EXPECT_EQ(result.operations.slip_steps, 0U);
  EXPECT_EQ(result.operations.kinetic_friction_draws, 0U);
  EXPECT_EQ(result.operations.static_friction_draws, 1U) << "the value at the start";
  EXPECT_EQ(result.clamps.kinetic_at_static + result.clamps.kinetic_at_zero, 0U);
}

TEST(Realisation, CountsWhatItsTrajectoryShows) {
  const Condition condition = with_friction(fifty_periods(7.0), 0.4, 0.35);
  const RealisationResult result = realise(condition, 0, 0);
  const Trajectory trajectory = trajectory_of(condition, 0, 0, 50);
  OperationCounts shown;
  for (const TrajectoryEvent& event : trajectory.events) ++shown.events[static_cast<std::size_t>(event.kind)];
  EXPECT_EQ(result.operations.events, shown.events);
  ASSERT_EQ(result.strobe.size(), 50U);
  for (std::size_t k = 0; k < 50; ++k) {
    EXPECT_EQ(result.strobe[k].tilt, trajectory.strobe[k].tilt) << k;
    EXPECT_EQ(result.strobe[k].tilt_rate, trajectory.strobe[k].tilt_rate) << k;
  }
  EXPECT_GT(result.operations.slip_steps, 0U);
  EXPECT_LT(result.operations.slip_steps, result.operations.steps);
}

TEST(Realisation, DrawsKineticFrictionAtMostOnceAnInterval) {
  const RealisationResult result = realise(fluctuating(with_friction(fifty_periods(7.0), 0.35, 0.3), 0.03), 3, 0);
  EXPECT_GT(result.operations.kinetic_friction_draws, 50U);
  EXPECT_LE(result.operations.kinetic_friction_draws, 50U * 200U);
  EXPECT_GT(result.operations.static_friction_draws, 1U);
}

/// Largest distance of the strobe points of two results over the first periods.
double distance(const RealisationResult& a, const RealisationResult& b, std::size_t periods) {
  double largest = 0.0;
  for (std::size_t k = 0; k < periods; ++k) {
    largest = std::fmax(largest, std::abs(a.strobe.at(k).tilt - b.strobe.at(k).tilt));
    largest = std::fmax(largest, std::abs(a.strobe.at(k).tilt_rate - b.strobe.at(k).tilt_rate));
    largest = std::fmax(largest, std::abs(a.strobe.at(k).slip_rate - b.strobe.at(k).slip_rate));
  }
  return largest;
}

// Another tolerance makes other steps, but has common random numbers at the same instants: the motions differ by the
// error of the steps only, while independent random numbers make them diverge.
TEST(Replay, AtAnotherToleranceHasCommonRandomNumbers) {
  Condition slides = fluctuating(with_friction(fifty_periods(7.0), 0.2, 0.15), 0.01);  // slides all the time: no chaos
  Condition finer = slides;
  slides.tolerance = 1e-9;
  finer.tolerance = 1e-13;
  for (std::uint64_t realisation = 0; realisation < 10; ++realisation) {
    const RealisationResult result = realise(slides, 1, realisation);
    EXPECT_LT(distance(result, realise(finer, 1, realisation), 50), 1e-7) << realisation;
    EXPECT_GT(distance(result, realise(slides, 1, realisation + 100), 50), 1e-4) << realisation;
  }
}

TEST(Replay, AtAnotherToleranceSeesTheSameRestitutionAndAmplitude) {
  Condition condition = fifty_periods(3.0);
  condition.scene.fluctuation.restitution = 0.1;
  condition.scene.fluctuation.amplitude = 0.2;
  Condition finer = condition;
  condition.tolerance = 1e-11;
  for (std::uint64_t realisation = 0; realisation < 10; ++realisation) {
    const RealisationResult result = realise(condition, 1, realisation);
    EXPECT_LT(distance(result, realise(finer, 1, realisation), 8), 1e-6) << realisation;
    EXPECT_GT(distance(result, realise(condition, 1, realisation + 100), 8), 1e-3) << realisation;
  }
}

// While it slides without a stop, V = V0 - (4/3)(sum of mu_k d + base): the strobe points show the friction in force.
// Another amplitude, inertia or rule of impact does not change it.
TEST(Replay, AtAnotherAmplitudeOrFormulationSeesTheSameFriction) {
  Condition condition = fluctuating(with_friction(fifty_periods(1.0), 0.2, 0.15), 0.01);
  condition.scene.initial.slip_rate = 20.0;
  Condition other = condition;
  support::harmonic(other.scene).amplitude = 3.0;
  other.scene.slide_inertia = dynamics::SlideInertia::edge;
  other.scene.impact_slip_rule = dynamics::ImpactSlipRule::signed_ratio;
  const RealisationResult a = realise(condition, 5, 2);
  const RealisationResult b = realise(other, 5, 2);
  // V at whole periods does not depend on the base, only on friction.
  EXPECT_LT(distance(a, b, 50), 1e-11);
  EXPECT_GT(a.strobe.back().slip_rate, 0.0) << "it slides to the end";
  EXPECT_EQ(a.operations.kinetic_friction_draws, b.operations.kinetic_friction_draws);
}

TEST(Replay, WithAPhaseKeepsTheGridAtTheStart) {
  Condition condition = fluctuating(with_friction(fifty_periods(0.0), 0.2, 0.15), 0.01);
  condition.scene.initial.slip_rate = 20.0;
  Condition shifted = condition;
  support::harmonic(shifted.scene).phase = 2.0;
  const Trajectory a = trajectory_of(condition, 5, 2, 20);  // a whole number of periods from the start, in both
  const Trajectory b = trajectory_of(shifted, 5, 2, 20);
  for (std::size_t k = 0; k < 20; ++k) EXPECT_NEAR(a.strobe.at(k).slip_rate, b.strobe.at(k).slip_rate, 1e-12) << k;
}

TEST(Classification, OfARunThatOverturnsHasNoReason) {
  const RealisationResult result = realise(fifty_periods(20.0), 0, 0);
  EXPECT_EQ(result.termination, dynamics::Termination::overturned);
  EXPECT_EQ(result.classification.mode.kind, section::ResponseKind::overturned);
  EXPECT_EQ(result.classification.reason, std::nullopt);
}

TEST(Realisation, SaysToWhichSideItOverturned) {
  Condition still = fifty_periods(0.0);
  for (const auto& [tilt, side] : {std::pair(1.5, dynamics::Side::left), std::pair(-1.5, dynamics::Side::right)}) {
    still.scene.initial.tilt = tilt;
    EXPECT_EQ(realise(still, 1, 0).overturned_side, side) << tilt;
  }
  still.scene.initial.tilt = 0.5;
  EXPECT_FALSE(realise(still, 1, 0).overturned_side);
}

TEST(Classification, AfterAGroundMotionTellsWhetherTheBlockEverMoved) {
  Condition condition = fifty_periods(1.0);
  condition.scene.excitation = support::recorded_by({.samples = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}}}, 10.0);
  EXPECT_EQ(realise(condition, 0, 0).classification.reason, section::Reason::never_moved);
  condition.scene.initial.tilt = 0.1;
  condition.horizon.sampled_periods = 300;
  const RealisationResult result = realise(condition, 0, 0);
  EXPECT_EQ(result.classification.mode.kind, section::ResponseKind::rest);
  EXPECT_EQ(result.classification.reason, section::Reason::came_to_rest);
}

TEST(Classification, AfterAGroundMotionTellsASlideFromRest) {
  Condition condition = with_friction(fifty_periods(1.0), 0.2, 0.15);
  condition.scene.block = {.width = 1.0, .height = 1.0};
  condition.scene.excitation =
      support::recorded_by({.samples = {{0.0, 0.0, 0.0}, {0.1, 0.5, 0.0}, {0.6, 0.5, 0.0}, {0.7, 0.0, 0.0}}}, 10.0);
  condition.horizon.sampled_periods = 300;
  const RealisationResult slid = realise(condition, 0, 0);
  EXPECT_EQ(to_string(slid.classification.mode), "slide");
  EXPECT_EQ(slid.classification.reason, section::Reason::came_to_rest);
  EXPECT_GT(slid.peaks.slip_m, 0.1);
  EXPECT_EQ(slid.peaks.tilt, 0.0);
  condition.scene.initial.tilt = 0.1;
  const RealisationResult rocked = realise(condition, 0, 0);
  EXPECT_EQ(to_string(rocked.classification.mode), "rest") << "it has slid, too";
  EXPECT_GT(rocked.peaks.slip_m, 0.1);
}

TEST(DivergencePeriod, IsTheFirstPeriodWithPointsApart) {
  RealisationResult a;
  RealisationResult b;
  a.strobe = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.5, 0.0, 0.0}};
  b.strobe = {{0.0, 0.01, 0.0}, {0.1, 0.0101, 0.0}, {0.5, 0.0, 0.0}};
  EXPECT_EQ(divergence_period(a, b), 2) << "0.01 itself is not apart";
  EXPECT_EQ(divergence_period(a, a), std::nullopt);
  b.strobe = {{0.0, 0.0, 0.0}, {0.1, 0.0, 5.0}};
  EXPECT_EQ(divergence_period(a, b), 3) << "one has ended; the slip rate does not count";
}

}  // namespace
}  // namespace rocking
