// Rock and rock-slide: onset, end and reversal of slip, impacts, stops, and the order of simultaneous events
// (lib/docs/model.md, sections 3 and 5). H/B = 4 unless stated.

#include <cmath>

#include <gtest/gtest.h>

#include "rocking/dynamics/forces.hpp"
#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"

namespace rocking::dynamics {
namespace {

using support::LoggedEvent;
using support::psi;
using support::ScriptedCoefficients;
using support::Stage;
using support::three_quarters;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

/// Friction over N that rocking without slip requires right after an event.
double demand_after(const LoggedEvent& event, const Stage& stage, double amplitude) {
  const double alpha = stage.base_acceleration(amplitude, event.tau);
  const Forces forces = rocking_forces(event.state, {.horizontal = alpha, .weight = 1.0},
                                       equation_constants(stage.setting(), event.state.side));
  return forces.friction / forces.normal;
}

TEST(Rock, StartsToSlipWhereFrictionIsExhaustedAgainstTheForce) {
  int found = 0;
  for (int i = 0; i < 80; ++i) {
    const double amplitude = (i % 2 == 0 ? 1.0 : -1.0) * (3.0 + 0.1 * i);
    const Stage stage{.periods = 5};
    ScriptedRun run(stage, {.amplitude_value = amplitude, .statics = {0.35}, .kinetics = {0.3}});
    run.run();
    const auto& events = run.log.events;
    for (std::size_t k = 1; k < events.size(); ++k) {
      if (events[k].kind != EventKind::slip_start) continue;
      const double demand = demand_after(events[k], stage, amplitude);
      EXPECT_EQ(events[k].state.slip_direction, demand < 0.0 ? 1.0 : -1.0);
      EXPECT_EQ(events[k].state.slip_rate, 0.0);
      if (events[k - 1].tau == events[k].tau) {
        EXPECT_GT(std::abs(demand), 0.35) << "by a jump of the force, A_h = " << amplitude;
      } else {
        EXPECT_NEAR(std::abs(demand), 0.35, 1e-11) << "as a root, A_h = " << amplitude;
        ++found;
      }
    }
  }
  EXPECT_GT(found, 20);
}

// mu_k = mu_s: at the onset V' = 0 too, and V grows with the square of time. The slip must neither stop at once nor
// reverse.
TEST(Rock, SlipsOnWhereKineticFrictionIsTheStaticOne) {
  int found = 0;
  for (int i = 0; i < 80; ++i) {
    const double amplitude = (i % 2 == 0 ? 1.0 : -1.0) * (3.0 + 0.1 * i);
    ScriptedRun run({.periods = 5}, {.amplitude_value = amplitude, .statics = {0.35}, .kinetics = {0.35}});
    run.run();
    const auto& events = run.log.events;
    for (std::size_t k = 1; k + 1 < events.size(); ++k) {
      if (events[k].kind != EventKind::slip_start || events[k - 1].tau == events[k].tau) continue;
      ++found;
      EXPECT_GT(events[k + 1].tau - events[k].tau, 1e-5) << "A_h = " << amplitude << ", event " << k;
      if (events[k + 1].state.slip_rate != 0.0 && events[k + 1].kind == EventKind::past_balance) {
        EXPECT_GT(events[k + 1].state.slip_rate * events[k].state.slip_direction, 0.0) << "A_h = " << amplitude;
      }
    }
  }
  EXPECT_GT(found, 20);
}

/// Slip to the right on the left edge, about to stop; sticking would require F/N = -0.070 at V = 0.
Stage slip_about_to_stop() { return {.phase = three_quarters, .start = {.tilt = 0.5 * psi, .slip_rate = 1e-3}}; }

TEST(RockSlide, SticksWhereFrictionHolds) {
  ScriptedRun run(slip_about_to_stop(),
                  {.amplitude_value = Stage{}.amplitude_for(0.6), .statics = {0.5}, .kinetics = {0.4}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::slip_stop);
  EXPECT_EQ(run.log.events[0].state.contact, ContactState::rock);
  EXPECT_EQ(run.log.events[0].state.slip_rate, 0.0);
}

TEST(RockSlide, GoesOnTheSameWayWhereTheNewFrictionCannotHold) {
  const Stage stage = slip_about_to_stop();
  const double amplitude = stage.amplitude_for(0.6);
  ScriptedRun run(stage, {.amplitude_value = amplitude, .statics = {0.5, 0.05}, .kinetics = {0.4}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::slip_reverse);
  EXPECT_NEAR(demand_after(run.log.events[0], stage, amplitude), -0.07, 0.01);
  EXPECT_EQ(run.log.events[0].state.slip_direction, 1.0) << "the direction it had";
  EXPECT_GE(run.motion.coefficients().stops, 1U);
}

TEST(RockSlide, ReversesWhereTheForceOnItTurnsItBack) {
  Stage stage = slip_about_to_stop();
  stage.start.slip_rate = -1e-3;  // the force at V = 0 then pushes it to the right
  const double amplitude = stage.amplitude_for(0.6);
  ScriptedRun run(stage, {.amplitude_value = amplitude, .statics = {0.05}, .kinetics = {0.04}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::slip_reverse);
  EXPECT_EQ(run.log.events[0].state.slip_direction, 1.0);
}

// From Theta0 at rest: w1^2 = 2 (cos(phi0) - cos(psi)), then Housner's ratio at each impact.
TEST(Impact, OfFreeRockingHasTheRatesOfTheEnergyAndHousnersRatio) {
  const Stage stage{.start = {.tilt = 0.5 * psi}, .periods = 20};
  const Geometry block = stage.geometry();
  for (const double e : {0.0, 0.3, -0.3}) {
    ScriptedRun run(stage, {.restitutions = {e}});
    run.run();
    double rate = std::sqrt(2.0 * (std::cos(0.5 * psi) - block.cosine));
    double side = 1.0;
    for (std::size_t k = 0; k < 5; ++k) {
      rate *= 1.0 - 1.5 * (1.0 + e) * block.sine * block.sine;
      side = -side;
      ASSERT_GT(run.log.events.size(), k);
      EXPECT_EQ(run.log.events[k].kind, EventKind::impact_stick);
      EXPECT_NEAR(run.log.events[k].state.tilt_rate, side * rate, 1e-13);
      EXPECT_EQ(run.log.events[k].state.side, side);
      EXPECT_EQ(run.log.events[k].state.tilt, 0.0);
    }
  }
}

TEST(Impact, PlaysOneRestitutionAfterTheOther) {
  const Stage stage{.start = {.tilt = 0.5 * psi}, .periods = 10};
  ScriptedRun run(stage, {.restitutions = {0.5, -0.5, 0.0}});
  run.run();
  const double sine = stage.geometry().sine;
  double rate = std::sqrt(2.0 * (std::cos(0.5 * psi) - stage.geometry().cosine));
  for (const double e : {0.5, -0.5, 0.0}) {
    rate *= 1.0 - 1.5 * (1.0 + e) * sine * sine;
    const std::size_t k = e == 0.5 ? 0 : e == -0.5 ? 1 : 2;
    EXPECT_NEAR(std::abs(run.log.events.at(k).state.tilt_rate), rate, 1e-13) << "e = " << e;
  }
  EXPECT_EQ(run.motion.coefficients().impacts,
            run.log.count(EventKind::impact_stick) + run.log.count(EventKind::impact_slip));
}

// Free rocking near theta = 0 requires sin cos/(4/3 - sin^2) = 3 tan(psi)/(4 + tan^2(psi)) = 0.1846, as much as its
// impacts.
TEST(Rock, FreeAndSmallNeedsAsMuchFrictionAsItsImpacts) {
  for (const double mu : {0.1845, 0.1847}) {
    ScriptedRun run({.start = {.tilt_rate = 1e-3}}, {.statics = {mu}, .kinetics = {0.5 * mu}});
    run.run();
    ASSERT_GE(run.log.events.size(), 1U);
    EXPECT_EQ(run.log.events[0].kind, mu < 0.1846 ? EventKind::slip_start : EventKind::impact_stick) << "mu = " << mu;
  }
}

// delta = 1 - 1.5 sin^2(psi) < 0 for psi > 0.955: the block turns about the same edge again.
TEST(Impact, OfASquatBlockPutsItBackOverTheSameEdge) {
  const Stage stage{.block = {.width = 2.0, .height = 1.0}, .start = {.tilt = 0.1}, .periods = 2};
  ScriptedRun run(stage, {});
  run.run();
  ASSERT_GE(run.log.events.size(), 2U);
  const double ratio = 1.0 - 1.5 * 0.8;
  const double rate = std::sqrt(2.0 * (std::cos(stage.geometry().shape_angle - 0.1) - stage.geometry().cosine));
  EXPECT_EQ(run.log.events[0].kind, EventKind::impact_stick);
  EXPECT_NEAR(run.log.events[0].state.tilt_rate, -ratio * rate, 1e-14);
  EXPECT_EQ(run.log.events[0].state.side, 1.0);
  EXPECT_EQ(run.log.events[1].state.side, 1.0);
}

/// Slip during the landing; friction determines whether the impact sticks.
Stage landing_with_slip() { return {.start = {.tilt = 1e-3 * psi, .tilt_rate = -0.2, .slip_rate = 0.01}}; }

TEST(Stop, IsAnImpactThatEndsASlip) {
  ScriptedRun run(landing_with_slip(), {.statics = {0.9}, .kinetics = {0.1}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::impact_stick) << run.log.story();
  EXPECT_EQ(run.log.count(EventKind::slip_stop), 0U) << "said by the impact";
  EXPECT_EQ(run.motion.coefficients().stops, 1U) << "the impact only: later ones come without slip";
}

TEST(Stop, HasItsOwnFrictionInTheImpactAndTheNextOneRightAfter) {
  ScriptedRun run(landing_with_slip(), {.statics = {0.9, 0.01}, .kinetics = {0.005}});
  run.run();
  ASSERT_GE(run.log.events.size(), 2U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::impact_stick) << "0.9 holds in the impact";
  EXPECT_EQ(run.log.events[1].kind, EventKind::slip_start) << "0.01 does not hold after it";
  EXPECT_EQ(run.log.events[1].tau, run.log.events[0].tau);
}

TEST(Stop, IsNotASlippingImpact) {
  Stage stage = landing_with_slip();
  stage.start.slip_rate = 2.0;
  stage.periods = 1;
  ScriptedRun run(stage, {.statics = {0.05}, .kinetics = {0.04}});
  run.run();
  EXPECT_GE(run.log.count(EventKind::impact_slip), 1U);
  EXPECT_EQ(run.log.count(EventKind::impact_stick) + run.log.count(EventKind::slip_stop), 0U);
  EXPECT_EQ(run.motion.coefficients().stops, 0U);
}

TEST(Stop, IsNotASlippingImpactThatTurnsTheSlipAround) {
  ScriptedRun run({.start = {.tilt = 1e-6 * psi, .tilt_rate = -0.5, .slip_rate = -0.01}},
                  {.statics = {0.15}, .kinetics = {0.01}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  ASSERT_EQ(run.log.events[0].kind, EventKind::impact_slip);
  EXPECT_GT(run.log.events[0].state.slip_rate, 0.0) << "V has changed sign in the impact";
  EXPECT_EQ(run.motion.coefficients().stops,
            run.log.count(EventKind::slip_stop) + run.log.count(EventKind::slip_reverse) +
                run.log.count(EventKind::impact_stick) + run.log.count(EventKind::slide_stop));
}

TEST(Stop, IsNotAStickingImpactOfABlockThatDidNotSlip) {
  ScriptedRun run({.start = {.tilt = 0.5 * psi}, .periods = 20}, {.statics = {0.9}, .kinetics = {0.1}});
  run.run();
  EXPECT_GE(run.log.count(EventKind::impact_stick), 2U);
  EXPECT_EQ(run.motion.coefficients().stops, 0U);
}

// Both roots lie within the time resolution: the landing comes first and ends the slip; one stop, no slip_stop.
TEST(OneInstant, OfImpactAndStopIsOneImpactAndOneStop) {
  ScriptedRun run({.start = {.tilt = 1e-17, .tilt_rate = -0.1, .slip_rate = 1e-17}},
                  {.statics = {0.9}, .kinetics = {0.5}});
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::impact_stick) << run.log.story();
  EXPECT_EQ(run.log.events[0].state.tilt, 0.0);
  EXPECT_EQ(run.log.events[0].state.slip_rate, 0.0);
  EXPECT_EQ(run.log.count(EventKind::slip_stop) + run.log.count(EventKind::slip_reverse), 0U);
  EXPECT_EQ(run.motion.coefficients().stops, 1U);
}

/// The first slipping impact, with kinetic friction changing at `change`.
LoggedEvent first_slipping_impact(const Instant& change) {
  ScriptedRun run({.start = {.tilt = 0.2 * psi, .tilt_rate = -0.1, .slip_rate = 1.0}},
                  {.statics = {0.3}, .kinetics = {0.1, 0.2}, .changes = {change}});
  run.run();
  for (const LoggedEvent& event : run.log.events) {
    if (event.kind == EventKind::impact_slip) return event;
  }
  ADD_FAILURE() << "no slipping impact: " << run.log.story();
  return run.log.events.front();
}

TEST(OneInstant, OfRedrawAndImpactHasTheNewFrictionInTheImpact) {
  const LoggedEvent late = first_slipping_impact({.period = 5, .time = 0.0});
  const double tau = late.tau;  // with mu_k = 0.1 throughout
  const LoggedEvent before = first_slipping_impact({.period = 0, .time = tau - 1e-9});
  const LoggedEvent after = first_slipping_impact({.period = 0, .time = tau + 1e-9});
  EXPECT_GT(std::abs(before.state.slip_rate - after.state.slip_rate), 1e-4) << "the two differ";
  EXPECT_EQ(after.state.slip_rate, late.state.slip_rate);
  for (const double offset : {0.0, 0x1p-53, -0x1p-53}) {
    const LoggedEvent at = first_slipping_impact({.period = 0, .time = tau + offset});
    EXPECT_NEAR(at.tau, tau, 1e-15);
    EXPECT_NEAR(at.state.slip_rate, before.state.slip_rate, 1e-8);
    EXPECT_NEAR(at.state.tilt_rate, before.state.tilt_rate, 1e-8);
  }
}

}  // namespace
}  // namespace rocking::dynamics
