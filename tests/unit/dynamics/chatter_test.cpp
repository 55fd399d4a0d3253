// How a block comes to rest: infinitely many impacts in finite time, ended at the tolerance (lib/docs/model.md, section
// 3). H/B = 4 throughout, tan(psi) = 0.25.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "rocking/dynamics/impact.hpp"
#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"

namespace rocking::dynamics {
namespace {

using support::LoggedEvent;
using support::psi;
using support::ScriptedCoefficients;
using support::Stage;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

/// Duration of a hop that starts at `rate` on a base at rest: phi'' = sin(phi), from phi = psi up and back.
///
/// With cos(phi) = 1 - 2 sin^2(phi/2) and sin(phi/2) = k cosh(x), the rise time is that of a pendulum. Here it is the
/// series in rate/sin(psi), whose next term is of fifth order.
double hop_time(double rate) {
  const Geometry block = Stage{}.geometry();
  const double x = rate / block.sine;
  return 2.0 * x * (1.0 + block.cosine * x * x / 3.0);
}

const LoggedEvent* find(const support::EventLog& log, EventKind kind) {
  for (const LoggedEvent& event : log.events) {
    if (event.kind == kind) return &event;
  }
  return nullptr;
}

// The rates decrease by Housner's ratio: the remaining time after an impact is a geometric series up to the cubic
// terms.
TEST(Chatter, EndsBeforeTheLimitOfTheGeometricSeriesByNoMoreThanIsDocumented) {
  const Geometry block = Stage{}.geometry();
  const double ratio = 1.0 - 1.5 * block.sine * block.sine;
  const double rate = 1e-4;
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-13}) {
    const Stage stage{.tolerance = tolerance, .start = {.tilt_rate = rate}};
    ScriptedRun run(stage, {});
    run.run();
    const LoggedEvent* end = find(run.log, EventKind::to_rest);
    ASSERT_NE(end, nullptr) << tolerance;
    double limit = 0.0;
    for (double w = rate; w > 1e-25; w *= ratio) limit += hop_time(w);
    const LoggedEvent& last_impact = *(end - 1);
    EXPECT_EQ(end->tau, last_impact.tau) << "the instant is the last impact's";
    const double documented = 2.0 * std::abs(last_impact.state.tilt_rate) / ((1.0 - ratio) * block.sine);
    const double rounding = 1e-15;
    EXPECT_LE(end->tau, limit + rounding) << tolerance;
    EXPECT_LE(limit - end->tau, documented * (1.0 + 1e-6) + rounding) << tolerance;
    EXPECT_LE(documented, std::max(tolerance, 0x1p-49 * stage.period_length()) / (1.0 - ratio)) << tolerance;
    EXPECT_EQ(end->state.tilt_rate, 0.0);
    EXPECT_EQ(end->state.contact, ContactState::rest);
  }
}

TEST(Chatter, StaysAtRestAfterIt) {
  ScriptedRun run({.start = {.tilt_rate = 1e-3}, .periods = 5}, {.statics = {0.5}, .kinetics = {0.4}});
  run.run();
  EXPECT_EQ(run.log.count(EventKind::to_rest), 1U);
  EXPECT_EQ(run.log.events.back().kind, EventKind::to_rest);
  EXPECT_EQ(run.log.strobes.back().contact, ContactState::rest);
  EXPECT_EQ(run.motion.coefficients().chatters, 1U);
  EXPECT_EQ(run.motion.coefficients().stops, 0U);
}

// Under a steady push alpha the hops last 2 w/(sin(psi) - S alpha cos(psi)): longer on the side to which it pushes.
TEST(Chatter, UnderASteadyPushHasTheDocumentedTimeError) {
  const Geometry block = Stage{}.geometry();
  const double ratio = 1.0 - 1.5 * block.sine * block.sine;
  const double alpha = 0.2;
  const double rate = 1e-6;
  const Stage stage{
      .frequency = 1e-6, .phase = 0.5 * std::numbers::pi, .tolerance = 1e-9, .start = {.tilt_rate = rate}};
  ScriptedRun run(stage, {.amplitude_value = stage.amplitude_for(alpha)});
  for (int step = 0; step < 10'000 && find(run.log, EventKind::to_rest) == nullptr; ++step) {
    integrate::LoopCounts counts;
    const double length = run.motion.expand(run.motion.time_to_breakpoint());
    const auto [time, fired] =
        integrate::first_crossing(run.motion, length, integrate::uncleared_guards(run.motion, length), counts);
    run.motion.move(time);
    run.motion.reset(fired, false);
  }
  const LoggedEvent* end = find(run.log, EventKind::to_rest);
  ASSERT_NE(end, nullptr);
  double limit = 0.0;
  double side = 1.0;
  for (double w = rate; w > 1e-25; w *= ratio, side = -side) {
    limit += 2.0 * w / (block.sine - side * alpha * block.cosine);
  }
  const double documented =
      2.0 * std::abs((end - 1)->state.tilt_rate) / ((1.0 - ratio) * (block.sine - alpha * block.cosine));
  EXPECT_NEAR(limit, end->tau, documented * (1.0 + 1e-6) + 1e-6 * limit * 1e-3);
  EXPECT_LE(end->tau, limit * (1.0 + 1e-9));
}

