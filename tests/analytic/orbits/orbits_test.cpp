// Periodic orbits: Newton's method, multipliers, which orbits are one, and what has none.

#include "rocking/studies/orbits/orbits.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/realisation/exponent.hpp"
#include "rocking/realisation/fixed_point.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "support/event_log.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

using section::StrobePoint;
using support::shaken;

const Friction some_friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.30};

/// Conditions whose orbits rock, slip, slide and rest at the section.
std::vector<Condition> conditions() {
  return {shaken(4.5), shaken(4.5, some_friction), shaken(6.3, some_friction),
          shaken(2.0, Friction{.static_coefficient = 0.2, .kinetic_coefficient = 0.15}), shaken(0.8)};
}

std::string name_of(const Orbit& orbit) {
  return to_string(section::periodic(orbit.cycles, orbit.period)) + ' ' + std::string(to_string(orbit.stability.kind));
}

/// The largest constant c of r_{k+1} = c r_k^2 over the steps whose residuals are above rounding.
double largest_constant(const std::vector<double>& residuals) {
  double largest = 0.0;
  for (std::size_t k = 0; k + 1 < residuals.size(); ++k) {
    if (residuals[k] > 1e-2 || residuals[k] < 1e-7) continue;
    largest = std::max(largest, (residuals[k + 1] - 1e-14) / (residuals[k] * residuals[k]));
  }
  return largest;
}

// With a derivative that is wrong by a share d, r_{k+1} is about d r_k. At r_k = 1e-7 the bound allows d = 1e-3.
TEST(Orbits, AreReachedQuadratically) {
  int followed = 0;
  for (const Condition& condition : {conditions()[0], conditions()[1]}) {
    const PoincareMap map(condition);
    for (const Orbit& orbit : orbits_of(condition, 3).orbits) {
      StrobePoint start = orbit.points.front().point;
      start.tilt += 1e-4;
      start.tilt_rate -= 1e-4;
      const auto found = find_fixed_point(map, start, orbit.period);
      ASSERT_TRUE(found) << name_of(orbit);
      EXPECT_LE(found->residual, 1e-13);
      const auto above_rounding = std::ranges::count_if(found->residuals, [](double r) { return r > 1e-13; });
      EXPECT_LE(above_rounding, 6) << name_of(orbit);
      EXPECT_LT(largest_constant(found->residuals), 1e4) << name_of(orbit);
      EXPECT_LT(distance(found->point, orbit.points.front().point), 1e-11) << name_of(orbit);
      ++followed;
    }
  }
  EXPECT_GT(followed, 6);
}

/// Trace and determinant of the map from central differences of trajectories, which know nothing of tangents.
struct Invariants {
  double trace;
  double determinant;
};

Invariants invariants_from_outside(Condition condition, const Orbit& orbit) {
  constexpr double step = 1e-6;
  condition.tolerance = 1e-16;
  const StrobePoint& at = orbit.points.front().point;
  const auto end = [&](double tilt, double rate) {
    condition.scene.initial = {.tilt = at.tilt + tilt, .tilt_rate = at.tilt_rate + rate, .slip_rate = at.slip_rate};
    return trajectory_of(condition, 0, 0, orbit.period).strobe.back();
  };
  const auto difference = [&](double tilt, double rate) {
    const TrajectorySample a = end(tilt, rate);
    const TrajectorySample b = end(-tilt, -rate);
    return StrobePoint{.tilt = (a.tilt - b.tilt) / (2.0 * step),
                       .tilt_rate = (a.tilt_rate - b.tilt_rate) / (2.0 * step)};
  };
  const StrobePoint by_tilt = difference(step, 0.0);
  const StrobePoint by_rate = difference(0.0, step);
  return {.trace = by_tilt.tilt + by_rate.tilt_rate,
          .determinant = by_tilt.tilt * by_rate.tilt_rate - by_tilt.tilt_rate * by_rate.tilt};
}

TEST(Orbits, HaveTheMultipliersOfDifferencesOfTrajectories) {
  int compared = 0;
  for (const Condition& condition : conditions()) {
    for (const Orbit& orbit : orbits_of(condition, 3).orbits) {
      if (orbit.points.front().contact != dynamics::ContactState::rock) continue;
      const auto& multipliers = orbit.stability.multipliers;
      ASSERT_EQ(multipliers.size(), 2U);
      const Invariants found = invariants_from_outside(condition, orbit);
      const double size = std::max(1.0, std::abs(multipliers[0]));
      EXPECT_NEAR(found.trace, (multipliers[0] + multipliers[1]).real(), 1e-6 * size) << name_of(orbit);
      EXPECT_NEAR(found.determinant, (multipliers[0] * multipliers[1]).real(), 1e-6 * size) << name_of(orbit);
      ++compared;
    }
  }
  EXPECT_GT(compared, 10);
}

