// The tangent flow: derivatives of a motion with respect to its initial state, against closed forms and against
// differences of the flow itself.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "rocking/dynamics/impact.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/realisation/tangent_motion.hpp"
#include "support/event_log.hpp"
#include "support/excitation.hpp"
#include "support/random_scene.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using Tangent = dynamics::Tangent<double>;
using Whole = TangentMotion<Motion, 4>;

const Whole::Tangents unit_vectors{{{.tilt = 1.0}, {.tilt_rate = 1.0}, {.slip = 1.0}, {.slip_rate = 1.0}}};

std::array<double, 4> components(const Tangent& tangent) {
  return {tangent.tilt, tangent.tilt_rate, tangent.slip, tangent.slip_rate};
}

double largest(const Whole::Tangents& tangents) {
  double most = 0.0;
  for (const Tangent& tangent : tangents) {
    for (const double component : components(tangent)) most = std::max(most, std::abs(component));
  }
  return most;
}

/// A motion over some periods, and its tangent vectors at the end.
struct Flow {
  support::EventLog log;
  Whole::Tangents tangents{};
  NotDifferentiable not_differentiable;
  dynamics::State start;
  int periods = 0;
  std::optional<dynamics::Termination> termination;

  [[nodiscard]] const dynamics::State& end() const { return log.strobes.back(); }
  [[nodiscard]] bool reached_end() const { return termination == dynamics::Termination::reached_horizon; }
};

/// From `change` besides the initial state of the realisation [rad]. The tolerance is far below rounding, so that
/// differences of two motions are those of the flow.
Flow flow_of(const Scene& scene, std::uint64_t seed, int periods, const Tangent& change = {}) {
  Condition condition;
  condition.scene = scene;
  condition.tolerance = 1e-17;
  const random::Draws draws(seed, 0);
  Start start = start_of(scene, draws);
  start.state.tilt += change.tilt;
  start.state.tilt_rate += change.tilt_rate;
  start.state.slip += change.slip;
  start.state.slip_rate += change.slip_rate;
  const Beginning beginning = begin_realisation(condition, draws, start, Strobe::start, periods);
  Flow flow;
  flow.periods = periods;
  Whole motion(motion_of(scene, beginning, flow.log), unit_vectors);
  flow.start = motion.state();
  integrate::advance(motion);
  flow.tangents = motion.at_strobe();
  flow.not_differentiable = motion.not_differentiable();
  flow.termination = motion.termination();
  return flow;
}

Tangent difference(const dynamics::State& a, const dynamics::State& b, double step) {
  return {.tilt = (a.tilt - b.tilt) / (2.0 * step),
          .tilt_rate = (a.tilt_rate - b.tilt_rate) / (2.0 * step),
          .slip = (a.slip - b.slip) / (2.0 * step),
          .slip_rate = (a.slip_rate - b.slip_rate) / (2.0 * step)};
}

/// Central difference of the flow with step h, extrapolated from those with h and 2 h; absent if the events of two
/// motions are not the same.
struct Difference {
  const Scene& scene;
  std::uint64_t seed;
  int periods;
  std::string story;

  [[nodiscard]] std::optional<Tangent> central(const Tangent& direction, double step) const {
    const Flow ahead = flow_of(scene, seed, periods, plus(Tangent{}, step, direction));
    const Flow behind = flow_of(scene, seed, periods, plus(Tangent{}, -step, direction));
    const bool same = ahead.log.story() == story && behind.log.story() == story;
    if (!same || !ahead.reached_end() || !behind.reached_end()) return std::nullopt;
    return difference(ahead.end(), behind.end(), step);
  }

  [[nodiscard]] std::optional<Tangent> extrapolated(const Tangent& direction, double step) const {
    const auto fine = central(direction, step);
    const auto coarse = central(direction, 2.0 * step);
    if (!fine || !coarse) return std::nullopt;
    return plus(plus(Tangent{}, 4.0 / 3.0, *fine), -1.0 / 3.0, *coarse);
  }
};

