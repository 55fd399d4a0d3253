#include "rocking/section/closed_curves.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "support/split_mix.hpp"

namespace rocking::section {
namespace {

/// Ellipses about the corners of a triangle that are visited in turn; on each, positions in turns.
template <class Position>
std::vector<StrobePoint> on_ellipses(std::size_t curves, std::size_t count, Position position) {
  std::vector<StrobePoint> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double corner = 2.0 * std::numbers::pi * static_cast<double>(k % curves) / static_cast<double>(curves);
    const double angle = 2.0 * std::numbers::pi * position(static_cast<double>(k / curves));
    points.push_back({std::cos(corner) + 0.1 * std::cos(angle), std::sin(corner) + 0.3 * std::sin(angle), 0.0});
  }
  return points;
}

TEST(ClosedCurves, HaveTheirNumberAndTheirRotation) {
  for (const double rotation : {0.4078, 0.3819660112501051, 0.1415926535897931}) {
    for (const std::size_t curves : {1U, 2U, 3U}) {
      const auto points = on_ellipses(curves, 480, [=](double turn) { return rotation * turn; });
      const auto found = find_closed_curves(points, 1e-9);
      ASSERT_TRUE(found) << rotation << ", " << curves;
      EXPECT_EQ(found->curves, curves);
      EXPECT_NEAR(found->rotation, rotation, 1e-7);
      EXPECT_TRUE(may_be_closed_curves(std::span(points).first(60), 1e-9));
    }
  }
}

TEST(ClosedCurves, AreNotFoundOnALine) {
  const auto drift = [](double turn) { return 1e-4 * turn; };
  const auto bent = [](double turn) { return 0.2 + 0.7 * turn / 480.0; };
  EXPECT_FALSE(find_closed_curves(on_ellipses(1, 480, drift), 1e-9));
  EXPECT_FALSE(find_closed_curves(on_ellipses(1, 480, bent), 1e-9));
}

// 3 curves with a period of 31 turns, and one that is captured by it: 3 x 31 periods.
TEST(ClosedCurves, AreNotFoundInALongPeriod) {
  const double locked = 12.0 / 31.0;
  const auto periodic = [=](double turn) { return locked * turn; };
  const auto captured = [=](double turn) { return locked * turn + 0.01 * std::exp(-0.02 * turn); };
  EXPECT_FALSE(find_closed_curves(on_ellipses(3, 480, periodic), 1e-9));
  EXPECT_FALSE(find_closed_curves(on_ellipses(3, 480, captured), 1e-9));
}

// Noise hides that the points of a period come back exactly: no return of it is wider than the noise.
TEST(ClosedCurves, AreNotFoundInALongPeriodWithNoise) {
  support::SplitMix draw(31);
  auto points = on_ellipses(1, 480, [](double turn) { return 12.0 / 31.0 * turn; });
  for (StrobePoint& p : points) {
    p.tilt += 1e-4 * draw.normal();
    p.tilt_rate += 1e-4 * draw.normal();
  }
  EXPECT_FALSE(find_closed_curves(points, 1e-9));
}

TEST(ClosedCurves, NeedFortyPointsEach) {
  const auto turning = [](double turn) { return 0.3819660112501051 * turn; };
  EXPECT_TRUE(find_closed_curves(on_ellipses(3, 120, turning), 1e-9));
  EXPECT_FALSE(find_closed_curves(on_ellipses(3, 117, turning), 1e-9));
}

}  // namespace
}  // namespace rocking::section
