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

/// The number next to `from` in the direction of `to`, `steps` times.
double moved(double from, double to, int steps) {
  for (int i = 0; i < steps; ++i) from = std::nextafter(from, to);
  return from;
}

TEST(Geometry, OfAMassLaidOutAsInARectangleIsThatOfTheRectangle) {
  for (const double height : {0.3, 1.0, 4.0, 17.0}) {
    const double radius = std::sqrt((1.0 + height * height) / 12.0);
    const Geometry rectangle = geometry_of({.width = 1.0, .height = height});
    for (const int steps : {-2, 0, 2}) {
      const Geometry laid_out =
          geometry_of({.mass = MassLayout{.left_edge = 0.5,
                                          .right_edge = 0.5,
                                          .centre_height = 0.5 * height,
                                          .radius_of_gyration = moved(radius, steps * 1e9, std::abs(steps))}});
      EXPECT_TRUE(laid_out.is_rectangle());
      EXPECT_EQ(laid_out.shape_angle, rectangle.shape_angle);
      EXPECT_EQ(laid_out.frequency_parameter, rectangle.frequency_parameter);
      EXPECT_EQ(laid_out.edges[1].impact_gain, 1.5);
    }
    const MassLayout heavier{.left_edge = 0.5,
                             .right_edge = 0.5,
                             .centre_height = 0.5 * height,
                             .radius_of_gyration = moved(radius, 1e9, 100)};
    EXPECT_FALSE(geometry_of({.mass = heavier}).is_rectangle());
  }
}

// The numbers of a general block go over into those of the rectangle: the formulas are the same.
TEST(Geometry, OfAnEccentricMassIsContinuousAtTheRectangle) {
  const Geometry rectangle = geometry_of({.width = 1.0, .height = 4.0});
  const Geometry near = geometry_of({.mass = MassLayout{.left_edge = 0.5 + 1e-9,
                                                        .right_edge = 0.5 - 1e-9,
                                                        .centre_height = 2.0,
                                                        .radius_of_gyration = std::sqrt(17.0 / 12.0)}});
  ASSERT_FALSE(near.is_rectangle());
  EXPECT_NEAR(near.half_diagonal, rectangle.half_diagonal, 1e-8);
  EXPECT_NEAR(near.frequency_parameter, rectangle.frequency_parameter, 1e-8);
  EXPECT_NEAR(near.inertia, 1.0 / 3.0, 1e-8);
  EXPECT_NEAR(near.load, 4.0 / 3.0, 1e-8);
  for (std::size_t i = 0; i < 2; ++i) {
    const Edge &edge = near.edges[i], &expected = rectangle.edges[i];
    EXPECT_NEAR(edge.shape_angle, expected.shape_angle, 1e-8);
    EXPECT_NEAR(edge.sine, expected.sine, 1e-8);
    EXPECT_NEAR(edge.cosine, expected.cosine, 1e-8);
    EXPECT_NEAR(edge.radius, 1.0, 1e-8);
    EXPECT_NEAR(edge.rocking_gain, 1.0, 1e-8);
    EXPECT_NEAR(edge.impact_gain, 1.5, 1e-8);
    EXPECT_NEAR(edge.tilt_scale, 1.0, 1e-8);
  }
  EXPECT_EQ(near.shape_angle, near.edges[1].shape_angle) << "the right edge is nearer";
}

}  // namespace
}  // namespace rocking::dynamics