/// Largest difference between the tangent vectors and such differences, relative to the largest component. On theta = 0
/// the two signs of a change of theta are on different sides of an impact, so that it is left out.
std::optional<double> error_of(const Flow& flow, const Scene& scene, std::uint64_t seed, double step) {
  const Difference flows{.scene = scene, .seed = seed, .periods = flow.periods, .story = flow.log.story()};
  double error = 0.0;
  for (std::size_t i = flow.start.tilt == 0.0 ? 1 : 0; i < 4; ++i) {
    const auto found = flows.extrapolated(within_contact(unit_vectors[i], flow.start), step);
    if (!found) return std::nullopt;
    const auto exact = components(flow.tangents[i]);
    for (std::size_t k = 0; k < 4; ++k) error = std::max(error, std::abs(components(*found)[k] - exact[k]));
  }
  return error / std::max(1.0, largest(flow.tangents));
}

// Every formulation, every fluctuation, every event but the last. Where a motion comes near to grazing, its derivatives
// of higher order are so large that only a smaller step shows the first one; there rounding leaves 1e-7.
TEST(TangentFlow, IsTheDerivativeOfTheFlow) {
  int compared = 0;
  int slipping_under_fluctuation = 0;
  int coarse = 0;
  std::array<int, dynamics::event_kind_count> kinds{};
  for (std::uint64_t seed = 0; seed < 1200; ++seed) {
    support::SplitMix random(seed);
    const Scene scene = support::random_scene(random);
    const Flow flow = flow_of(scene, seed, 1 + random.below(3));
    if (!flow.reached_end() || flow.not_differentiable.any()) continue;
    const auto error = error_of(flow, scene, seed, 1e-6);
    if (!error) continue;
    ++compared;
    for (const auto& event : flow.log.events) ++kinds[static_cast<std::size_t>(event.kind)];
    if (is_random(scene) && flow.log.count(dynamics::EventKind::slip_start) > 0) ++slipping_under_fluctuation;
    if (*error <= 1e-8) continue;
    ++coarse;
    const double finer =
        std::min(error_of(flow, scene, seed, 1e-7).value_or(1.0), error_of(flow, scene, seed, 1e-8).value_or(1.0));
    EXPECT_LT(finer, 1e-7) << "seed " << seed << ", " << *error << " at 1e-6: " << flow.log.story();
  }
  std::printf("compared %d, of which at a finer step %d\n", compared, coarse);
  EXPECT_GT(compared, 600);
  EXPECT_LT(coarse, compared / 50);
  EXPECT_GT(slipping_under_fluctuation, 20);
  for (std::size_t k = 0; k + 1 < kinds.size(); ++k) {
    EXPECT_GT(kinds[k], 5) << to_string(static_cast<dynamics::EventKind>(k));
  }
}

TEST(TangentFlow, IsTheDerivativeOfTheFlowOfBlocksWithTheirMassOffTheMiddle) {
  int compared = 0;
  std::array<int, dynamics::event_kind_count> kinds{};
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    support::SplitMix random(seed);
    Scene scene = support::random_scene(random);
    const double height = mean_of(scene.block).height;
    scene.block.mass = GivenEdges{.edges = {height * random.uniform(0.05, 0.3), height * random.uniform(0.05, 0.3)},
                                  .centre_height = height * random.uniform(0.3, 0.7),
                                  .radius_of_gyration = height * random.uniform(0.2, 0.5)};
    const Flow flow = flow_of(scene, seed, 1 + random.below(3));
    if (!flow.reached_end() || flow.not_differentiable.any()) continue;
    const auto error = error_of(flow, scene, seed, 1e-6);
    if (!error) continue;
    ++compared;
    for (const auto& event : flow.log.events) ++kinds[static_cast<std::size_t>(event.kind)];
    if (*error <= 1e-8) continue;
    const double finer =
        std::min(error_of(flow, scene, seed, 1e-7).value_or(1.0), error_of(flow, scene, seed, 1e-8).value_or(1.0));
    EXPECT_LT(finer, 1e-7) << "seed " << seed << ", " << *error << " at 1e-6: " << flow.log.story();
  }
  EXPECT_GT(compared, 250);
  for (const auto kind : {dynamics::EventKind::impact_stick, dynamics::EventKind::impact_slip,
                          dynamics::EventKind::slip_start, dynamics::EventKind::slip_stop, dynamics::EventKind::lift}) {
    EXPECT_GT(kinds[static_cast<std::size_t>(kind)], 5) << to_string(kind);
  }
}

