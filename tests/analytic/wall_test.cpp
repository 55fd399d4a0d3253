// Blocks at a wall, beside closed forms: they turn away from it only, and come back with a share of the tilt rate.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "analytic/motion.hpp"
#include "rocking/api/experiment.hpp"
#include "rocking/base/error.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

using dynamics::EventKind;

/// A rectangle released from rest at a tilt, at a wall.
Condition released(dynamics::Side wall, double rate_ratio, double tilt) {
  Condition condition = support::shaken(0.0);
  condition.scene.block.wall = wall;
  condition.scene.restitution = WallRatio{rate_ratio};
  condition.scene.initial.tilt = tilt;
  condition.horizon = {.transient_periods = 0, .sampled_periods = 60};
  return condition;
}

std::vector<TrajectoryEvent> impacts_of(const Trajectory& trajectory) {
  std::vector<TrajectoryEvent> impacts;
  for (const TrajectoryEvent& event : trajectory.events) {
    if (event.kind == EventKind::impact_stick) impacts.push_back(event);
  }
  return impacts;
}

// The first impact comes after the quarter of a swing of free rocking, and each leaves e_w^2 of the energy.
TEST(Wall, SendsBackAShareOfTheTiltRate) {
  for (const dynamics::Side wall : {dynamics::Side::left, dynamics::Side::right}) {
    for (const double ratio : {0.3, 0.8}) {
      const double side = wall == dynamics::Side::right ? 1.0 : -1.0;
      const Condition condition = released(wall, ratio, 0.5 * side);
      const double psi = dynamics::geometry_of(mean_block(condition.scene)).shape_angle;
      const std::vector<TrajectoryEvent> impacts = impacts_of(run(condition, 60));
      ASSERT_GT(impacts.size(), 3U);
      EXPECT_NEAR(impacts[0].tau, falling_time(0.5 * psi, psi), 1e-12);
      const double energy = std::cos(0.5 * psi) - std::cos(psi);  // w^2/2 at the impact
      for (int n = 1; n <= 3; ++n) {
        const double rate = impacts[static_cast<std::size_t>(n) - 1].tilt_rate * psi;
        EXPECT_GT(side * rate, 0.0) << "away from the wall";
        EXPECT_NEAR(rate * rate / 2.0, std::pow(ratio, 2 * n) * energy, 1e-13);
      }
    }
  }
}

TEST(Wall, BringsABlockToRestInAFiniteTime) {
  const Trajectory trajectory = run(released(dynamics::Side::right, 0.6, 0.7), 60);
  const auto rests = std::ranges::find(trajectory.events, EventKind::to_rest, &TrajectoryEvent::kind);
  ASSERT_NE(rests, trajectory.events.end());
  EXPECT_EQ(trajectory.strobe.back().tilt, 0.0);
  const std::vector<TrajectoryEvent> hops = impacts_of(trajectory);
  // Late hops last 2 w/sin(psi), each e_w of the one before: the rest comes after the sum of their series.
  const double psi = dynamics::geometry_of({}).shape_angle;
  const auto& late = hops[12];
  const double next = 2.0 * std::abs(late.tilt_rate * psi) / std::sin(psi);
  EXPECT_NEAR(rests->tau - late.tau, next / (1.0 - 0.6), 1e-3 * next);
  EXPECT_EQ(impacts_of(run(released(dynamics::Side::right, 0.0, 0.7), 60)).size(), 1U) << "it stays at once";
}

// e_w = 0 follows from a restitution, to rounding. The block stays all the same, and lifts anew where the base pushes it.
TEST(Wall, LeavesNoRateAtARatioOfZero) {
  for (double height = 2.0; height < 6.0; height += 0.25) {
    Condition condition = released(dynamics::Side::right, 0.0, 0.2);
    condition.scene.block.height = height;
    condition.scene.initial.tilt_rate = -2.0;
    const double push = 1.1 / height;  // tan(psi) is 1/height
    condition.scene.excitation = support::recorded_by({.samples = {{0.0, push, 0.0}, {9.0, push, 0.0}}}, 10.0);
    const std::vector<TrajectoryEvent> events = run(condition, 2).events;
    ASSERT_GE(events.size(), 2U) << height;
    EXPECT_EQ(events[0].tilt_rate, 0.0) << height;
    EXPECT_EQ(events[1].kind, EventKind::lift) << height;
    EXPECT_EQ(events[1].tau, events[0].tau) << height;
  }
}