TEST(Chatter, DropsNoMoreThanTheEnergyOfAHopBelowTheTolerance) {
  for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
    const Stage stage{.tolerance = tolerance, .start = {.tilt_rate = 1e-3}};
    ScriptedRun run(stage, {});
    run.run();
    const LoggedEvent* end = find(run.log, EventKind::to_rest);
    ASSERT_NE(end, nullptr);
    const double rate = std::abs((end - 1)->state.tilt_rate);
    const double pull = stage.geometry().sine;
    EXPECT_LE(2.0 * rate / pull, tolerance) << "duration";
    EXPECT_LE(rate * rate / (2.0 * pull), tolerance * psi) << "height";
    EXPECT_GT(std::abs((end - 2)->state.tilt_rate) * 2.0 / pull, tolerance) << "not cut off any earlier";
  }
}

TEST(Chatter, OfASlippingBlockEndsInSlide) {
  for (const double direction : {1.0, -1.0}) {
    ScriptedRun run({.start = {.tilt_rate = 1e-3, .slip_rate = direction}, .periods = 20},
                    {.statics = {0.2}, .kinetics = {0.15}});
    run.run();
    const LoggedEvent* end = find(run.log, EventKind::to_slide);
    ASSERT_NE(end, nullptr) << run.log.story();
    EXPECT_EQ(end->state.contact, ContactState::slide);
    EXPECT_EQ(end->state.slip_direction, direction);
    EXPECT_EQ(end->state.slip_rate, (end - 1)->state.slip_rate) << "X and V are kept";
    EXPECT_EQ(end->state.slip, (end - 1)->state.slip);
    EXPECT_EQ(run.log.events.back().kind, EventKind::slide_stop);
    EXPECT_EQ(run.motion.coefficients().chatters, 1U);
    EXPECT_EQ(run.motion.coefficients().stops, 1U) << "the end of the slide; entering it is no stop";
  }
}

// While it slips, a block with mu_k > tan(psi) turns over its leading edge and does not come to full contact.
TEST(Chatter, DoesNotEndInSlideWhereKineticFrictionTips) {
  ScriptedRun run({.start = {.tilt_rate = -1e-3, .slip_rate = 1.0}}, {.statics = {0.4}, .kinetics = {0.3}});
  run.run();
  EXPECT_EQ(run.log.count(EventKind::to_slide), 0U);
}

TEST(Chatter, IsFollowedBySlideAtOnceWhereTheNewFrictionDoesNotHold) {
  const Stage stage{
      .frequency = 1e-3, .phase = 0.5 * std::numbers::pi, .tolerance = 1e-9, .start = {.tilt_rate = 1e-6}};
  ScriptedRun run(stage, {.amplitude_value = stage.amplitude_for(0.15),
                          .statics = {0.9},
                          .static_after_chatter = 0.14,
                          .kinetics = {0.1}});
  run.run();
  const LoggedEvent* end = find(run.log, EventKind::to_rest);
  ASSERT_NE(end, nullptr) << run.log.story().substr(0, 200);
  ASSERT_LT(end, &run.log.events.back());
  EXPECT_EQ((end + 1)->kind, EventKind::slide_start);
  EXPECT_EQ((end + 1)->tau, end->tau);
}

// mu_k in force depends on mu_s: 0.2 while the old static friction limits it, 0.3 > tan(psi) under the new one. A slide
// cannot begin with that.
TEST(Chatter, ThatEndsInSlideTipsAtOnceWhereTheNewFrictionDoes) {
  ScriptedRun run({.start = {.tilt_rate = 1e-3, .slip_rate = 1.0}},
                  {.statics = {0.2}, .static_after_chatter = 0.5, .kinetics = {0.3}});
  run.run();
  const LoggedEvent* end = find(run.log, EventKind::to_slide);
  ASSERT_NE(end, nullptr) << run.log.story().substr(0, 200);
  ASSERT_LT(end, &run.log.events.back());
  EXPECT_EQ((end + 1)->kind, EventKind::tip) << run.log.story().substr(0, 200);
  EXPECT_EQ((end + 1)->tau, end->tau);
}

// An impact with w2 = 0 exactly, with slip and mu_k > tan(psi): the block tips over its leading edge. It must not land
// at the same instant again and again.
TEST(Chatter, ThatIsOneImpactGoesOnWhereKineticFrictionTips) {
  const Geometry block = Stage{}.geometry();
  const double mu_k = 0.3;
  const double q = block.sine * block.sine + mu_k * block.sine * block.cosine;  // sigma s2 = +1
  const double e = 0.5 * (1.0 / (3.0 * q) - 1.0);                               // delta = 0 except for rounding
  for (int ulp = -8; ulp <= 8; ++ulp) {
    const double restitution = e + ulp * 0x1p-53;
    const ImpactConditions before{
        .tilt_rate = 0.01, .slip_rate = 1.0, .restitution = restitution, .static_friction = 0.31};
    if (slipping_impact(before, mu_k, block).tilt_rate != 0.0) continue;
    ScriptedRun run({.start = {.tilt = -1e-17, .tilt_rate = 0.01, .slip_rate = 1.0}},
                    {.statics = {0.31}, .kinetics = {mu_k}, .restitutions = {restitution, 0.0}});
    run.run();
    EXPECT_EQ(run.motion.termination(), Termination::reached_horizon) << run.log.story().substr(0, 200);
    EXPECT_EQ(run.log.events.at(0).kind, EventKind::impact_slip);
    EXPECT_EQ(run.log.events.at(0).state.tilt_rate, 0.0);
    EXPECT_LT(run.counts.steps, 1'000U);
    return;
  }
  FAIL() << "no restitution gives delta = 0 to the bit";
}

}  // namespace
}  // namespace rocking::dynamics