// At the end of a cell friction jumps at an instant that depends on the state.
TEST(TangentFlow, KnowsTheJumpAtTheEndOfACellOfFriction) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 900; ++seed) {
    support::SplitMix random(seed);
    Scene scene = support::random_scene(random);
    if (!scene.friction) continue;
    scene.slide_inertia = dynamics::SlideInertia::centroidal;
    scene.fluctuation.static_friction = scene.fluctuation.kinetic_friction = 0.03;
    scene.fluctuation.friction_correlation = 1.0;
    scene.fluctuation.refresh_slip_m = random.uniform(0.001, 0.02) * mean_of(scene.block).height;
    const Flow flow = flow_of(scene, seed, 1 + random.below(2));
    const bool crosses = std::ranges::any_of(flow.log.strobes,
                                             [&](const dynamics::State& state) { return std::abs(state.slip) > 0.02; });
    if (!flow.reached_end() || flow.not_differentiable.any() || !crosses) continue;
    const auto error = error_of(flow, scene, seed, 1e-7);
    if (!error) continue;
    ++compared;
    const double finer = std::min(*error, error_of(flow, scene, seed, 1e-8).value_or(1.0));
    EXPECT_LT(finer, 1e-6) << "seed " << seed << ": " << flow.log.story();
  }
  EXPECT_GT(compared, 60);
}

/// A block that cannot slide.
Scene sticking_scene(double amplitude) {
  Scene scene;
  support::harmonic(scene) = {.amplitude = amplitude, .frequency_ratio = 10.0, .phase = 0.3};
  scene.initial = {.tilt = 0.2, .tilt_rate = -0.1, .slip_rate = 0.0};
  return scene;
}

// The flow between impacts keeps the area in (theta, w); an impact multiplies it by delta^2.
TEST(TangentFlow, ShrinksTheAreaByTheSquareOfDeltaAtEachImpact) {
  for (const double amplitude : {2.5, 4.5, 6.5}) {
    const Scene scene = sticking_scene(amplitude);
    const double delta = dynamics::inelastic_rate_ratio(dynamics::geometry_of(mean_block(scene)));
    for (const int periods : {1, 3, 9}) {
      const Flow flow = flow_of(scene, 0, periods);
      ASSERT_TRUE(flow.reached_end());
      const auto impacts = static_cast<double>(flow.log.count(dynamics::EventKind::impact_stick));
      ASSERT_EQ(flow.log.events.size(), flow.log.count(dynamics::EventKind::impact_stick));
      const Tangent& a = flow.tangents[0];
      const Tangent& b = flow.tangents[1];
      const double area = a.tilt * b.tilt_rate - a.tilt_rate * b.tilt;
      const double size = std::abs(a.tilt * b.tilt_rate) + std::abs(a.tilt_rate * b.tilt);
      EXPECT_NEAR(area, std::pow(delta, 2.0 * impacts), 1e-12 * std::max(1.0, size)) << amplitude << ", " << periods;
    }
  }
}

