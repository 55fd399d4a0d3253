// Limits of the model, and terminations of a realisation (lib/docs/model.md, sections 3 and 7).

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <gtest/gtest.h>

#include "rocking/dynamics/impact.hpp"
#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"

namespace rocking::dynamics {
namespace {

using support::psi;
using support::ScriptedCoefficients;
using support::Stage;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

TEST(Overturning, IsTerminalAndPassesTheBalanceOnce) {
  for (const double side : {1.0, -1.0}) {
    ScriptedRun run({.start = {.tilt = side * 0.9 * psi, .tilt_rate = side * 0.5 * psi}, .periods = 30}, {});
    run.run();
    EXPECT_EQ(run.log.story(), "past_balance overturn");
    EXPECT_NEAR(run.log.events[0].state.tilt, side * psi, 1e-15);
    EXPECT_NEAR(run.log.events[1].state.tilt, side * 0.5 * std::numbers::pi, 1e-15);
    EXPECT_EQ(run.motion.state().contact, ContactState::overturned);
    EXPECT_EQ(run.motion.termination(), Termination::overturned);
    EXPECT_TRUE(run.motion.was_past_balance());
    const double last = run.log.events[1].tau;
    EXPECT_EQ(run.log.strobes.size(), static_cast<std::size_t>(last / Stage{}.period_length()))
        << "the list ends before the overturning";
  }
}

// The energy (w^2)/2 + cos(phi) is constant: the time of overturning is an integral.
TEST(Overturning, HappensAtTheInstantOfTheIntegral) {
  const double start = 0.9 * psi;
  const double rate = 0.5 * psi;
  ScriptedRun run({.start = {.tilt = start, .tilt_rate = rate}, .periods = 30}, {});
  run.run();
  const double energy = 0.5 * rate * rate + std::cos(psi - start);
  const auto slowness = [energy](double theta) { return 1.0 / std::sqrt(2.0 * (energy - std::cos(psi - theta))); };
  const double tau =
      boost::math::quadrature::gauss_kronrod<double, 61>::integrate(slowness, start, 0.5 * std::numbers::pi, 15, 1e-15);
  EXPECT_NEAR(run.log.events.back().tau, tau, 1e-12);
}

TEST(PastBalance, IsNotOverturning) {
  // A base that pushes back strongly at all times: its period is far longer than the run.
  const Stage stage{
      .frequency = 0.5, .phase = 1.45 * std::numbers::pi, .start = {.tilt = 0.99 * psi, .tilt_rate = 0.2 * psi}};
  ScriptedRun run(stage, {.amplitude_value = stage.amplitude_for(0.2)});
  for (int step = 0; step < 1'000 && run.log.count(EventKind::impact_stick) == 0; ++step) {
    integrate::LoopCounts counts;
    const double length = run.motion.expand(run.motion.time_to_breakpoint());
    const auto [time, fired] =
        integrate::first_crossing(run.motion, length, integrate::uncleared_guards(run.motion, length), counts);
    run.motion.move(time);
    run.motion.reset(fired, false);
  }
  EXPECT_EQ(run.log.story(), "past_balance impact_stick") << "once up, once down: recorded the first time only";
  EXPECT_TRUE(run.motion.was_past_balance());
}

TEST(PastBalance, IsNoEventForABlockThatStartsThere) {
  ScriptedRun run({.start = {.tilt = 1.01 * psi}, .periods = 30}, {});
  run.run();
  EXPECT_EQ(run.log.story(), "overturn");
  EXPECT_TRUE(run.motion.was_past_balance());
}

// Free rocking: N = 4/3 - sin^2(phi) - w^2 cos(phi) with w^2 from the energy. If the block passes the balance with some
// speed, it reaches N = 0 while falling.
TEST(LossOfContact, IsCountedOnceAtTheInstantOfTheIntegralAndTheRunGoesOn) {
  const double start = 1.01 * psi;
  const double rate = 0.7;
  ScriptedRun run({.start = {.tilt = start, .tilt_rate = rate}, .periods = 30}, {});
  run.run();
  EXPECT_EQ(run.motion.losses_of_contact(), 1U);
  EXPECT_EQ(run.log.story(), "overturn") << "a loss of contact is no event of the motion";
  const double energy = 0.5 * rate * rate + std::cos(psi - start);
  const auto normal = [energy](double theta) {
    const double phi = psi - theta;
    return 4.0 / 3.0 - std::sin(phi) * std::sin(phi) - 2.0 * (energy - std::cos(phi)) * std::cos(phi);
  };
  ASSERT_GT(normal(start), 0.0);
  ASSERT_LT(normal(1.5), 0.0);
  const auto [low, high] =
      boost::math::tools::bisect(normal, start, 1.5, boost::math::tools::eps_tolerance<double>(52));
  const auto slowness = [energy](double theta) { return 1.0 / std::sqrt(2.0 * (energy - std::cos(psi - theta))); };
  const double tau =
      boost::math::quadrature::gauss_kronrod<double, 61>::integrate(slowness, start, 0.5 * (low + high), 15, 1e-15);
  EXPECT_NEAR(run.motion.first_loss_of_contact(), tau, 1e-12);
}

TEST(LossOfContact, AtTheStartIsCountedThere) {
  ScriptedRun run({.start = {.tilt = 0.1 * psi, .tilt_rate = 1.5}, .periods = 30}, {});
  run.run();
  EXPECT_EQ(run.motion.losses_of_contact(), 1U);
  EXPECT_EQ(run.motion.first_loss_of_contact(), 0.0);
}

TEST(LossOfContact, IsNoneWhereTheBlockPressesOnTheBase) {
  ScriptedRun run({.start = {.tilt = 0.5 * psi}, .periods = 20}, {.statics = {0.5}, .kinetics = {0.4}});
  run.run();
  EXPECT_EQ(run.motion.losses_of_contact(), 0U);
}

// While N <= 0 friction is not tested; once the block presses on the base again, it is. Thrown up at w^2 cos(phi) > 4/3
// on a base that pulls it back, the block is off the ground at first, then slips.
TEST(LossOfContact, SuspendsTheTestOfFrictionUntilTheBlockPressesAgain) {
  const Stage stage{.start = {.tilt = 0.1 * psi, .tilt_rate = 1.3}, .periods = 1};
  ScriptedRun run(stage, {.amplitude_value = -stage.amplitude_for(6.0), .statics = {0.1}, .kinetics = {0.05}});
  EXPECT_EQ(run.log.story(), "") << "no slip_start at tau = 0: N < 0";
  run.run();
  ASSERT_GE(run.log.events.size(), 1U);
  EXPECT_EQ(run.log.events[0].kind, EventKind::slip_start);
  EXPECT_GT(run.log.events[0].tau, 0.0);
  EXPECT_EQ(run.motion.first_loss_of_contact(), 0.0);
}

// The same with mu_k = mu_s. Where the block presses on the base again, N = 0 and the friction limit is far exceeded:
// V' is not zero there, unlike where abs(F) reaches mu_s N.
TEST(LossOfContact, EndsInASlipThatGoesOnWhereKineticFrictionIsTheStaticOne) {
  for (const double amplitude : {4.0, 7.0, 10.0}) {
    const Stage stage{.start = {.tilt = 0.1 * psi, .tilt_rate = -1.5}, .periods = 3};
    ScriptedRun run(stage, {.amplitude_value = amplitude, .statics = {0.2}, .kinetics = {0.2}});
    run.run();
    EXPECT_NE(run.motion.termination(), Termination::stopped) << "A_h = " << amplitude;
    EXPECT_GT(run.motion.losses_of_contact(), 0U) << "A_h = " << amplitude;
    EXPECT_LT(run.log.events.size(), 100U) << run.log.story().substr(0, 200);
  }
}

// Off the ground (w^2 cos(phi) > 4/3) and slipping against the tilt, the block moves towards the zero of D = 1/3 +
// sin^2(phi) - mu_k sin(phi) cos(phi): w grows without bound in finite time. The run ends with its reason before
// infinities spread.
TEST(Painleve, EndsTheRunWhereTheDeterminantVanishes) {
  for (const double side : {1.0, -1.0}) {
    ScriptedRun run({.start = {.tilt = side * 0.5 * psi, .tilt_rate = -1.2 * side, .slip_rate = -9.0 * side}},
                    {.statics = {1.7}, .kinetics = {1.7}});
    run.run();
    EXPECT_EQ(run.motion.termination(), Termination::painleve) << run.log.story();
    EXPECT_TRUE(std::isfinite(run.motion.state().tilt)) << run.motion.state().tilt;
    EXPECT_TRUE(std::isfinite(run.motion.state().tilt_rate)) << run.motion.state().tilt_rate;
  }
}

TEST(Painleve, EndsTheRunWhereANewDrawMakesTheDeterminantNegative) {
  ScriptedRun run({.start = {.tilt = 1e-3 * psi, .tilt_rate = 0.1, .slip_rate = -9.0}},
                  {.statics = {2.0}, .kinetics = {0.5, 2.0}, .changes = {{.period = 0, .time = 0x1p-12}}});
  run.run();
  EXPECT_EQ(run.motion.termination(), Termination::painleve);
  EXPECT_EQ(run.motion.clock().tau(), 0x1p-12);
}

TEST(Painleve, EndsTheRunAtTheStartWhereTheDeterminantIsNegativeThere) {
  ScriptedRun run({.start = {.tilt = 1e-3 * psi, .tilt_rate = -1.0, .slip_rate = -1.0}},
                  {.statics = {2.0}, .kinetics = {2.0}});
  run.run();
  EXPECT_EQ(run.motion.termination(), Termination::painleve);
  EXPECT_TRUE(run.log.strobes.empty());
}

TEST(Painleve, EndsTheRunInAnImpactBeforeItIsLogged) {
  ScriptedRun run({.start = {.tilt = -1e-3 * psi, .tilt_rate = 0.01, .slip_rate = -5.0}},
                  {.statics = {0.1}, .kinetics = {1.7}, .hold_kinetic = false});
  run.run();
  EXPECT_EQ(run.motion.termination(), Termination::painleve);
  EXPECT_EQ(run.log.story(), "");
}

TEST(Painleve, NeverArisesBelowFourThirds) {
  for (int i = 0; i < 60; ++i) {
    const double height = 0.5 + 0.2 * i;
    const Stage stage{.block = {.width = 1.0, .height = height}, .frequency = 5.0, .periods = 10};
    ScriptedRun run(stage, {.amplitude_value = 1.0 + 0.1 * i, .statics = {1.3333}, .kinetics = {1.3333}});
    run.run();
    EXPECT_NE(run.motion.termination(), Termination::painleve) << "H/B = " << height;
  }
}

TEST(Termination, AtTheHorizonComesWithTheLastStrobePoint) {
  ScriptedRun run({.start = {.tilt = 0.5 * psi}, .periods = 7}, {});
  run.run();
  EXPECT_EQ(run.motion.termination(), Termination::reached_horizon);
  EXPECT_EQ(run.log.strobes.size(), 7U);
}

// Extending a run after its horizon gives the same bits as a longer horizon from the start.
TEST(Termination, ThatIsExtendedGivesTheRunOfTheLongerHorizon) {
  const ScriptedCoefficients coefficients{.amplitude_value = 5.0, .statics = {0.35}, .kinetics = {0.3}};
  ScriptedRun whole({.phase = 1.0, .periods = 40}, coefficients);
  whole.run();
  ScriptedRun parts({.phase = 1.0, .periods = 13}, coefficients);
  parts.run();
  for (const std::int64_t more : {1, 6, 20}) {
    parts.motion.extend(more);
    parts.run();
  }
  ASSERT_EQ(parts.log.strobes.size(), whole.log.strobes.size());
  for (std::size_t k = 0; k < whole.log.strobes.size(); ++k) {
    EXPECT_EQ(parts.log.strobes[k].tilt, whole.log.strobes[k].tilt) << k;
    EXPECT_EQ(parts.log.strobes[k].tilt_rate, whole.log.strobes[k].tilt_rate) << k;
    EXPECT_EQ(parts.log.strobes[k].slip, whole.log.strobes[k].slip) << k;
  }
  EXPECT_EQ(parts.log.story(), whole.log.story());
}

/// Least value over the tilt of D = J + sin^2(phi) - mu sin(phi) cos(phi), to 2e-9: 40000 angles.
double least_determinant(double inertia, double friction) {
  double least = inertia;
  for (int i = 0; i <= 40'000; ++i) {
    const double phi = i * (0.5 * std::numbers::pi / 40'000);
    least = std::min(least, inertia + std::sin(phi) * (std::sin(phi) - friction * std::cos(phi)));
  }
  return least;
}

TEST(PainleveFriction, IsWhereTheDeterminantOrThatOfTheImpactVanishes) {
  for (const double height : {0.5, 1.0, 2.0, 4.0, 8.0, 20.0}) {
    const Geometry block = geometry_of({.width = 1.0, .height = height, .gravity = 9.81});
    for (const SlideInertia inertia : {SlideInertia::centroidal, SlideInertia::edge}) {
      const double limit = painleve_friction(block, inertia);
      const auto is_valid = [&](double friction) {
        const double q = block.sine * block.sine - friction * block.sine * block.cosine;
        return least_determinant(inertia_ratio(inertia), friction) > 0.0 && 1.0 + 3.0 * q > 0.0;
      };
      // dD/dmu = -mu/(2 sqrt(1 + mu^2)) is beyond -0.2 here, so that D changes by more than the 2e-9 of the search.
      EXPECT_TRUE(is_valid(limit * (1.0 - 1e-6))) << height;
      EXPECT_FALSE(is_valid(limit * (1.0 + 1e-6))) << height;
    }
  }
}

}  // namespace
}  // namespace rocking::dynamics
