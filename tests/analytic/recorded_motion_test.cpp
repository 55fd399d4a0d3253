// Blocks under recorded excitations for which the motion has a closed form: constant and linear accelerations, pulses,
// and a vertical acceleration that acts like gravity.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/motion.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/start.hpp"
#include "support/excitation.hpp"
#include "support/ordinary_steps.hpp"

namespace rocking {
namespace {

using dynamics::EventKind;
using dynamics::GroundMotionSample;

/// A sample at a normalised time; accelerations in g.
struct Knot {
  double tau;
  double horizontal;
  double vertical = 0.0;
};

/// A block of height `height` times its width under a ground motion, without friction; strobe points a time 1 apart.
Condition shaken_by(const std::vector<Knot>& knots, bool has_vertical = false, double height = 4.0) {
  Condition condition;
  condition.scene.block.height = height;
  const double p = dynamics::geometry_of(mean_block(condition.scene)).frequency_parameter;
  GroundMotion motion{.samples = {}, .has_vertical = has_vertical};
  for (const Knot& knot : knots) motion.samples.push_back({knot.tau / p, knot.horizontal, knot.vertical});
  condition.scene.excitation = support::recorded_by(std::move(motion), 2.0 * pi);
  condition.horizon = {.transient_periods = 0, .sampled_periods = 20};
  return condition;
}

// A constant base acceleration acts like a gravity tilted by chi = atan(alpha) and larger by sqrt(1 + alpha^2).
TEST(RecordedConstant, MakesTheBlockFallAsUnderTiltedGravity) {
  for (const double height : {2.0, 4.0, 10.0}) {
    for (const double alpha : {-0.3, -0.02, 0.02}) {
      Condition condition = shaken_by({{0.0, alpha}, {50.0, alpha}}, false, height);
      condition.scene.initial.tilt = 0.4;
      const double psi = dynamics::geometry_of(mean_block(condition.scene)).shape_angle;
      const double chi = std::atan(alpha);
      const Trajectory trajectory = run(condition, 10);
      ASSERT_FALSE(trajectory.events.empty());
      EXPECT_NEAR(trajectory.events[0].tau,
                  falling_time(0.6 * psi - chi, psi - chi) / std::sqrt(std::sqrt(1.0 + alpha * alpha)), 1e-12)
          << height << " " << alpha;
    }
  }
}

// psi -> 0: Theta'' = Theta - 1 + a, a = alpha/psi, so Theta = 1 - a - (1 - a - Theta0) cosh(tau).
TEST(RecordedConstant, MovesASlenderBlockByAHyperbolicCosine) {
  constexpr double a = 0.3;
  double last_error = 0.0;
  for (const double height : {50.0, 100.0, 200.0}) {
    Condition condition = shaken_by({{0.0, 0.0}, {50.0, 0.0}}, false, height);
    const double alpha = a * dynamics::geometry_of(mean_block(condition.scene)).shape_angle;
    condition = shaken_by({{0.0, alpha}, {50.0, alpha}}, false, height);
    condition.scene.initial.tilt = 0.6;
    const double error = std::abs(run(condition, 1).strobe.at(0).tilt - (0.7 - 0.1 * std::cosh(1.0)));
    EXPECT_LT(error, 1.0 / (height * height));
    EXPECT_NEAR(last_error / error, 4.0, last_error == 0.0 ? 1e9 : 0.05) << "of second order in psi";
    last_error = error;
  }
}

/// Whether a slender block overturns under a constant acceleration of `a` psi g that lasts for `tau`.
bool overturns_under_rectangle(double a, double tau) {
  constexpr double height = 300.0;
  const double alpha = a * dynamics::geometry_of({.width = 1.0, .height = height, .gravity = 9.81}).shape_angle;
  const Condition condition =
      shaken_by({{0.5, 0.0}, {0.5, alpha}, {0.5 + tau, alpha}, {0.5 + tau, 0.0}}, false, height);
  return run(condition, 40).termination == Termination::overturned;
}

// Housner (1963), BSSA 53(2) 403-417: cosh(tau) = 1 + 1/(2 a (a - 1)) is the shortest duration that overturns.
TEST(RectangularPulse, OverturnsFromHousnersDurationOn) {
  for (const double a : {1.1, 1.5, 3.0, 10.0}) {
    const double least = std::acosh(1.0 + 0.5 / (a * (a - 1.0)));
    EXPECT_FALSE(overturns_under_rectangle(a, 0.9999 * least)) << a;
    EXPECT_TRUE(overturns_under_rectangle(a, 1.0001 * least)) << a;
  }
}

/// A block that slides at V = -2 with friction 0.1, far from tipping.
Condition sliding_under(const std::vector<Knot>& knots) {
  Condition condition = shaken_by(knots);
  condition.scene.friction = Friction{.static_coefficient = 0.1, .kinetic_coefficient = 0.1};
  condition.scene.initial.slip_rate = -2.0;
  return condition;
}

// V' = -(4/3) (alpha - mu_k). Under a triangular pulse of height A from 0 over 1 to 2 the integrals of alpha are A/2
// and A/6 at its peak, A and A (tau - 1) after it.
TEST(TriangularPulse, PushesASlidingBlockByItsTwoIntegrals) {
  constexpr double peak = 0.8;
  const Trajectory trajectory = run(sliding_under({{0.0, 0.0}, {1.0, peak}, {2.0, 0.0}}), 5);
  ASSERT_TRUE(trajectory.events.empty()) << "it slides on";
  for (const auto& sample : trajectory.strobe) {
    const auto tau = static_cast<double>(sample.period);
    const double once = tau < 1.5 ? 0.5 * peak : peak;
    const double twice = tau < 1.5 ? peak / 6.0 : peak * (tau - 1.0);
    EXPECT_NEAR(sample.slip_rate, -2.0 + 4.0 / 3.0 * (0.1 * tau - once), 5e-15) << tau;
    EXPECT_NEAR(sample.slip, -2.0 * tau + 4.0 / 3.0 * (0.05 * tau * tau - twice), 5e-14) << tau;
  }
}

// Under a constant acceleration V' = -(4/3) (alpha - mu_k) from V = -2: the block stops after the time 1.5/(mu_k -
// alpha) and rests while abs(alpha) <= mu_s.
TEST(RecordedConstant, StopsASlidingBlockWhereAndWhenConstantFrictionSays) {
  for (const double alpha : {-0.09, 0.05, -0.4}) {
    const Trajectory trajectory = run(sliding_under({{0.0, alpha}, {90.0, alpha}}), 40);
    const double tau = 1.5 / (0.1 - alpha);
    ASSERT_FALSE(trajectory.events.empty());
    EXPECT_EQ(trajectory.events[0].kind, alpha < -0.1 ? EventKind::slip_reverse : EventKind::slide_stop);
    // V is rounded at the end of about forty steps. Divided by its slope, (4/3) (mu_k - alpha) >= 0.06, this is an
    // error of tau.
    EXPECT_NEAR(trajectory.events[0].tau, tau, 1e-13) << alpha;
    EXPECT_NEAR(trajectory.events[0].slip, -tau, 1e-13) << alpha;
    EXPECT_TRUE(alpha < -0.1 || trajectory.events.size() == 1U) << "it stays there";
  }
}

TEST(Jump, ChangesTheAccelerationAtOnce) {
  const Trajectory trajectory = run(sliding_under({{0.0, 0.3}, {1.3, 0.3}, {1.3, -0.2}, {3.0, -0.2}}), 4);
  EXPECT_NEAR(trajectory.strobe.at(1).slip_rate, -2.0 + 4.0 / 3.0 * (0.2 - 0.3 * 1.3 + 0.2 * 0.7), 5e-15);
  EXPECT_NEAR(trajectory.strobe.at(3).slip_rate, -2.0 + 4.0 / 3.0 * (0.4 - 0.3 * 1.3 + 0.2 * 1.7), 5e-15)
      << "after the last sample the base is still";
}

TEST(Jump, LiftsABlockAtItsInstant) {
  const Trajectory trajectory = run(shaken_by({{0.0, 0.2}, {1.7, 0.2}, {1.7, 0.3}, {1.8, 0.3}}), 3);
  ASSERT_FALSE(trajectory.events.empty());
  EXPECT_EQ(trajectory.events[0].kind, EventKind::lift);
  EXPECT_NEAR(trajectory.events[0].tau, 1.7, 1e-15);
}

TEST(Gap, IsBridgedByAStraightLine) {
  std::vector<Knot> fine;
  for (int i = 0; i <= 64; ++i) fine.push_back({static_cast<double>(i) / 16.0, 0.45 - static_cast<double>(i) / 80.0});
  const std::vector<Knot> gaps{fine[0], fine[1], fine[40], fine[64]};
  const Trajectory a = run(shaken_by(fine), 12);
  const Trajectory b = run(shaken_by(gaps), 12);
  ASSERT_GE(a.events.size(), 3U);
  ASSERT_EQ(a.events.size(), b.events.size());
  for (std::size_t i = 0; i < a.events.size(); ++i) EXPECT_NEAR(a.events[i].tau, b.events[i].tau, 1e-11);
}

TEST(RecordedExcitation, FindsTheBaseAtRestBeforeItsFirstSample) {
  const Trajectory trajectory = run(shaken_by({{2.5, 0.3}, {2.75, 0.3}}), 4);
  ASSERT_FALSE(trajectory.events.empty());
  EXPECT_NEAR(trajectory.events[0].tau, 2.5, 1e-15);
}

/// Theta after three periods of A_h = 4.5, recorded with `samples` per period.
double tilt_under_sampled_sine(int samples) {
  const double amplitude = 4.5 * dynamics::geometry_of({}).shape_angle;
  std::vector<Knot> knots;
  for (int i = 0; i <= 4 * samples; ++i) {
    const double angle = 2.0 * pi * static_cast<double>(i) / samples;
    knots.push_back({angle / 10.0, amplitude * std::sin(angle)});
  }
  Condition condition = shaken_by(knots);
  support::recorded(condition.scene).frequency_ratio = 10.0;
  return run(condition, 3).strobe.at(2).tilt;
}

// Linear interpolation between samples a time h apart reduces the amplitude of a sine by the relative amount h^2/12; to
// this order it has no other effect.
TEST(SampledSine, TendsToTheHarmonicExcitationWithTheSquareOfTheSpacing) {
  Condition harmonic = shaken_by({{0.0, 0.0}, {1.0, 0.0}});
  harmonic.scene.excitation = Harmonic{.amplitude = 4.5, .frequency_ratio = 10.0};
  const double exact = run(harmonic, 3).strobe.at(2).tilt;
  const double coarse = tilt_under_sampled_sine(100) - exact;
  const double fine = tilt_under_sampled_sine(200) - exact;
  const double finest = tilt_under_sampled_sine(400) - exact;
  EXPECT_LT(std::abs(finest), 1e-3);
  EXPECT_NEAR(coarse / fine, 4.0, 0.1);
  EXPECT_NEAR(fine / finest, 4.0, 0.05);
}

std::vector<Knot> pulses(double factor, double pace, double vertical) {
  std::vector<Knot> knots;
  for (const auto& [tau, alpha] : {std::pair{0.0, 0.0}, {0.4, 0.6}, {0.9, -0.5}, {1.6, 0.3}, {2.0, 0.0}, {60.0, 0.0}}) {
    knots.push_back({tau / pace, alpha * factor, vertical});
  }
  return knots;
}

// alpha_v = 3 acts like four times the gravity: with a quarter of alpha the motion is the same, in half of the time.
TEST(VerticalAcceleration, IsGravityByAnotherName) {
  for (const bool slides : {false, true}) {
    Condition light = shaken_by(pulses(1.0, 1.0, 0.0));
    Condition heavy = shaken_by(pulses(4.0, 2.0, 3.0), true);
    if (slides) {
      light.scene.friction = heavy.scene.friction = Friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.3};
    }
    const Trajectory a = run(light, 20);
    const Trajectory b = run(heavy, 10);
    ASSERT_GT(a.events.size(), 4U);
    std::size_t compared = 0;
    for (std::size_t i = 0; i < std::min(a.events.size(), b.events.size()); ++i) {
      if (a.events[i].kind == EventKind::impact_stick && std::abs(a.events[i].tilt_rate) < 1e-3) break;  // chatter
      EXPECT_EQ(a.events[i].kind, b.events[i].kind) << i;
      EXPECT_NEAR(a.events[i].tau, 2.0 * b.events[i].tau, 1e-10) << i;
      EXPECT_NEAR(2.0 * a.events[i].tilt_rate, b.events[i].tilt_rate, 1e-9) << i;
      EXPECT_NEAR(2.0 * a.events[i].slip_rate, b.events[i].slip_rate, 1e-9) << i;
      ++compared;
    }
    EXPECT_GT(compared, 3U);
  }
}

struct Silent final : dynamics::Observer {
  void event(EventKind, double, const dynamics::State&) override {}
  void strobe(const dynamics::State&) override {}
};

TEST(VerticalAcceleration, IsNotComputedWhereNoneIsRecorded) {
  for (const bool has_vertical : {false, true}) {
    const Condition condition = shaken_by(pulses(1.0, 1.0, 0.0), has_vertical);
    const random::Draws draws(0, 0);
    const Start start = start_of(condition.scene, draws);
    const Beginning beginning = begin_realisation(condition, draws, start, Strobe::start, 1);
    Silent silent;
    EXPECT_EQ(motion_of(condition.scene, beginning, silent).excitation().has_vertical(), has_vertical)
        << "for which the product with the weight is compiled in";
  }
}

/// A motion that records the ends of its steps.
template <class Motion>
struct Noting : support::OrdinarySteps<Motion> {
  std::vector<double> ends{};