// Theta, w, X and V change their signs together; the matrix between them does not.
TEST(TangentFlow, IsTheSameForTheMirrorImage) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    support::SplitMix random(seed);
    Scene scene = support::random_scene(random);
    scene.fluctuation.amplitude = 0.0;  // the mirror image has a negative amplitude, which a draw would be clamped to 0
    const Flow flow = flow_of(scene, seed, 2);
    support::harmonic(scene).amplitude = -mean_of(support::harmonic(scene).amplitude);
    for (Quantity* quantity : {&scene.initial.tilt, &scene.initial.tilt_rate, &scene.initial.slip_rate}) {
      quantity->emplace<double>(-std::get<double>(*quantity));
    }
    const Flow mirrored = flow_of(scene, seed, 2);
    if (!flow.reached_end() || flow.log.story() != mirrored.log.story()) continue;
    ++compared;
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_NEAR(components(flow.tangents[i])[k], components(mirrored.tangents[i])[k],
                    1e-11 * std::max(1.0, largest(flow.tangents)))
            << seed;
      }
    }
  }
  EXPECT_GT(compared, 50);
}

// One vector is computed by a solution of its own, several by two common ones.
TEST(TangentFlow, IsTheSameForOneVector) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    support::SplitMix random(seed);
    Condition condition;
    condition.scene = support::random_scene(random);
    const random::Draws draws(seed, 0);
    const Start start = start_of(condition.scene, draws);
    const Beginning beginning = begin_realisation(condition, draws, start, Strobe::start, 2);
    support::EventLog log;
    const Tangent both{.tilt = 0.6, .tilt_rate = -0.8, .slip_rate = 0.5};
    TangentMotion<Motion, 1> one(motion_of(condition.scene, beginning, log), {both});
    TangentMotion<Motion, 3> three(motion_of(condition.scene, beginning, log),
                                   {{both, {.tilt = 1.0}, {.tilt_rate = 1.0}}});
    integrate::advance(one);
    integrate::advance(three);
    if (one.termination() != dynamics::Termination::reached_horizon) continue;
    ++compared;
    const auto exact = components(three.at_strobe()[0]);
    double size = 1.0;
    for (const Tangent& tangent : three.at_strobe()) {
      for (const double component : components(tangent)) size = std::max(size, std::abs(component));
    }
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_NEAR(components(one.at_strobe()[0])[k], exact[k], 1e-10 * size) << seed;
    }
  }
  EXPECT_GT(compared, 200);
}

TEST(TangentFlow, LeavesTheBitsOfTheMotionAlone) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    support::SplitMix random(seed);
    Condition condition;
    condition.scene = support::random_scene(random);
    const random::Draws draws(seed, 0);
    const Start start = start_of(condition.scene, draws);
    const Beginning beginning = begin_realisation(condition, draws, start, Strobe::poincare, 4);
    support::EventLog plain_log;
    Motion plain = motion_of(condition.scene, beginning, plain_log);
    const integrate::LoopCounts plain_counts = integrate::advance(plain);
    support::EventLog log;
    Whole motion(motion_of(condition.scene, beginning, log), unit_vectors);
    const integrate::LoopCounts counts = integrate::advance(motion);
    EXPECT_EQ(counts.steps, plain_counts.steps);
    EXPECT_EQ(log.story(), plain_log.story());
    ASSERT_EQ(log.strobes.size(), plain_log.strobes.size());
    for (std::size_t k = 0; k < log.strobes.size(); ++k) {
      EXPECT_EQ(log.strobes[k].tilt, plain_log.strobes[k].tilt);
      EXPECT_EQ(log.strobes[k].tilt_rate, plain_log.strobes[k].tilt_rate);
      EXPECT_EQ(log.strobes[k].slip, plain_log.strobes[k].slip);
      EXPECT_EQ(log.strobes[k].slip_rate, plain_log.strobes[k].slip_rate);
    }
    ASSERT_EQ(log.events.size(), plain_log.events.size());
    for (std::size_t k = 0; k < log.events.size(); ++k) EXPECT_EQ(log.events[k].tau, plain_log.events[k].tau);
  }
}

}  // namespace
}  // namespace rocking
