// Overturning thresholds by bisection, compared with closed forms, and the same in a second run.

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "support/excitation.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using dynamics::EventKind;
using dynamics::Termination;

constexpr double psi = 0x1.f5b75f92c80ddp-3;  ///< of H/B = 4

/// The adjacent values of the parameter between which the result changes, or an interval of length `width`.
struct Bracket {
  double stands;
  double overturns;
};

Bracket bisect(const std::function<bool(double)>& overturns, Bracket bracket, double width) {
  while (bracket.overturns - bracket.stands > width) {
    const double middle = 0.5 * (bracket.stands + bracket.overturns);
    if (middle <= bracket.stands || middle >= bracket.overturns) break;
    (overturns(middle) ? bracket.overturns : bracket.stands) = middle;
  }
  return bracket;
}

bool is_overturned(const Condition& condition) {
  return realise(condition, 0, 0).termination == Termination::overturned;
}

// --- an initial rate
// ---------------------------------------------------------------------------------------------------

/// Upright, with the initial rate Theta'.
Condition thrown(double rate) {
  Condition condition;
  support::harmonic(condition.scene).frequency_ratio = 6.0;
  condition.scene.initial.tilt_rate = rate;
  condition.horizon = {.transient_periods = 0, .sampled_periods = 60};
  return condition;
}

// w0^2/2 + cos(psi) = 1 at the balance: w0 = 2 sin(psi/2). A run keeps its energy to a rounding, about 1e-16 of 1, over
// about 10 units of time away from the balance; dE = w0 dw.
constexpr double least_rate = 0.99750126918139714578;  // 2 sin(psi/2)/psi, mpmath
constexpr double rate_error = 10 * 0x1p-53 / (0.2449 * 0.2449);

TEST(OverturningRate, IsThatOfTheEnergyAtTheBalance) {
  const auto overturns = [](double rate) { return is_overturned(thrown(rate)); };
  const Bracket bracket = bisect(overturns, {0.9, 1.1}, 1e-15);
  EXPECT_NEAR(bracket.stands, least_rate, rate_error);
  EXPECT_LE(bracket.overturns - bracket.stands, 1e-15);
  const Bracket mirrored = bisect([&](double rate) { return overturns(-rate); }, {0.9, 1.1}, 1e-15);
  EXPECT_EQ(mirrored.stands, bracket.stands) << "to the bit";
  EXPECT_EQ(mirrored.overturns, bracket.overturns);
}

TEST(OverturningRate, SeparatesWhatStandsFromWhatOverturnsOnEitherSide) {
  support::SplitMix random(20121106);
  for (int i = 0; i < 400; ++i) {
    const double away = std::pow(10.0, random.uniform(-13.5, -2.0));
    EXPECT_FALSE(is_overturned(thrown(least_rate - away))) << away;
    EXPECT_TRUE(is_overturned(thrown(least_rate + away))) << away;
  }
}

TEST(OverturningRate, IsPassedWithDifferentStoriesOnItsTwoSides) {
  const Trajectory below = trajectory_of(thrown(least_rate - 1e-12), 0, 0, 60);
  ASSERT_FALSE(below.events.empty());
  EXPECT_EQ(below.events.front().kind, EventKind::impact_stick);
  EXPECT_EQ(below.termination, Termination::reached_horizon);
  const Trajectory above = trajectory_of(thrown(least_rate + 1e-12), 0, 0, 60);
  ASSERT_EQ(above.events.size(), 2U);
  EXPECT_EQ(above.events[0].kind, EventKind::past_balance);
  EXPECT_EQ(above.events[1].kind, EventKind::overturn);
}

// --- a rectangular pulse
// -----------------------------------------------------------------------------------------------

/// At rest under alpha = `push` of duration `tau`.
Condition pushed(double push, double tau) {
  Condition condition;
  const double p = dynamics::geometry_of(mean_block(condition.scene)).frequency_parameter;
  condition.scene.excitation = support::recorded_by(
      {.samples = {{0.0, push, 0.0}, {tau / p, push, 0.0}, {tau / p, 0.0, 0.0}}, .has_vertical = false}, 6.0);
  condition.horizon = {.transient_periods = 0, .sampled_periods = 60};
  return condition;
}

