// Slow passage near the unstable equilibrium abs(Theta) = 1, where an error grows as e^tau.
//
// Without base motion phi = psi - theta obeys phi'' = sin(phi): from rest at phi0, cos(phi/2) = k cd(tau, k^2), k =
// cos(phi0/2). The numbers below are this formula in 60 digits (mpmath: 2*acos(k*ellipfun('cd', tau, m=k**2))), and the
// falling times are K(k) - F(asin(cos(phi/2)/k), k). psi is the double 0x1.f5b75f92c80ddp-3 of H/B = 4, and phi0 is a
// multiple of 2^-55, the spacing of doubles at psi, so that psi - phi0 is a double.

#include <array>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "rocking/realisation/start.hpp"
#include "support/excitation.hpp"
#include "support/simulation.hpp"

namespace rocking {
namespace {

using dynamics::EventKind;
using dynamics::Termination;
using support::Stage;
using FreeRun = support::Simulation<dynamics::ConstantCoefficients>;

constexpr double balance = 0x1.f5b75f92c80ddp-3;
constexpr double ulp = 0x1p-55;  ///< at the balance

/// Free rocking from `start`; strobe points are pi/10 apart, so that no step is longer.
Stage standing(double start, std::int64_t periods) {
  return {.frequency = 20.0, .tolerance = 1e-16, .start = {.tilt = start}, .periods = periods};
}

struct Passage {
  std::int64_t strobe;  ///< tau = strobe pi/10
  std::int64_t ulps;    ///< phi0
  double angle;         ///< phi at that time
};

// Each step rounds theta by at most ulp/2; a rounding at t has grown by cosh(tau - t) at tau. With steps of at most
// pi/10 the sum is at most (ulp/2) (e^tau/2)/(1 - e^(-pi/10)) < ulp e^tau. Roundings of w, relative to w: a few per
// step, 110 steps. Neglected terms are below 1e-20 of phi at this step length.
TEST(SlowPassage, IsLeftWithAnErrorThatGrowsAsTheExponentialOfTime) {
  constexpr std::array<Passage, 7> passages{{{16, 47280013408271, 0.09998342652866405},
                                             {32, 310224022566, 0.09997917465646233},
                                             {48, 2035510086, 0.09997917445680483},
                                             {64, 13355836, 0.09997917102349746},
                                             {80, 87633, 0.09997888752248108},
                                             {96, 575, 0.09997942400968061},
                                             {112, 4, 0.1059970369420320}}};
  ASSERT_EQ(Stage{}.geometry().shape_angle, balance);
  for (const Passage& passage : passages) {
    for (const double direction : {-1.0, 1.0}) {
      const double phi0 = static_cast<double>(passage.ulps) * ulp;
      FreeRun run(standing(balance + direction * phi0, passage.strobe), {});
      run.run();
      ASSERT_EQ(run.log.strobes.size(), static_cast<std::size_t>(passage.strobe));
      const double tau = static_cast<double>(passage.strobe) * 0.31415926535897932;
      const double error = std::abs(run.log.strobes.back().tilt - (balance + direction * passage.angle));
      EXPECT_LE(error, ulp * std::exp(tau) + 1e-14) << "tau = " << tau;
    }
  }
}

// A base that accelerates downwards with three quarters of g leaves a quarter of the weight: phi'' = sin(phi)/4, the
// same passage in twice the time. Fifty units of time are 25 of those of the equilibrium; the error is that of the row
// with the same number of ulps above.
TEST(SlowPassage, OfFiftyUnitsOfTimeUnderAQuarterOfTheWeightEndsWhereTheClosedFormDoes) {
  constexpr Passage passage{160, 87633, 0.09997888752248108};
  for (const double direction : {-1.0, 1.0}) {
    Condition condition;
    condition.tolerance = 1e-16;
    condition.scene.excitation =
        support::recorded_by({.samples = {{0.0, 0.0, -0.75}, {1000.0, 0.0, -0.75}}, .has_vertical = true}, 20.0);
    Start start = start_of(condition.scene, random::Draws(0, 0));
    start.state.tilt = balance + direction * static_cast<double>(passage.ulps) * ulp;
    support::EventLog log;
    const auto beginning = begin_realisation(condition, random::Draws(0, 0), start, Strobe::start, passage.strobe);
    Motion motion = motion_of(condition.scene, beginning, log);
    static_cast<void>(integrate::advance(motion));
    EXPECT_NEAR(log.strobes.back().tilt, balance + direction * passage.angle, 2.0 * ulp * std::exp(25.14))
        << "twice as many steps";
  }
}

TEST(SlowPassage, NeverBeginsForABlockThatStandsExactlyOnItsEdge) {
  for (const double side : {-1.0, 1.0}) {
    FreeRun run(standing(side * balance, 160), {});
    run.run();
    EXPECT_EQ(run.log.story(), "");
    EXPECT_EQ(run.motion.state().tilt, side * balance) << "fifty units of time, to the bit";
    EXPECT_EQ(run.motion.state().tilt_rate, 0.0);
  }
}

struct Fall {
  std::int64_t ulps;
  double to_ground;
  double to_side;
};

// Doubles can represent less than 40 units of time between rest and falling. The side is never lost: w' has the sign of
// phi0 from the start. phi0 is known to ulp (see above: rounding errors grow with e^tau, as phi0 does), so that the
// time is known to log(1 + ulp/phi0), and to 1e-13 far from the equilibrium.
TEST(SlowPassage, EndsOnTheSideOnWhichItBeganFromOneUlpOn) {
  constexpr std::array<Fall, 8> falls{{{1, 37.410909348313644, 39.135860927598787},
                                       {2, 36.717762167753699, 38.442713747038842},
                                       {3, 36.312297059645535, 38.037248638930677},
                                       {5, 35.801471435879544, 37.526423015164686},
                                       {8, 35.331467806633808, 37.056419385918951},
                                       {16, 34.638320626073863, 36.363272205359006},
                                       {64, 33.252026264953973, 34.976977844239115},
                                       {1024, 30.479437542714191, 32.204389121999333}}};
  for (const Fall& fall : falls) {
    const double phi0 = static_cast<double>(fall.ulps) * ulp;
    const double margin = std::log1p(1.5 / static_cast<double>(fall.ulps)) + 1e-13;
    FreeRun back(standing(balance - phi0, 160), {});
    back.run();
    ASSERT_FALSE(back.log.events.empty()) << fall.ulps;
    EXPECT_EQ(back.log.events[0].kind, EventKind::impact_stick) << fall.ulps;
    EXPECT_NEAR(back.log.events[0].tau, fall.to_ground, margin) << fall.ulps;
    EXPECT_FALSE(back.motion.was_past_balance());
    FreeRun over(standing(balance + phi0, 160), {});
    over.run();
    ASSERT_FALSE(over.log.events.empty()) << fall.ulps;
    EXPECT_EQ(over.motion.termination(), Termination::overturned) << fall.ulps;
    EXPECT_NEAR(over.log.events.back().tau, fall.to_side, margin) << fall.ulps;
  }
}

}  // namespace
}  // namespace rocking
