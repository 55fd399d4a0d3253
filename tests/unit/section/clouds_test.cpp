#include "rocking/section/clouds.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/split_mix.hpp"
#include "support/synthetic_response.hpp"

namespace rocking::section {
namespace {

using support::point_accuracy;

std::vector<PlanePoint> normal_cloud(std::size_t count, support::SplitMix& draw) {
  std::vector<PlanePoint> points;
  for (std::size_t k = 0; k < count; ++k) {
    const double x = draw.normal();
    points.push_back({x, 0.5 * x + 2.0 * draw.normal()});
  }
  return points;
}

TEST(Gather, GivesTheCovarianceOfANormalLaw) {
  support::SplitMix draw(1);
  const auto points = normal_cloud(100000, draw);
  const Clouds clouds = gather(points, classes_by_phase(points.size(), 1), point_accuracy);
  // Standard errors: the trimmed sums have 9e4 terms, about 0.6 % of each entry.
  EXPECT_NEAR(clouds.scatter.xx, 1.0, 0.03);
  EXPECT_NEAR(clouds.scatter.yy, 4.25, 0.13);
  EXPECT_NEAR(clouds.scatter.xy, 0.5, 0.06);
}

TEST(Gather, IsNotMovedByAFewStrays) {
  support::SplitMix draw(2);
  auto points = normal_cloud(1000, draw);
  const Clouds clean = gather(points, classes_by_phase(points.size(), 2), point_accuracy);
  for (std::size_t k = 0; k < points.size(); k += 50) points[k] = {1e3, -1e3};
  const Clouds strayed = gather(points, classes_by_phase(points.size(), 2), point_accuracy);
  EXPECT_NEAR(strayed.scatter.xx / clean.scatter.xx, 1.0, 0.3);
  EXPECT_NEAR(strayed.centres[0].x, clean.centres[0].x, 0.1);
}

TEST(Gather, DoesNotSeeBelowTheResolution) {
  const std::vector<PlanePoint> points(60, PlanePoint{0.25, -1.0});
  const Clouds clouds = gather(points, classes_by_phase(points.size(), 3), point_accuracy);
  // Corrected, like any scatter, for the three centres estimated from sixty points.
  EXPECT_DOUBLE_EQ(clouds.scatter.xx, point_accuracy * point_accuracy * 60.0 / 57.0);
  EXPECT_DOUBLE_EQ(clouds.scatter.yy, point_accuracy * point_accuracy * 60.0 / 57.0);
  EXPECT_EQ(clouds.centres[2].x, 0.25);
}

TEST(Classes, CutTimeIntoEqualPartsWithinEachPhase) {
  const Classes classes = classes_by_phase_and_time(12, 3, 2);
  EXPECT_EQ(classes.count, 6U);
  EXPECT_EQ(classes.of, (std::vector<std::uint32_t>{0, 1, 2, 0, 1, 2, 3, 4, 5, 3, 4, 5}));
}

TEST(Separations, AreThoseFromEachLargestProperDivisor) {
  Clouds clouds;
  clouds.scatter = {1.0, 0.0, 4.0};
  clouds.centres = {{0.0, 0.0}, {10.0, 0.0}, {0.0, 0.0}, {10.0, 6.0}};
  const auto four = separations(clouds);
  ASSERT_EQ(four.size(), 1U);
  EXPECT_EQ(four[0].divisor, 2U);
  EXPECT_DOUBLE_EQ(four[0].distance, 3.0);
  clouds.centres.resize(1);
  EXPECT_TRUE(separations(clouds).empty());
}

TEST(Strays, AreNearerToAnotherCloud) {
  Clouds clouds;
  clouds.scatter = {1.0, 0.0, 1.0};
  clouds.centres = {{0.0, 0.0}, {20.0, 0.0}};
  const std::vector<PlanePoint> points{{19.0, 0.0}, {20.0, 0.0}, {-9.0, 0.0}, {1.0, 0.0}};
  for (std::size_t k = 0; k < 4; ++k) clouds.deviations.push_back(points[k] - clouds.centres[k % 2]);
  EXPECT_EQ(strays(points, clouds, 5.0, 0.0), (std::vector<bool>{true, false, false, true}));
  EXPECT_EQ(strays(points, clouds, 5.0, 30.0), (std::vector<bool>{false, false, false, false}));
}

TEST(LongestMemory, IsTheCorrelationOfAnAutoregression) {
  for (const double memory : {0.0, 0.5, 0.83, 0.98}) {
    support::SplitMix draw(5);
    std::vector<PlanePoint> points;
    PlanePoint p;
    const double kick = std::sqrt(1.0 - memory * memory);
    for (int k = 0; k < 20000; ++k) {
      p = {memory * p.x + kick * draw.normal(), memory * p.y + kick * draw.normal()};
      points.push_back(p);
    }
    const Clouds clouds = gather(points, classes_by_phase(points.size(), 1), point_accuracy);
    EXPECT_NEAR(longest_memory(clouds, point_accuracy), memory, 0.04) << memory;
  }
}

TEST(LargestDeviation, IsTheMajorHalfAxis) {
  EXPECT_DOUBLE_EQ(largest_deviation({1.0, 0.0, 9.0}), 3.0);
  EXPECT_DOUBLE_EQ(largest_deviation({5.0, 4.0, 5.0}), 3.0);
}

TEST(HasLongerMemory, AgreesWithTheLongestMemory) {
  support::SplitMix draw(77);
  for (int trial = 0; trial < 2000; ++trial) {
    const double memory = 1.0 - std::pow(10.0, -3.0 * draw.uniform());
    const double stray = draw.uniform() < 0.5 ? 0.0 : 0.1 * draw.uniform();
    const double flatness = std::pow(10.0, -6.0 * draw.uniform() * draw.uniform());
    std::vector<PlanePoint> points;
    PlanePoint p;
    for (std::size_t k = 0; k < 48 + static_cast<std::size_t>(trial % 100); ++k) {
      p = {memory * p.x + draw.normal(), 0.5 * memory * p.y + draw.normal()};
      const double far = draw.uniform() < stray ? 1e4 : 1.0;
      points.push_back({far * p.x, p.x + flatness * p.y});
    }
    const Clouds clouds =
        gather(points, classes_by_phase(points.size(), 1 + static_cast<std::size_t>(trial % 3)), 1e-7);
    const double longest = longest_memory(clouds, 1e-7);
    for (const double limit : {0.3, 0.8, 0.96, 0.99, longest, std::nextafter(longest, 0.0)}) {
      ASSERT_EQ(has_longer_memory(clouds, 1e-7, limit), longest > limit) << trial << ", limit " << limit;
    }
  }
}

}  // namespace
}  // namespace rocking::section