struct Pulse {
  double push;
  double least;
};

// The pulse does the work alpha (sin(psi) - sin(phi1)), which must reach 1 - cos(psi): this gives its end phi1. The
// time until then is the integral of dphi/w with w^2/2 = cos(psi) - cos(phi) + alpha (sin(psi) - sin(phi)). Housner's
// formula is its limit for psi -> 0. The integral below is from mpmath with 50 digits.
TEST(OverturningPulse, HasTheLeastDurationOfTheClosedFormForABlockThatIsNotSlender) {
  constexpr std::array<Pulse, 4> pulses{{{0.3, 1.787188386909848861},
                                         {0.5, 0.694657418494709702},
                                         {1.0, 0.289103269815816011},
                                         {3.0, 0.0875931510258186665}}};
  for (const auto& [push, least] : pulses) {
    const auto overturns = [alpha = push](double tau) { return is_overturned(pushed(alpha, tau)); };
    const Bracket bracket = bisect(overturns, {0.5 * least, 2.0 * least}, 1e-13);
    // An error dt of the time is an error alpha cos(phi) w dt of the energy. The energy is known to ten roundings plus
    // what a handful of steps neglect, 1e-13 psi of w each.
    const double rate = std::sqrt(2.0 * (1.0 - std::cos(psi)));
    EXPECT_NEAR(bracket.stands, least, 1e-13 + (10 * 0x1p-53 + 5 * 1e-13 * psi * rate) / (push * 0.96 * 0.5 * rate))
        << push;
    EXPECT_TRUE(overturns(least + 1e-11)) << push;
    EXPECT_FALSE(overturns(least - 1e-11)) << push;
  }
}

// --- harmonic shaking
// --------------------------------------------------------------------------------------------------

Condition from_rest(double amplitude, double tolerance) {
  Condition condition;
  support::harmonic(condition.scene).amplitude = amplitude;
  support::harmonic(condition.scene).frequency_ratio = 5.0;
  condition.tolerance = tolerance;
  condition.horizon = {.transient_periods = 0, .sampled_periods = 40};
  return condition;
}

Bracket least_amplitude(double tolerance) {
  return bisect([tolerance](double amplitude) { return is_overturned(from_rest(amplitude, tolerance)); }, {2.0, 12.0},
                1e-12);
}

// From rest the set of amplitudes that overturn has several boundaries; bisection finds one of them, the same one each
// time.
TEST(OverturningAmplitude, IsFoundWithTheSameBitsAgainAndToTheErrorOfTheStepsAtAnotherTolerance) {
  const Bracket first = least_amplitude(1e-13);
  EXPECT_LE(first.overturns - first.stands, 1e-12);
  const Bracket again = least_amplitude(1e-13);
  EXPECT_EQ(first.stands, again.stands);
  EXPECT_EQ(first.overturns, again.overturns);
  EXPECT_NEAR(least_amplitude(1e-15).stands, first.stands, 1e-10);
}

TEST(OverturningAmplitude, HasStoriesThatAreOneUntilTheBalanceAndThenPart) {
  const Bracket bracket = least_amplitude(1e-13);
  const Trajectory stands = trajectory_of(from_rest(bracket.stands, 1e-13), 0, 0, 40);
  const Trajectory overturns = trajectory_of(from_rest(bracket.overturns, 1e-13), 0, 0, 40);
  EXPECT_EQ(stands.termination, Termination::reached_horizon);
  EXPECT_EQ(overturns.termination, Termination::overturned);
  ASSERT_GT(stands.events.size(), overturns.events.size() - 2) << "one goes on rocking";
  std::size_t common = 0;
  while (common < overturns.events.size() && overturns.events[common].kind == stands.events[common].kind) ++common;
  EXPECT_GE(common + 2, overturns.events.size()) << "nothing but the passage of the balance and the fall differs";
  // The last common event is near the balance, where a distance of 1e-12 has become its square root.
  for (std::size_t i = 0; i + 1 < common; ++i) {
    EXPECT_NEAR(overturns.events[i].tau, stands.events[i].tau, 1e-6) << i;
  }
}

}  // namespace
}  // namespace rocking
