// The geometry of the block.

#include "rocking/dynamics/block.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace rocking::dynamics {
namespace {

TEST(Geometry, OfTheReferenceBlockIsThatOfThePaper) {
  const Geometry block = geometry_of({.width = 1.0, .height = 4.0, .gravity = 9.81});
  // Fifty-digit values of tests/reference/01_noslip_11.json, rounded to double.
  EXPECT_EQ(block.shape_angle, 2.4497866312686415417e-01);
  EXPECT_DOUBLE_EQ(block.half_diagonal, 2.0615528128088302749);
  EXPECT_DOUBLE_EQ(block.frequency_parameter, 1.8891563520285026174);
  EXPECT_EQ(block.tangent, 0.25);
}

TEST(Geometry, IsConsistent) {
  for (const double height : {0.1, 0.7, 1.0, 3.3, 20.0}) {
    const Geometry block = geometry_of({.width = 1.0, .height = height});
    // Two units in the last place of psi < pi/2 change the sine by at most as much, the tangent by that times its
    // derivative.
    EXPECT_NEAR(block.sine, std::sin(block.shape_angle), 0x1p-51);
    EXPECT_NEAR(block.cosine, std::cos(block.shape_angle), 0x1p-51);
    EXPECT_NEAR(block.tangent, std::tan(block.shape_angle), 0x1p-51 * (1.0 + block.tangent * block.tangent));
  }
}

TEST(Geometry, HasAShapeThatDoesNotDependOnSizeAndAFrequencyThatFallsWithItsRoot) {
  const Geometry small = geometry_of({.width = 1.0, .height = 3.0});
  const Geometry large = geometry_of({.width = 4.0, .height = 12.0});
  EXPECT_EQ(large.shape_angle, small.shape_angle);
  EXPECT_EQ(large.sine, small.sine);
  EXPECT_EQ(large.half_diagonal, 4.0 * small.half_diagonal);
  EXPECT_EQ(large.frequency_parameter, 0.5 * small.frequency_parameter);
}

}  // namespace
}  // namespace rocking::dynamics