TEST(Wall, HoldsABlockThatIsPressedAgainstItWhateverTheAcceleration) {
  const auto pushed = [](double acceleration, dynamics::Side wall) {
    Condition condition = released(wall, 0.5, 0.0);
    condition.scene.excitation =
        support::recorded_by({.samples = {{0.0, acceleration, 0.0}, {0.2, acceleration, 0.0}, {0.21, 0.0, 0.0}}}, 10.0);
    return realise(condition, 1, 0).peaks.tilt;
  };
  // tan(psi) is 0.25. A base that accelerates to the right turns the block to the left.
  EXPECT_EQ(pushed(5.0, dynamics::Side::left), 0.0);
  EXPECT_EQ(pushed(-5.0, dynamics::Side::right), 0.0);
  EXPECT_EQ(pushed(0.2499, dynamics::Side::right), 0.0);
  EXPECT_GT(pushed(0.2501, dynamics::Side::right), 0.0);
  EXPECT_GT(pushed(-0.2501, dynamics::Side::left), 0.0);
  EXPECT_EQ(pushed(0.26, dynamics::Side::right), pushed(-0.26, dynamics::Side::left)) << "the mirror image";
}

TEST(Wall, NeverLetsABlockTurnIntoIt) {
  for (const double amplitude : {2.0, 5.0, 9.0}) {
    Condition condition = support::shaken(amplitude);
    condition.scene.block.wall = dynamics::Side::right;
    condition.scene.restitution = WallRatio{0.5};
    for (const auto& point : run(condition, 100).strobe) EXPECT_GE(point.tilt, 0.0) << amplitude;
  }
}

// One impact belongs to one rock: m counts impacts.
TEST(Wall, CountsARockForEachImpact) {
  Condition condition = support::shaken(1.6);
  condition.scene.block.wall = dynamics::Side::right;
  condition.scene.restitution = WallRatio{0.3};
  condition.horizon = {.transient_periods = 200, .sampled_periods = 60};
  const RealisationResult found = realise(condition, 1, 0);
  EXPECT_EQ(to_string(found.classification.mode), "(1,1)");
}

TEST(Wall, IsRefusedWithWhatItCannotHave) {
  const auto refusal = [](const char* rest) -> std::string {
    try {
      static_cast<void>(parse_experiment(std::string(R"({ "format": "rocking.experiment/1",
        "excitation": { "kind": "harmonic", "amplitude": 3, "frequency_ratio": 8 }, )") +
                                         rest + " }"));
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string wall =
      R"("block": { "width_m": 1, "height_m": 4, "wall": { "side": "right", "rate_ratio": 0.5 } })";
  EXPECT_EQ(refusal(wall.c_str()), "");
  EXPECT_NE(refusal((wall + R"(, "friction": { "static": 0.4, "kinetic": 0.3 })").c_str()).find("wall"),
            std::string::npos);
  EXPECT_NE(refusal((wall + R"(, "restitution": 0.0)").c_str()).find("/restitution"), std::string::npos);
  EXPECT_NE(refusal((wall + R"(, "initial": { "tilt": -0.1 })").c_str()).find("/initial/tilt"), std::string::npos);
  EXPECT_NE(refusal((wall + R"(, "initial": { "tilt_rate": -0.1 })").c_str()).find("tilt_rate"), std::string::npos);
  EXPECT_EQ(refusal((wall + R"(, "initial": { "tilt": 0.1, "tilt_rate": -0.1 })").c_str()), "");
  EXPECT_NE(refusal(R"("block": { "width_m": 1, "height_m": 4, "wall": { "side": "back", "rate_ratio": 0.5 } })"), "");
  EXPECT_NE(refusal(R"("block": { "width_m": 1, "height_m": 4, "wall": { "side": "left", "rate_ratio": 1.0 } })"), "");
}

}  // namespace
}  // namespace rocking