// The run of each condition is classified without knowing of orbits.
TEST(Orbits, ContainTheResponseOfTheRun) {
  for (const Condition& condition : conditions()) {
    const OrbitsOfCondition found = orbits_of(condition, 3);
    ASSERT_TRUE(found.run_on) << to_string(found.mode);
    const Orbit& orbit = found.orbits[*found.run_on];
    EXPECT_TRUE(orbit.stability.is_stable());
    if (found.mode.kind == section::ResponseKind::periodic) {
      EXPECT_EQ(found.mode, section::periodic(orbit.cycles, orbit.period));
    } else {
      EXPECT_EQ(found.mode.kind, section::ResponseKind::rest);
      EXPECT_EQ(orbit.points.front().contact, dynamics::ContactState::rest);
      EXPECT_EQ(orbit.stability.kind, OrbitKind::superstable);
    }
  }
}

TEST(Orbits, BackTheLabelOfARunThatIsOnTheWayToThem) {
  Condition condition;
  condition.horizon = {.transient_periods = 50, .sampled_periods = 30};
  condition.scene.block = {.width = 0.35, .height = 1.9};
  condition.scene.excitation = Harmonic{.physical_amplitude = PhysicalAmplitude{.value = 0.3},
                                        .physical_frequency = PhysicalFrequency{.value = 2.0}};
  const OrbitsOfCondition found = orbits_of(condition, 1);
  EXPECT_EQ(found.mode, section::periodic(1, 1));
  EXPECT_FALSE(found.run_on);
  EXPECT_EQ(found.is_certified(), true);
}

TEST(Orbits, HaveAChatterOnceWhereverAStrobeInstantCutsIt) {
  for (const double phase : {0.0, 1.0, 2.0}) {
    Condition condition;
    condition.horizon = {.transient_periods = 200, .sampled_periods = 120};
    condition.scene.block = {.width = 0.4, .height = 2.425};
    condition.scene.restitution = RateRatio{0.61};
    condition.scene.excitation = Harmonic{.amplitude = 1.093, .frequency_ratio = 2.198, .phase = phase};
    const OrbitsOfCondition found = orbits_of(condition, 1);
    EXPECT_EQ(found.mode, section::periodic(1, 1)) << phase;
    ASSERT_TRUE(found.run_on) << phase;
    EXPECT_EQ(found.orbits[*found.run_on].cycles, 1) << phase;
  }
}

TEST(Orbits, AreDistinctAndPairedWithTheirMirrorImages) {
  std::set<std::string> seen;
  std::size_t pairs = 0;
  for (const Condition& condition : conditions()) {
    const std::vector<Orbit> orbits = orbits_of(condition, 3).orbits;
    for (std::size_t i = 0; i < orbits.size(); ++i) {
      seen.insert(std::string(to_string(orbits[i].stability.kind)));
      seen.insert(std::string(to_string(orbits[i].points.front().contact)));
      for (std::size_t k = 1; k < orbits[i].points.size(); ++k) {  // its period is the smallest
        EXPECT_GT(distance(orbits[i].points[0].point, orbits[i].points[k].point), 1e-8) << name_of(orbits[i]);
      }
      for (std::size_t k = i + 1; k < orbits.size(); ++k) {
        EXPECT_FALSE(is_same_cycle(orbits[i].points, orbits[k].points)) << name_of(orbits[i]);
      }
      ASSERT_LT(orbits[i].mirror.value(), orbits.size());
      const Orbit& mirror = orbits[*orbits[i].mirror];
      EXPECT_EQ(orbits[i].is_symmetric, orbits[i].mirror == i);
      EXPECT_EQ(mirror.mirror, i);
      EXPECT_EQ(mirror.period, orbits[i].period);
      EXPECT_EQ(mirror.cycles, orbits[i].cycles);
      // The contact states at the section may differ, and with them the number of multipliers.
      const auto& ours = orbits[i].stability.multipliers;
      const auto& theirs = mirror.stability.multipliers;
      for (std::size_t k = 0; k < std::min(ours.size(), theirs.size()); ++k) {
        EXPECT_LT(std::abs(ours[k] - theirs[k]), 1e-8 * std::max(1.0, std::abs(ours[0]))) << name_of(orbits[i]);
      }
      pairs += orbits[i].mirror == i ? 0 : 1;
    }
  }
  EXPECT_GT(pairs, 3U);
  for (const char* name : {"focus", "saddle", "flip_saddle", "superstable", "rock", "rock_slide", "slide", "rest"}) {
    EXPECT_TRUE(seen.contains(name)) << name;
  }
}

