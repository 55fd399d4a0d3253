// From which base acceleration a block lifts, and below which friction it slides, beside the forces of the model.

#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/dynamics/forces.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/plan_text.hpp"
#include "rocking/plan/plan.hpp"

namespace {

using namespace rocking;
using ::testing::HasSubstr;
using ::testing::Not;

std::string thresholds_of(const std::string& more) {
  return thresholds_text(experiment_in(R"({ "format": "rocking.experiment/1",
    "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "kind": "harmonic", "amplitude": 4.2, "frequency_ratio": 10.0 })" +
                                       more + " }"));
}

/// Friction over the normal force of a block 1 x 4 that begins to rock without slip.
double demand_at(double base_acceleration) {
  const dynamics::Geometry block = dynamics::geometry_of({.width = 1.0, .height = 4.0});
  const auto forces = dynamics::forces_without_slip<double>(
      {.edge = {.sine = block.sine, .cosine = block.cosine}, .omega = 0.0, .beta = base_acceleration, .weight = 1.0},
      dynamics::EquationConstants<double>{});
  return forces.friction / forces.normal;
}

TEST(Thresholds, AreThoseOfTheForcesOfTheModel) {
  const std::string text = thresholds_of(R"(, "friction": { "static": 0.35, "kinetic": 0.3 })");
  EXPECT_THAT(text, HasSubstr("lifts if the base exceeds 0.25 g. Static friction 0.35:"));
  EXPECT_THAT(text, HasSubstr("an impact slips if it is below 0.185"));  // lib/docs/model.md, section 4
  const std::string words = "begins to rock slides if the base exceeds ";
  ASSERT_THAT(text, HasSubstr(words));
  const double slide = std::strtod(text.c_str() + text.find(words) + words.size(), nullptr);
  EXPECT_NEAR(demand_at(slide), 0.35, 1e-3);
  EXPECT_GT(slide, 0.25);
}

TEST(Thresholds, OfABlockWithItsMassOffTheMiddleAreThoseOfEachSide) {
  Experiment experiment;
  experiment.conditions.resize(1);
  SceneBlock& block = experiment.conditions.front().scene.block;
  block.mass = GivenEdges{.edges = {0.25, 0.9}, .centre_height = 1.0, .radius_of_gyration = 0.7};
  EXPECT_THAT(thresholds_text(experiment), HasSubstr("exceeds 0.25 g to the right or 0.9 g to the left."));
  const dynamics::Geometry geometry = dynamics::geometry_of(mean_of(block));
  const auto least = [&](double horizontal, double vertical) {
    return least_uplift_scale({{0.0, horizontal, vertical}}, geometry.tangents()).value_or(0.0);
  };
  EXPECT_NEAR(least(0.5, 0.0), 0.5, 1e-15);
  EXPECT_NEAR(least(-0.5, 0.0), 1.8, 1e-15);
  EXPECT_NEAR(least(-0.5, -0.4), 0.9 / 0.86, 1e-15);
  EXPECT_NEAR(least_uplift_scale({{0.0, -0.6, 0.0}, {1.0, 0.1, 0.0}}, geometry.tangents()).value_or(0.0), 1.5, 1e-15);
}

TEST(Thresholds, NameNoSlidingThatCannotBe) {
  EXPECT_THAT(thresholds_of(""), HasSubstr("Friction is not given: the block does not slide."));
  // Below tan(psi) the block slides and never begins to rock without slip; above the bound no acceleration is enough.
  EXPECT_THAT(thresholds_of(R"(, "friction": { "static": 0.2, "kinetic": 0.2 })"), Not(HasSubstr("begins to rock")));
  EXPECT_THAT(thresholds_of(R"(, "friction": { "static": 1.7, "kinetic": 0.3 })"), Not(HasSubstr("begins to rock")));
  EXPECT_LT(demand_at(1e9), 1.7);
}

// Computed outside: R = 1.15353 m, J = 0.368248; p_S^2 = g sqrt(b_S^2 + h^2)/(k^2 + b_S^2 + h^2), with k = 0.7 m: 2.55212 and
// 2.39547 rad/s; Housner (k^2 + h^2 - b_1 b_-1)/(k^2 + h^2 + b_S^2): 0.814815 and 0.55.
TEST(BlockText, HasARowForEachEdgeWhereTheyDiffer) {
  Experiment experiment;
  experiment.conditions.resize(2);
  for (Condition& condition : experiment.conditions) {
    condition.scene.block.mass = GivenEdges{.edges = {0.25, 0.9}, .centre_height = 1.0, .radius_of_gyration = 0.7};
    condition.scene.friction = Friction{.static_coefficient = 0.4, .kinetic_coefficient = 0.3};
  }
  experiment.conditions.back().scene.friction->static_coefficient = 0.2;
  const std::string text = block_text(experiment);
  EXPECT_THAT(
      text,
      HasSubstr(" left   0.25   1.03      0.245         14       2.55  0.25 to the right    0.815     in 1 of 2\n"
                "right    0.9   1.35      0.733         42        2.4    0.9 to the left     0.55           yes\n"));
}

TEST(BlockText, HasOneRowForARectangleAndSaysThatItIsTheMeanBlock) {
  const std::string text = block_text(experiment_in(R"({ "format": "rocking.experiment/1",
    "block": { "width_m": { "uniform": [0.9, 1.1] }, "height_m": 4.0 },
    "excitation": { "kind": "harmonic", "amplitude": 4.2, "frequency_ratio": 10.0 } })"));
  EXPECT_THAT(text, HasSubstr("Block (with the means of its laws)"));
  EXPECT_THAT(text, HasSubstr("both    0.5   2.06      0.245         14       1.89        0.25    0.912"));
  EXPECT_THAT(text, HasSubstr("cannot slide"));
}

}  // namespace