  void reset(const integrate::FiredGuards& fired, bool at_breakpoint) {
    this->motion.reset(fired, at_breakpoint);
    ends.push_back(this->motion.clock().tau());
  }
};

TEST(RecordedExcitation, EndsAStepAtEachOfItsSamples) {
  std::vector<Knot> knots;
  for (int i = 0; i <= 300; ++i) knots.push_back({0.013 * i + 0.003 * (i % 3), 0.5 * std::sin(0.2 * i)});
  const Condition condition = shaken_by(knots);
  Silent silent;
  const random::Draws draws(0, 0);
  const Beginning beginning = begin_realisation(condition, draws, start_of(condition.scene, draws), Strobe::start, 20);
  Motion motion = motion_of(condition.scene, beginning, silent);
  Noting<Motion> noting{{motion}};
  static_cast<void>(integrate::advance(noting));
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const bool met = std::any_of(noting.ends.begin(), noting.ends.end(),
                                 [&](double end) { return std::abs(end - knots[i].tau) < 2e-15 * (1 + end); });
    EXPECT_TRUE(met) << "sample " << i;
  }
  EXPECT_GE(motion.segments_looked_up(), 300U);
}

TEST(RecordedExcitation, IsLookedUpOnlyWhereThereIsOne) {
  Condition condition = shaken_by(pulses(1.0, 1.0, 0.0));
  EXPECT_GE(realise(condition, 0, 0).operations.ground_motion_segments, 5U);
  condition.scene.excitation = Harmonic{.amplitude = 1.0, .frequency_ratio = 2.0 * pi};
  EXPECT_EQ(realise(condition, 0, 0).operations.ground_motion_segments, 0U);
}

TEST(RecordedExcitation, OfNoMotionLeavesFreeRockingInEveryBit) {
  Condition still = shaken_by({{0.0, 0.0}, {1000.0, 0.0}});
  still.scene.initial.tilt = 0.7;
  Condition free = still;
  free.scene.excitation = Harmonic{.amplitude = 0.0, .frequency_ratio = 2.0 * pi};
  const Trajectory a = run(still, 20);
  const Trajectory b = run(free, 20);
  ASSERT_EQ(a.events.size(), b.events.size());
  ASSERT_GT(a.events.size(), 10U);
  for (std::size_t i = 0; i < a.events.size(); ++i) {
    EXPECT_EQ(a.events[i].tau, b.events[i].tau);
    EXPECT_EQ(a.events[i].tilt_rate, b.events[i].tilt_rate);
  }
  for (std::size_t i = 0; i < a.strobe.size(); ++i) EXPECT_EQ(a.strobe[i].tilt, b.strobe.at(i).tilt);
}

}  // namespace
}  // namespace rocking
