// Friction that belongs to the place: cells of the base, each with its own draws (lib/docs/model.md, section 5).

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/realisation/friction_cells.hpp"
#include "rocking/realisation/scene_coefficients.hpp"
#include "support/scene_with_cells.hpp"

namespace rocking {
namespace {

TEST(FrictionCells, AreNumberedFromTheStartInBothDirections) {
  FrictionCells cells(0.5);
  EXPECT_EQ(cells.index(), 0U);
  EXPECT_EQ(cells.end(1.0), 0.25);
  EXPECT_EQ(cells.end(-1.0), -0.25);
  EXPECT_FALSE(cells.move_to(-0.2));
  EXPECT_TRUE(cells.move_to(1.1));  // cell 2, from 0.75 to 1.25
  EXPECT_EQ(cells.end(-1.0), 0.75);
  EXPECT_EQ(cells.index(), 4U);
  EXPECT_EQ(cells.first_unused(), 5U);
  cells.enter_next(-1.0);
  EXPECT_EQ(cells.end(1.0), 0.75);
  EXPECT_EQ(cells.first_unused(), 5U);
}

TEST(FrictionCells, HaveAnIndexEach) {
  std::set<std::uint64_t> indices;
  for (int cell = -50; cell <= 50; ++cell) {
    FrictionCells cells(1.0);
    cells.move_to(cell);
    EXPECT_LE(cells.index(), 100U);
    EXPECT_TRUE(indices.insert(cells.index()).second) << cell;
  }
}

TEST(FrictionOfThePlace, IsTheSameWhenTheBlockReturnsAndChangesWithNothingElse) {
  const Scene scene = support::scene_with_cells(0.01);
  SceneCoefficients coefficients(scene, random::Draws(5, 3));
  dynamics::Clock clock(6.0, 0.0);
  const auto both = [&] { return std::array{coefficients.static_friction(), coefficients.kinetic_friction(clock)}; };
  std::vector<std::array<double, 2>> there{both()};
  for (int k = 0; k < 20; ++k) {
    coefficients.enter_cell(-1.0);
    there.push_back(both());
    EXPECT_NE(there[there.size() - 2][0], there.back()[0]);
    coefficients.stop();
    coefficients.chatter_ended();
    clock.advance(0.3 * clock.period_length());
    EXPECT_EQ(both(), there.back());
    EXPECT_FALSE(coefficients.next_change(clock, true));
  }
  for (int k = 19; k >= 0; --k) {
    coefficients.enter_cell(1.0);
    EXPECT_EQ(both(), there[static_cast<std::size_t>(k)]) << k;
  }
  SceneCoefficients other(scene, random::Draws(5, 4));
  EXPECT_NE(other.static_friction(), there[0][0]);
}

TEST(FrictionOfThePlace, MovesTogetherInACellWithACorrelationOfOne) {
  Scene scene = support::scene_with_cells(0.01);
  scene.fluctuation.kinetic_friction = scene.fluctuation.static_friction = 0.03;
  scene.fluctuation.friction_correlation = 1.0;
  SceneCoefficients coefficients(scene, random::Draws(5, 3));
  const dynamics::Clock clock(6.0, 0.0);
  for (int k = 0; k < 200; ++k) {
    EXPECT_NEAR(coefficients.static_friction() - coefficients.kinetic_friction(clock), 0.05, 1e-15);
    coefficients.enter_cell(1.0);
  }
  EXPECT_EQ(coefficients.clamps().all(), 0U);
}

}  // namespace
}  // namespace rocking
