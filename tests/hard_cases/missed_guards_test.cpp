// No guard crossing is missed: a million steps of random motions, computed as in a run, compared with a dense
// evaluation of every guard over the whole time of each step.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/realisation/horizon_run.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/realisation_scheduler.hpp"
#include "support/excitation.hpp"
#include "support/guard_watch.hpp"
#include "support/random_scene.hpp"
#include "support/watched_motion.hpp"

namespace rocking {
namespace {

using support::GuardTally;
using support::SplitMix;

constexpr std::array<std::string_view, dynamics::guard_count> guard_names{
    "overturn",   "determinant",  "tilt",   "slip", "friction_inward", "friction_outward", "leave_right",
    "leave_left", "past_balance", "normal", "cell", "slip_presses"};

constexpr int horizon_periods = 34;
#if ROCKING_CONTRACTS  // and sanitizers: five times as long a step
constexpr std::uint64_t watched_steps = 200'000;
#else
constexpr std::uint64_t watched_steps = 1'000'000;
#endif

/// A broken line with unevenly spaced knots and occasional jumps; two in three with a vertical motion.
GroundMotion random_ground_motion(const Scene& scene, SplitMix& draw) {
  GroundMotion motion{.samples = {}, .has_vertical = draw.below(3) != 0};
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  const double period = 2.0 * std::numbers::pi / support::mean_frequency_ratio(scene) / block.frequency_parameter;
  const bool leaves_the_ground = draw.below(2) == 0;
  const double strongest = leaves_the_ground ? draw.uniform(0.8, 2.0) : draw.uniform(0.05, 0.4);
  for (double time = 0.0; time < horizon_periods * period;) {
    motion.samples.push_back({time, block.shape_angle * draw.uniform(-1.0, 1.0), draw.uniform(-strongest, strongest)});
    if (draw.below(5) != 0) time += draw.uniform(0.05, 0.6) * period;
  }
  return motion;
}

/// A squat block with high friction, thrown over the slipping edge: D may become zero on the way.
void throw_over(Scene& scene, SplitMix& draw) {
  const double side = draw.below(2) == 0 ? 1.0 : -1.0;
  scene.block.height = draw.uniform(1.0, 1.6);
  scene.slide_inertia = dynamics::SlideInertia::centroidal;
  support::harmonic(scene).amplitude = support::spread(draw, 0.01, 2.0);
  scene.friction = Friction{.static_coefficient = 2.0, .kinetic_coefficient = draw.uniform(1.3, 1.7)};
  scene.initial.tilt = side * draw.uniform(0.0, 0.3);
  scene.initial.slip_rate = -side * draw.uniform(2.0, 6.0);
}

/// Squat and slender blocks, all formulations, every effect on and off, tolerances over ten decades; every fourth base
/// motion is recorded, and every fourth friction belongs to the place.
Condition random_condition(std::uint64_t number) {
  SplitMix draw(number);
  Condition condition;
  Scene& scene = condition.scene;
  scene = support::random_scene(draw, 0.5, 16.0);
  condition.tolerance = support::spread(draw, 1e-15, 1e-5);
  condition.horizon = {.transient_periods = 4, .sampled_periods = horizon_periods - 4};
  scene.fluctuation.refreshes_per_period = std::array{1, 8, 100, 200}[static_cast<std::size_t>(draw.below(4))];
  if (draw.below(8) == 0) throw_over(scene, draw);
  if (draw.below(4) == 0) {
    const double frequency = support::mean_frequency_ratio(scene);
    scene.excitation = support::recorded_by(random_ground_motion(scene, draw), frequency, size_of(scene.excitation));
  }
  if (number % 4 == 1 && scene.friction) {
    scene.fluctuation.kinetic_friction = std::max(scene.fluctuation.kinetic_friction, 0.02);
    scene.fluctuation.refresh_slip_m = support::spread(draw, 0.1, 1.0) * mean_of(scene.block).height;
  }
  return condition;
}

constexpr std::uint64_t seed = 0x2012;

/// Runs a realisation of a condition as run_alone does. The motion is watched, except where it is run again with tangent
/// vectors.
RealisationResult run_watched(const Condition& condition, std::uint64_t realisation, GuardTally& tally,
                              const integrate::FiredGuards& overlooked = {}) {
  const random::Draws draws(seed, realisation);
  const Beginning beginning = begin_realisation(condition, draws, start_of(condition.scene, draws), Strobe::poincare,
                                                strobes_before_window(condition));
  HorizonRun run(condition, draws, beginning,
                 [&](dynamics::Observer& observer) { return motion_of(condition.scene, beginning, observer); });
  support::GuardWatch<Motion> watch(beginning.setting, run.motion().excitation().has_vertical(), tally);
  support::WatchedMotion watched(run.motion(), watch, overlooked);
  do {
    while (!run.motion().ended() || run.go_on()) integrate::step(watched, run.counts());
    if (TangentRun* tangents = run.classify()) run_alone(*tangents, run.pending());
  } while (run.begin_next_window());
  return run.finish();
}

/// The result of a realisation, and the steps and searches that it needed.
std::string outcome_of(const RealisationResult& result) {
  return base::to_hex(digest_of(result, 0)) + " " + std::to_string(result.operations.steps) + " steps, " +
         std::to_string(result.operations.root_isolations) + " isolations";
}

std::string spelled(const GuardTally& tally) {
  std::string text = std::to_string(tally.steps) + " steps, " + std::to_string(tally.ended_by_event) + " to an event\n";
  for (std::size_t guard = 0; guard < guard_names.size(); ++guard) {
    const support::GuardSteps& seen = tally.guards[guard];
    text += std::string(guard_names[guard]) + ": armed " + std::to_string(seen.armed) + ", spared " +
            std::to_string(seen.spared) + ", fired " + std::to_string(seen.fired) + ", missed " +
            std::to_string(seen.missed) + ", unarmed " + std::to_string(seen.unarmed) + ", unlike " +
            std::to_string(seen.unlike) + ", made up " + std::to_string(seen.made_up) + "\n";
  }
  return text;
}

/// Compares with the same realisations advanced together in lanes.
void expect_the_same_in_lanes(const lanes::Kernels& kernels, const std::vector<Condition>& conditions,
                              const std::vector<std::string>& outcomes) {
  RealisationScheduler scheduler(seed, kernels);
  for (std::size_t next = 0; next < conditions.size() || !scheduler.is_idle();) {
    for (; next < conditions.size() && scheduler.wants_more(); ++next) {
      scheduler.start({&conditions[next], next}, next);
    }
    for (const auto& [id, result] : scheduler.work()) {
      ASSERT_EQ(outcome_of(result), outcomes[id]) << "random_condition(" << id << "), " << kernels.name;
    }
  }
}

// Lanes cannot be watched step by step. If strobe points and counts are equal, their steps are the same.
TEST(GuardCrossing, IsNeverMissedInAMillionStepsOfRandomMotions) {
  GuardTally tally;
  std::vector<Condition> conditions;
  std::vector<std::string> outcomes;
  while (tally.steps < watched_steps) {
    const std::uint64_t number = conditions.size();
    conditions.push_back(random_condition(number));
    outcomes.push_back(outcome_of(run_watched(conditions.back(), number, tally)));
    ASSERT_EQ(tally.offences(), 0U) << "random_condition(" << number << ")\n" << spelled(tally);
  }
  for (std::size_t guard = 0; guard < guard_names.size(); ++guard) {
    // A block seldom sticks off the ground, and not for long.
    const bool is_rare = guard == static_cast<std::size_t>(dynamics::Guard::slip_presses);
    EXPECT_GE(tally.guards[guard].armed, watched_steps / (is_rare ? 20'000 : 2'000)) << spelled(tally);
    EXPECT_GE(tally.guards[guard].fired, watched_steps / (is_rare ? 100'000 : 50'000)) << spelled(tally);
  }
  EXPECT_GE(tally.ended_by_event, watched_steps / 10) << spelled(tally);
  expect_the_same_in_lanes(lanes::available_kernels().front(), conditions, outcomes);
  expect_the_same_in_lanes(lanes::available_kernels().back(), conditions, outcomes);
}

/// An integrator that does not see one guard.
class OverlookedGuard : public testing::TestWithParam<std::size_t> {};

TEST_P(OverlookedGuard, IsNoticed) {
  const integrate::FiredGuards overlooked(1U << GetParam());
  GuardTally tally;
  for (std::uint64_t number = 0; number < 1'000 && tally.offences() == 0; ++number) {
    static_cast<void>(run_watched(random_condition(number), number, tally, overlooked));
  }
  EXPECT_GT(tally.guards[GetParam()].missed, 0U) << guard_names[GetParam()];
}

INSTANTIATE_TEST_SUITE_P(GuardCrossing, OverlookedGuard, testing::Range<std::size_t>(0, dynamics::guard_count));

}  // namespace
}  // namespace rocking