TEST(Orbits, AreOneCycleWhicheverPointIsTheFirst) {
  const auto state = [](double tilt) {
    return SectionState{.point = {.tilt = tilt}, .contact = dynamics::ContactState::rock};
  };
  const std::vector<SectionState> cycle{state(0.1), state(0.2), state(0.3)};
  EXPECT_TRUE(is_same_cycle(cycle, {state(0.3), state(0.1), state(0.2 + 1e-10)}));
  EXPECT_FALSE(is_same_cycle(cycle, {state(0.3), state(0.2), state(0.1)}));
  EXPECT_FALSE(is_same_cycle(cycle, {state(0.1), state(0.2)}));
  EXPECT_FALSE(is_same_cycle(cycle, {state(0.1), state(0.2), state(0.3 + 1e-6)}));
}

TEST(Orbits, AreNamedByTheirMultipliers) {
  using namespace std::complex_literals;
  EXPECT_EQ(kind_of({}), OrbitKind::superstable);
  EXPECT_EQ(kind_of({0.0, 0.0}), OrbitKind::superstable);
  EXPECT_EQ(kind_of({-0.9, 0.5}), OrbitKind::node);
  EXPECT_EQ(kind_of({0.5 + 0.5i, 0.5 - 0.5i}), OrbitKind::focus);
  EXPECT_EQ(kind_of({1.5, 0.5}), OrbitKind::saddle);
  EXPECT_EQ(kind_of({-1.5, 0.5}), OrbitKind::flip_saddle);
  EXPECT_EQ(kind_of({-1.5, 1.2, 0.1}), OrbitKind::unstable_node);
  EXPECT_EQ(kind_of({1.0 + 0.5i, 1.0 - 0.5i, 0.1}), OrbitKind::unstable_focus);
}

// On a stable orbit a change falls by the largest multiplier per period. Over 400 periods the angle of a focus averages
// out to a few 1e-3.
TEST(Orbits, HaveTheExponentOfTheirMotion) {
  for (const Condition& condition : {shaken(4.5), shaken(4.5, some_friction)}) {
    const OrbitsOfCondition found = orbits_of(condition, 3);
    const Orbit& orbit = found.orbits.at(found.run_on.value());
    const StrobePoint& at = orbit.points.front().point;
    Condition start = condition;
    start.scene.initial = {.tilt = at.tilt, .tilt_rate = at.tilt_rate, .slip_rate = at.slip_rate};
    const random::Draws draws(0, 0);
    const Beginning beginning = begin_realisation(start, draws, start_of(start.scene, draws), Strobe::poincare, 1);
    support::EventLog log;
    Motion motion = motion_of(start.scene, beginning, log);
    integrate::advance(motion);
    TangentRun run(motion, beginning.setting.block.shape_angle, 400);
    section::PendingClassification pending;
    pending.may_be_decided_later = [](const section::ExponentEstimate&) { return false; };
    run_alone(run, pending);
    const auto exponent = run.result().exponent;
    ASSERT_TRUE(exponent);
    EXPECT_NEAR(exponent->exponent, std::log(std::abs(orbit.stability.multipliers[0])) / orbit.period, 5e-3)
        << name_of(orbit);
  }
}

std::string refusal_of(const Condition& condition) {
  Experiment experiment;
  experiment.conditions = {condition};
  try {
    check_orbits(experiment);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Orbits, AreRefusedWhereThereAreNone) {
  using ::testing::HasSubstr;
  EXPECT_EQ(refusal_of(shaken(4.5)), "");
  Condition fluctuating = shaken(4.5);
  fluctuating.scene.fluctuation.restitution = 0.01;
  EXPECT_THAT(refusal_of(fluctuating), HasSubstr("/fluctuation"));
  Condition drawn = shaken(4.5);
  drawn.scene.initial.tilt = Uniform{0.0, 0.1};
  EXPECT_THAT(refusal_of(drawn), HasSubstr("/initial/tilt"));
  Condition pulse = shaken(4.5);
  pulse.scene.excitation = Pulse{.amplitude = 4.5, .frequency_ratio = 10.0};
  EXPECT_THAT(refusal_of(pulse), HasSubstr("/excitation/kind"));
}

}  // namespace
}  // namespace rocking
