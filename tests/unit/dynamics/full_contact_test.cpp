// Rest and slide: each row of the event table (lib/docs/model.md, section 3) and each way to leave full contact. The
// reference block throughout: H/B = 4, tan(psi) = 0.25.

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"

namespace rocking::dynamics {
namespace {

using support::quarter;
using support::ScriptedCoefficients;
using support::Stage;
using support::three_quarters;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

/// Amplitude of a base acceleration with this peak [g].
double peak(double acceleration) { return Stage{}.amplitude_for(acceleration); }

/// A block that slides at tau = 0.
Stage sliding(double slip_rate, double phase) { return {.phase = phase, .start = {.slip_rate = slip_rate}}; }

/// Direction of the first push; the same tests are made for both.
class EitherWay : public testing::TestWithParam<double> {
 protected:
  [[nodiscard]] static double push() { return GetParam(); }
  [[nodiscard]] static double phase() { return push() > 0.0 ? quarter : three_quarters; }
};

class Rest : public EitherWay {};
class Slide : public EitherWay {};

constexpr auto name_of = [](const auto& instance) { return instance.param > 0.0 ? "ToTheRight" : "ToTheLeft"; };
INSTANTIATE_TEST_SUITE_P(Push, Rest, testing::Values(1.0, -1.0), name_of);
INSTANTIATE_TEST_SUITE_P(Push, Slide, testing::Values(1.0, -1.0), name_of);

TEST_P(Rest, HoldsBelowBothThresholds) {
  ScriptedRun run({.periods = 20}, {.amplitude_value = push() * peak(0.2499), .statics = {0.2499001}});
  EXPECT_EQ(run.run().log.story(), "");
  EXPECT_EQ(run.log.strobes.back().contact, ContactState::rest);
}

TEST_P(Rest, SlidesWhereFrictionGivesWayFirst) {
  ScriptedRun run({}, {.amplitude_value = push() * peak(0.3), .statics = {0.2}, .kinetics = {0.15}});
  run.run();
  ASSERT_FALSE(run.log.events.empty());
  const auto& first = run.log.events.front();
  EXPECT_EQ(first.kind, EventKind::slide_start);
  EXPECT_NEAR(first.tau, std::asin(0.2 / 0.3) / 10.0, 1e-15);
  EXPECT_EQ(first.state.contact, ContactState::slide);
  EXPECT_EQ(first.state.slip_rate, 0.0);
  EXPECT_EQ(first.state.slip_direction, -push()) << "the block lags behind the base";
}

TEST_P(Rest, LiftsWhereTheEdgeGivesWayFirst) {
  ScriptedRun run({}, {.amplitude_value = push() * peak(0.3), .statics = {0.9}, .kinetics = {0.2}});
  run.run();
  ASSERT_FALSE(run.log.events.empty());
  const auto& first = run.log.events.front();
  EXPECT_EQ(first.kind, EventKind::lift);
  EXPECT_NEAR(first.tau, std::asin(0.25 / 0.3) / 10.0, 1e-15);
  EXPECT_EQ(first.state.contact, ContactState::rock);
  EXPECT_EQ(first.state.side, push());
}

TEST_P(Rest, WithoutFrictionLiftsAtTanPsi) {
  ScriptedRun run({}, {.amplitude_value = push() * peak(0.3)});
  run.run();
  ASSERT_FALSE(run.log.events.empty());
  EXPECT_EQ(run.log.events.front().kind, EventKind::lift);
  EXPECT_NEAR(run.log.events.front().tau, std::asin(0.25 / 0.3) / 10.0, 1e-15);
}

// theta'' = 0 at the threshold: theta grows as alpha' cos(psi) tau^3/6. There must be no false impact while tau^3 is of
// the size of a rounding.
TEST_P(Rest, LiftsAtTheThresholdWithoutFallingBackByRounding) {
  for (const double excess : {1e-9, 1e-6, 1e-3, 0.1, 1.0}) {
    ScriptedRun run({}, {.amplitude_value = push() * peak(0.25 * (1.0 + excess))});
    run.run();
    ASSERT_GE(run.log.events.size(), 2U) << excess;
    EXPECT_EQ(run.log.events[0].kind, EventKind::lift) << excess;
    EXPECT_GT(run.log.events[1].tau - run.log.events[0].tau, 1e-6) << excess;
    EXPECT_GT(std::abs(run.log.events[1].state.tilt_rate), 0.0) << excess;
  }
}

TEST_P(Rest, JumpsToSlideAtOnceWhereFrictionIsBelowTanPsi) {
  ScriptedRun run({.phase = phase()}, {.amplitude_value = peak(0.3), .statics = {0.25}, .kinetics = {0.1}});
  EXPECT_EQ(run.log.story(), "slide_start") << "before any step is made";
  EXPECT_EQ(run.log.events.at(0).tau, 0.0);
  EXPECT_EQ(run.motion.state().slip_direction, -push());
}

// With a base acceleration of 1, a block that lifts requires abs(F)/N = 0.6275/1.5098 = 0.4156.
TEST_P(Rest, JumpsToRockWhereFrictionCarriesTheLift) {
  ScriptedRun run({.phase = phase()}, {.amplitude_value = peak(1.0), .statics = {0.416}, .kinetics = {0.1}});
  EXPECT_EQ(run.log.story(), "lift");
  EXPECT_EQ(run.motion.state().side, push());
  EXPECT_EQ(run.motion.state().contact, ContactState::rock);
}

TEST_P(Rest, JumpsToRockSlideWhereFrictionFailsButKineticFrictionTips) {
  ScriptedRun run({.phase = phase()}, {.amplitude_value = peak(1.0), .statics = {0.415}, .kinetics = {0.2501}});
  EXPECT_EQ(run.log.story(), "lift slip_start");
  EXPECT_EQ(run.log.events.at(1).tau, 0.0);
  EXPECT_EQ(run.motion.state().contact, ContactState::rock_slide);
  EXPECT_EQ(run.motion.state().side, push());
  EXPECT_EQ(run.motion.state().slip_direction, -push());
  run.run();
  EXPECT_GT(push() * run.log.strobes.back().tilt, -0.3) << "it went on";
}

TEST_P(Rest, JumpsToSlideWhereFrictionFailsAndKineticFrictionDoesNotTip) {
  ScriptedRun run({.phase = phase()}, {.amplitude_value = peak(1.0), .statics = {0.415}, .kinetics = {0.25}});
  EXPECT_EQ(run.log.story(), "slide_start");
  EXPECT_EQ(run.motion.state().slip_direction, -push());
}

// V' = 0 at the onset if mu_k = mu_s: V = -(4/3)(A (cos(u0) - cos(u))/Omega - mu (tau - tau0)) exactly.
TEST_P(Slide, StartsWithVanishingAccelerationWhereKineticFrictionIsTheStaticOne) {
  for (const double acceleration : {0.2001, 0.21, 0.3, 1.0}) {
    ScriptedRun run({}, {.amplitude_value = push() * peak(acceleration), .statics = {0.2}, .kinetics = {0.2}});
    run.run();
    ASSERT_GE(run.log.events.size(), 2U) << acceleration;
    EXPECT_EQ(run.log.events[0].kind, EventKind::slide_start) << acceleration;
    const auto& stop = run.log.events[1];
    EXPECT_TRUE(stop.kind == EventKind::slide_stop || stop.kind == EventKind::slip_reverse) << acceleration;
    const double u0 = 10.0 * run.log.events[0].tau;
    const double u = 10.0 * stop.tau;
    EXPECT_GT(u - u0, 1e-3) << "no false stop at the start, " << acceleration;
    EXPECT_NEAR(acceleration * (std::cos(u0) - std::cos(u)), 0.2 * (u - u0), 1e-12) << acceleration;
  }
}

TEST_P(Slide, EndsInRestWhereTheBaseIsStill) {
  const double start = push() * 0.01;
  ScriptedRun run(sliding(start, 0.0), {.statics = {0.22}, .kinetics = {0.2}});
  run.run();
  EXPECT_EQ(run.log.story(), "slide_stop");
  const double deceleration = 4.0 / 3.0 * 0.2;
  EXPECT_NEAR(run.log.events[0].tau, 0.01 / deceleration, 1e-15);
  EXPECT_NEAR(run.log.events[0].state.slip, push() * 0.5 * 0.01 * 0.01 / deceleration, 1e-17);
  EXPECT_EQ(run.log.events[0].state.slip_rate, 0.0);
  EXPECT_EQ(run.log.strobes.back().contact, ContactState::rest);
  EXPECT_EQ(run.motion.coefficients().stops, 1U);
}

TEST_P(Slide, ReversesWhereTheBaseStillPushes) {
  ScriptedRun run(sliding(push() * 1e-3, phase()), {.amplitude_value = peak(0.3), .statics = {0.2}, .kinetics = {0.1}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::slip_reverse) << "one event, not slide_stop and slide_start";
  EXPECT_EQ(run.log.events[0].state.slip_direction, -push());
  EXPECT_EQ(run.log.events[0].state.contact, ContactState::slide);
}

// The base pushes in the direction of the slide, but not enough: the block stops. The new static friction cannot hold
// it, and it continues in the same direction.
TEST_P(Slide, GoesOnTheSameWayWhereTheNewFrictionCannotHold) {
  ScriptedRun run(sliding(-push() * 1e-3, phase()),
                  {.amplitude_value = peak(0.1), .statics = {0.22, 0.05}, .kinetics = {0.2}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::slip_reverse);
  EXPECT_EQ(run.log.events[0].state.slip_direction, -push()) << "the direction it had";
}

TEST_P(Slide, StopsWithTheNewFrictionNotTheOld) {
  ScriptedRun run(sliding(push() * 1e-3, phase()),
                  {.amplitude_value = peak(0.2), .statics = {0.1, 0.24}, .kinetics = {0.05}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::slide_stop) << "0.1 would not have held against 0.2";
}

TEST_P(Slide, LiftsAtItsEndWhereTheNewFrictionCarriesIt) {
  ScriptedRun run(sliding(push() * 1e-3, phase()),
                  {.amplitude_value = peak(0.3), .statics = {0.2, 0.9}, .kinetics = {0.1}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::lift) << run.log.story();
  EXPECT_EQ(run.log.events[0].state.side, push());
  EXPECT_EQ(run.log.count(EventKind::slide_stop), 0U);
  EXPECT_EQ(run.motion.coefficients().stops, 1U);
}

TEST_P(Slide, LiftsAndSlipsAtItsEndWhereTheNewKineticFrictionTips) {
  ScriptedRun run(sliding(push() * 1e-3, phase()),
                  {.amplitude_value = peak(1.0), .statics = {0.2, 0.4}, .kinetics = {0.3}});
  run.run();
  ASSERT_GE(run.log.events.size(), 2U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::lift) << run.log.story();
  EXPECT_EQ(run.log.events[1].kind, EventKind::slip_start) << run.log.story();
  EXPECT_EQ(run.log.events[1].tau, run.log.events[0].tau);
}

TEST_P(Slide, TipsAtOnceWhereKineticFrictionIsAboveTanPsi) {
  ScriptedRun run(sliding(push() * 0.5, 0.0), {.statics = {0.4}, .kinetics = {0.2501}});
  EXPECT_EQ(run.log.story(), "tip");
  EXPECT_EQ(run.motion.state().side, -push()) << "over its leading edge";
  EXPECT_EQ(run.motion.state().slip_rate, push() * 0.5);
  run.run();
  EXPECT_LT(push() * run.log.strobes.back().tilt, 0.0);
}

TEST_P(Slide, TipsAtTheInstantOfTheNewDraw) {
  const Instant change{.period = 0, .time = 0.0625};
  ScriptedRun run(sliding(push() * 0.5, 0.0), {.statics = {0.5}, .kinetics = {0.2, 0.3, 0.2}, .changes = {change}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::tip);
  EXPECT_EQ(run.log.events[0].tau, 0.0625);
  EXPECT_NEAR(run.log.events[0].state.slip_rate, push() * (0.5 - 4.0 / 3.0 * 0.2 * 0.0625), 1e-15);
  EXPECT_EQ(run.log.events[0].state.contact, ContactState::rock_slide);
  EXPECT_EQ(run.motion.coefficients().stops, 0U) << "tipping is no stop";
}

TEST_P(Slide, IsSteadyWhereKineticFrictionChangesBelowTanPsi) {
  ScriptedRun run(sliding(push() * 0.5, 0.0),
                  {.statics = {0.5}, .kinetics = {0.2, 0.1}, .changes = {{.period = 0, .time = 0.25}}});
  run.run();
  EXPECT_EQ(run.log.story(), "");
  const double length = 0.2 * std::numbers::pi;
  const double loss = 4.0 / 3.0 * (0.2 * 0.25 + 0.1 * (length - 0.25));
  EXPECT_NEAR(run.log.strobes.back().slip_rate, push() * (0.5 - loss), 1e-15);
}

TEST_P(Slide, NeverLiftsHoweverHardTheBasePushes) {
  ScriptedRun run({}, {.amplitude_value = push() * peak(2.0), .statics = {0.24}, .kinetics = {0.2}});
  run.run();
  EXPECT_EQ(run.log.count(EventKind::lift) + run.log.count(EventKind::tip), 0U);
  EXPECT_EQ(run.log.count(EventKind::slide_start), 1U);
}

}  // namespace
}  // namespace rocking::dynamics
