#include "rocking/section/line_bounds.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/section/classification.hpp"
#include "support/synthetic_response.hpp"

namespace rocking::section {
namespace {

using support::point_accuracy;

std::vector<PlanePoint> white_noise(std::size_t count, support::SplitMix& draw) {
  std::vector<PlanePoint> points;
  for (std::size_t k = 0; k < count; ++k) points.push_back({draw.normal(), draw.normal()});
  return points;
}

std::optional<Line> strongest_of(const std::vector<PlanePoint>& deviations, int n) {
  return strongest_line(deviations, n, point_accuracy, chance_bounds(deviations, n, point_accuracy));
}

TEST(StrongestLine, IsLookedForAtTwentyThreeFractions) {
  int fractions = 0;
  for (int q = 2; q <= longest_period; ++q) {
    for (int j = 1; 2 * j <= q; ++j) fractions += std::gcd(j, q) == 1 ? 1 : 0;
  }
  EXPECT_EQ(fractions, line_count);
}

// The chance of the strongest of 23 lines is the smallest of 23 nearly independent uniform numbers. In 20000 series 23
// x 20000 x 1e-3 = 460 are expected below 1e-3 (dependence reduces this), 46 below 1e-4. False-alarm probability of the
// bounds below: 1e-6 (Poisson).
TEST(StrongestLine, HasTheChanceItStatesUnderWhiteNoise) {
  support::SplitMix draw(11);
  int below_3 = 0;
  int below_4 = 0;
  for (int series = 0; series < 20000; ++series) {
    const auto line = strongest_of(white_noise(60 + 60 * static_cast<std::size_t>(series % 3), draw), 1);
    ASSERT_TRUE(line);
    below_3 += line->chance < 1e-3 ? 1 : 0;
    below_4 += line->chance < 1e-4 ? 1 : 0;
  }
  EXPECT_GT(below_3, 350);
  EXPECT_LT(below_3, 570);
  EXPECT_GT(below_4, 17);
  EXPECT_LT(below_4, 84);
}

TEST(StrongestLine, FindsALineThatIsThere) {
  support::SplitMix draw(12);
  for (int q = 2; q <= longest_period; ++q) {
    auto points = white_noise(120, draw);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(k) / q;
      points[k].x += 3.0 * std::cos(angle);
      points[k].y += 3.0 * std::sin(angle);
    }
    const auto line = strongest_of(points, 1);
    ASSERT_TRUE(line);
    EXPECT_EQ(line->frequency.denominator, q);
    EXPECT_LT(line->chance, 1e-6) << q;
  }
}

TEST(StrongestLine, IsNotLookedForWhereTheCloudsAlreadyHaveIt) {
  support::SplitMix draw(13);
  for (int series = 0; series < 100; ++series) {
    const auto line = strongest_of(white_noise(120, draw), 12);
    ASSERT_TRUE(line);
    EXPECT_NE(12 % line->frequency.denominator, 0);
  }
}

// The spectrum of noise that rotates by a third of a turn per period and decays as slowly as Housner's impact allows
// has a broad maximum at 1/3, but no line. Compared with white noise of the same variance, nearly every one of these
// series would have a line.
TEST(StrongestLine, IsDistinguishedFromTheBroadMaximumOfNoiseWithLongMemory) {
  support::SplitMix draw(14);
  const double c = 0.83 * std::cos(2.0 * std::numbers::pi / 3.0);
  const double s = 0.83 * std::sin(2.0 * std::numbers::pi / 3.0);
  int alarms = 0;
  for (int series = 0; series < 2000; ++series) {
    std::vector<PlanePoint> points;
    PlanePoint p;
    for (int k = 0; k < 120; ++k) {
      p = {c * p.x - s * p.y + draw.normal(), s * p.x + c * p.y + draw.normal()};
      points.push_back(p);
    }
    alarms += strongest_of(points, 1)->chance < 1e-4 / line_count ? 1 : 0;
  }
  EXPECT_LT(alarms, 30);  // measured rate 0.003
}

TEST(StrongestLine, IsNotFoundInWhatLiesBelowTheResolution) {
  std::vector<PlanePoint> points;
  for (int k = 0; k < 120; ++k) points.push_back({k % 2 == 0 ? 0.01 * point_accuracy : 0.0, 0.0});
  EXPECT_GT(strongest_of(points, 1)->chance, 1e-3);
}

}  // namespace
}  // namespace rocking::section
