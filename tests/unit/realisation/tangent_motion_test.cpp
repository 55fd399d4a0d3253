// The tangent flow under a vertical base motion, and instants at which a motion has no derivative.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "property/scene.hpp"
#include "rocking/realisation/tangent_motion.hpp"
#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"

namespace rocking {
namespace {

using support::ScriptedCoefficients;
using Simulation = support::Simulation<ScriptedCoefficients>;
using Sliding = TangentMotion<Simulation::Motion, 1>;

/// A block that slides on a base at rest from V = `slip_rate`, until it stops. The vector is a change of V.
Sliding slide(double slip_rate, const ScriptedCoefficients& coefficients) {
  support::Stage stage;
  stage.start.slip_rate = slip_rate;
  Simulation simulation(stage, coefficients);
  Sliding motion(simulation.motion, {{{.slip_rate = 1.0}}});
  motion.observe_with(simulation.log);
  integrate::advance(motion);
  return motion;
}

// V = V0 - (4/3) mu_k tau stops at X = V0^2/(2 (4/3) mu_k): dX = V0/((4/3) mu_k) dV0.
TEST(TangentMotion, KnowsWhereASlideStops) {
  const Sliding motion = slide(0.02, {.statics = {0.5}, .kinetics = {0.1}});
  EXPECT_FALSE(motion.not_differentiable().any());
  EXPECT_NEAR(motion.at_strobe()[0].slip, 0.02 / (4.0 / 3.0 * 0.1), 1e-15);
  EXPECT_EQ(motion.at_strobe()[0].slip_rate, 0.0);
}

TEST(TangentMotion, CountsAGuardThatIsReachedAtNoRate) {
  EXPECT_EQ(slide(1e-14, {.statics = {0.5}, .kinetics = {1e-13}}).not_differentiable().grazings, 1U);
  EXPECT_EQ(slide(1e-10, {.statics = {0.5}, .kinetics = {1e-9}}).not_differentiable().grazings, 0U);
}

TEST(TangentMotion, CountsAStopAtABreakpoint) {
  const auto coincidences = [](double change) {
    const ScriptedCoefficients coefficients{
        .statics = {0.5}, .kinetics = {0.1, 0.2}, .changes = {{.period = 0, .time = change}}};
    return slide(0.02, coefficients).not_differentiable().coincidences;
  };
  const double stop = 0.02 / (4.0 / 3.0 * 0.1);
  EXPECT_EQ(coincidences(stop * (1.0 + 0x1p-51)), 1U);  // at the stop, for the resolution of the clock
  EXPECT_EQ(coincidences(0.9 * stop), 0U);
  EXPECT_EQ(coincidences(1.1 * stop), 0U);
}

/// The end of a motion that starts at this tilt and rate over an edge or with slip, its tangent vectors and its events.
struct End {
  dynamics::State state;
  std::array<dynamics::Tangent<double>, 2> tangents;
  std::string story;
};

End end_of(property::Scene scene, double tilt, double tilt_rate) {
  scene.stage.start.tilt += tilt;
  scene.stage.start.tilt_rate += tilt_rate;
  End end;
  property::with_simulation(scene, [&]<class Run>(Run& run) {
    TangentMotion<typename Run::Motion, 2> motion(run.motion, {{{.tilt = 1.0}, {.tilt_rate = 1.0}}});
    motion.observe_with(run.log);
    integrate::advance(motion);
    end = {.state = run.log.strobes.back(), .tangents = motion.at_strobe(), .story = run.log.story()};
  });
  return end;
}

/// Largest difference from central differences with step h, over one and the largest component.
double error_of(const property::Scene& scene, const End& end, double h) {
  double error = 0.0;
  double size = 1.0;
  for (std::size_t i = 0; i < 2; ++i) {
    const double tilt = i == 0 ? h : 0.0;
    const double rate = i == 0 ? 0.0 : h;
    const End ahead = end_of(scene, tilt, rate);
    const End behind = end_of(scene, -tilt, -rate);
    if (ahead.story != end.story || behind.story != end.story) return std::nan("");
    const auto compare = [&](double of, double a, double b) {
      error = std::max(error, std::abs((a - b) / (2.0 * h) - of));
      size = std::max(size, std::abs(of));
    };
    compare(end.tangents[i].tilt, ahead.state.tilt, behind.state.tilt);
    compare(end.tangents[i].tilt_rate, ahead.state.tilt_rate, behind.state.tilt_rate);
    compare(end.tangents[i].slip, ahead.state.slip, behind.state.slip);
    compare(end.tangents[i].slip_rate, ahead.state.slip_rate, behind.state.slip_rate);
  }
  return error / size;
}

// Steps are shorter than under a harmonic excitation, and a run has as many roundings as steps. A smaller step of the
// difference shows the derivative where that of higher order is large.
TEST(TangentMotion, IsTheDerivativeUnderAVerticalMotion) {
  int compared = 0;
  int close = 0;
  std::string stories;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    support::SplitMix draw(seed);
    property::Scene scene{.stage = {.tolerance = 1e-17, .periods = 2},
                          .coefficients = {.amplitude_value = draw.uniform(1.0, 4.0),
                                           .statics = {draw.uniform(0.25, 0.6)},
                                           .kinetics = {draw.uniform(0.15, 0.5)}},
                          .base = property::Base::recorded_with_vertical};
    scene.stage.start = {.tilt = draw.uniform(-0.1, 0.1), .tilt_rate = draw.uniform(-0.1, 0.1)};
    if (draw.below(2) == 0) scene.stage.start.slip_rate = draw.uniform(-0.1, 0.1);
    scene.knots = property::random_record(scene.stage, 2.0, draw);
    const End end = end_of(scene, 0.0, 0.0);
    const double error = error_of(scene, end, 1e-6);
    if (std::isnan(error)) continue;
    ++compared;
    stories += end.story + ' ';
    const double finer = std::fmin(error_of(scene, end, 1e-7), error_of(scene, end, 1e-8));
    EXPECT_LT(std::fmin(error, finer), 1e-6) << seed << ", " << end.story;
    close += error < 1e-8 ? 1 : 0;
  }
  EXPECT_GT(compared, 60);
  EXPECT_GT(close, compared / 2);
  for (const char* kind : {"impact_stick", "impact_slip", "slip_start", "slip_stop", "slip_reverse"}) {
    EXPECT_NE(stories.find(kind), std::string::npos) << kind;
  }
}

// Without cells nothing bounds the part along X, while the other parts shrink and are scaled up.
TEST(GuardSlope, IgnoresThePartAlongXUnlessTheGuardDependsOnIt) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const dynamics::GuardSlope impact{.gradient = {.tilt = 1.0}, .rate = -2.0};
  EXPECT_EQ(impact.delay({.tilt = 3.0, .slip = infinite}), 1.5);
  const dynamics::GuardSlope cell{.gradient = {.slip = 1.0}, .rate = 4.0};
  EXPECT_EQ(cell.delay({.tilt = 3.0, .slip = 2.0}), -0.5);
}

}  // namespace
}  // namespace rocking
