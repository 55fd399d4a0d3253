// Two events at one instant: a slip that stops as the block lands, and slip that begins in an impact. Neighbouring
// initial states, a unit in the last place apart, lead to one order or the other, or to simultaneous events; the motion
// afterwards must be the same.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "support/scripted_coefficients.hpp"
#include "support/simulation.hpp"
#include "support/split_mix.hpp"

namespace rocking::dynamics {
namespace {

using support::ScriptedCoefficients;
using support::SplitMix;
using support::Stage;
using ScriptedRun = support::Simulation<ScriptedCoefficients>;

/// Bisects [low, high] until the two are neighbours, with `claim` false at low and true at high; returns high.
template <class Claim>
double first_true(double low, double high, Claim&& claim) {
  for (double middle = 0.5 * (low + high); middle != low && middle != high; middle = 0.5 * (low + high)) {
    (claim(middle) ? high : low) = middle;
  }
  return high;
}

/// A block that lands while its slip decelerates on a base at rest.
struct Landing {
  Stage stage;
  double side;

  ScriptedRun* run_at(double speed, std::optional<ScriptedRun>& run) const {
    Stage at = stage;
    at.start.slip_rate = side * speed;
    run.emplace(at, ScriptedCoefficients{.statics = {0.9}, .kinetics = {0.1}});
    run->run();
    return &*run;
  }
};

// The times of the stop and the landing differ by 7.5 per unit of slip rate; within the clock's resolution they are
// simultaneous. The tilt rate in the impact is the same in all cases: V1 is below the resolution times V' < 1.
TEST(ImpactAndStop, LeaveTheSameMotionInEitherOrderAndTogether) {
  int orders[2] = {0, 0};
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SplitMix draw(seed);
    Landing landing{.stage = {.block = {.height = draw.uniform(3.0, 8.0)}}, .side = draw.below(2) == 0 ? 1.0 : -1.0};
    landing.stage.start = {.tilt = landing.side * draw.uniform(0.001, 0.02),
                           .tilt_rate = -landing.side * draw.uniform(0.1, 0.4)};
    std::optional<ScriptedRun> run;
    const double boundary = first_true(0.0, 1.0, [&](double speed) {
      return landing.run_at(speed, run)->log.events.at(0).kind != EventKind::slip_stop;
    });
    std::optional<State> first;
    for (int ulps = -60; ulps <= 60; ++ulps) {
      const double speed = boundary + ulps * 0x1p-53 * boundary;
      const testing::ScopedTrace trace(__FILE__, __LINE__,
                                       "seed " + std::to_string(seed) + ", " + std::to_string(ulps));
      const auto& log = landing.run_at(speed, run)->log;
      const std::size_t impact = log.events.at(0).kind == EventKind::slip_stop ? 1 : 0;
      ++orders[impact];
      ASSERT_EQ(log.events.at(impact).kind, EventKind::impact_stick) << log.story().substr(0, 100);
      ASSERT_EQ(run->motion.coefficients().stops, 1U) << "one stop, whoever ends the slip";
      const State& after = log.events[impact].state;
      ASSERT_EQ(after.slip_rate, 0.0);
      if (!first) first = after;
      worst = std::max(worst, std::abs(after.tilt_rate - first->tilt_rate));
      ASSERT_NEAR(after.tilt_rate, first->tilt_rate, 2.0 * landing.stage.period_length() * 0x1p-49);
      ASSERT_NEAR(after.slip, first->slip, 1e-15);
    }
  }
  EXPECT_GT(orders[0], 0);
  EXPECT_GT(orders[1], 0);
  RecordProperty("worst", std::to_string(worst * 1e15));
}

/// A block that lands on a moving base; slip may begin right after the impact.
struct Onset {
  Stage stage;
  double static_friction;
  double kinetic_friction;

  ScriptedRun* run_at(double amplitude, std::optional<ScriptedRun>& run) const {
    run.emplace(stage, ScriptedCoefficients{
                           .amplitude_value = amplitude, .statics = {static_friction}, .kinetics = {kinetic_friction}});
    run->run();
    return &*run;
  }
};

/// Whether slip starts at the instant of a sticking impact, which must be the first event. Absent otherwise.
std::optional<bool> slips_at_once(const support::EventLog& log) {
  if (log.events.size() < 2 || log.events[0].kind != EventKind::impact_stick) return std::nullopt;
  return log.events[1].kind == EventKind::slip_start && log.events[1].tau == log.events[0].tau;
}

// The friction required right after the impact equals mu_s to a unit in the last place. With mu_k = mu_s slip begins
// without acceleration. Whether it begins or not, the state a period later is the same except for roundings, which grow
// by less than 1e3.
TEST(OnsetOfSlipInTheImpact, AtTheLimitToTheUlpIsNeitherAContradictionNorAJump) {
  int found = 0;
  double worst = 0.0;
  for (std::uint64_t seed = 0; seed < 600; ++seed) {
    SplitMix draw(seed);
    const double mu = draw.uniform(0.25, 0.6);
    const bool equal = draw.below(4) != 0;
    Onset onset{.stage = {.block = {.height = draw.uniform(2.0, 6.0)}, .phase = draw.uniform(0.0, 6.28)},
                .static_friction = mu,
                .kinetic_friction = equal ? mu : 0.9 * mu};
    onset.stage.start = {.tilt = draw.uniform(0.001, 0.03), .tilt_rate = -draw.uniform(0.05, 0.4)};
    std::optional<ScriptedRun> run;
    for (double amplitude = 0.0; amplitude < 12.0; amplitude += 0.5) {
      const auto here = slips_at_once(onset.run_at(amplitude, run)->log);
      const auto next = slips_at_once(onset.run_at(amplitude + 0.5, run)->log);
      if (!here || !next || *here == *next) continue;
      const double boundary = first_true(amplitude, amplitude + 0.5, [&](double at) {
        return slips_at_once(onset.run_at(at, run)->log).value_or(*here) != *here;
      });
      ++found;
      std::optional<State> first;
      for (int ulps = -6; ulps <= 6; ++ulps) {
        const testing::ScopedTrace trace(__FILE__, __LINE__,
                                         "seed " + std::to_string(seed) + ", " + std::to_string(ulps));
        onset.run_at(boundary + ulps * 0x1p-52 * boundary, run);
        ASSERT_EQ(run->motion.contradictions(), 0U) << run->log.story().substr(0, 200);
        ASSERT_EQ(run->motion.termination(), Termination::reached_horizon);
        const State end = run->log.strobes.back();
        if (!first) first = end;
        if (!equal) continue;
        worst = std::max(worst, std::abs(end.tilt_rate - first->tilt_rate));
        ASSERT_NEAR(end.tilt_rate, first->tilt_rate, 1e-12);
        ASSERT_NEAR(end.tilt, first->tilt, 1e-12);
        ASSERT_NEAR(end.slip, first->slip, 1e-12);
      }
    }
  }
  EXPECT_GT(found, 50);
  RecordProperty("worst", std::to_string(worst * 1e15) + ", found " + std::to_string(found));
}

}  // namespace
}  // namespace rocking::dynamics
