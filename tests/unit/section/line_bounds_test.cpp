#include "rocking/section/line_bounds.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/section/clouds.hpp"
#include "rocking/section/spectral_line.hpp"
#include "support/split_mix.hpp"

namespace rocking::section {
namespace {

using support::SplitMix;

/// A series with noise of some size, sometimes with memory, lines, points that coincide or coordinates that are almost
/// proportional.
std::vector<PlanePoint> some_series(SplitMix& draw) {
  const std::size_t count = draw.uniform() < 0.1 ? 600 : 40 + static_cast<std::size_t>(100.0 * draw.uniform());
  const double size = std::pow(10.0, -14.0 * draw.uniform() * draw.uniform());
  const double memory = draw.uniform() < 0.5 ? 0.0 : draw.uniform();
  const double apart = draw.uniform() < 0.2 ? std::pow(10.0, -16.0 * draw.uniform()) : 1.0;
  const bool is_still = draw.uniform() < 0.05;
  std::vector<PlanePoint> points;
  PlanePoint p;
  for (std::size_t k = 0; k < count; ++k) {
    p = {memory * p.x + draw.normal(), memory * p.y + draw.normal()};
    points.push_back(is_still ? PlanePoint{} : PlanePoint{size * p.x, size * (p.x + apart * p.y)});
  }
  while (draw.uniform() < 0.5) {
    const int q = 2 + static_cast<int>(11.0 * draw.uniform());
    const int j = 1 + static_cast<int>(draw.uniform() * q);
    for (std::size_t k = 0; k < count; ++k) {
      points[k].x += std::cos(2.0 * std::numbers::pi * j * static_cast<double>(k) / q);
    }
  }
  return points;
}

double some_resolution(SplitMix& draw) { return draw.uniform() < 0.5 ? 1e-7 : std::pow(10.0, -12.0 * draw.uniform()); }

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

TEST(StrongestLine, HasTheBitsOfTheStrongestOfAll) {
  SplitMix draw(5);
  for (int trial = 0; trial < 3000; ++trial) {
    const auto points = some_series(draw);
    const int n = 1 + static_cast<int>(12.0 * draw.uniform());
    const Classes classes = classes_by_phase(points.size(), static_cast<std::size_t>(n));
    const auto deviations = deviations_of(points, classes, centres_of(points, classes));
    const double resolution = some_resolution(draw);
    const auto all = strongest_line_of_all(deviations, n, resolution);
    const auto one = strongest_line(deviations, n, resolution);
    ASSERT_EQ(one.has_value(), all.has_value());
    if (!one) continue;
    ASSERT_EQ(one->numerator, all->numerator) << trial;
    ASSERT_EQ(one->denominator, all->denominator) << trial;
    ASSERT_TRUE(bits(one->chance) == bits(all->chance) || (std::isnan(one->chance) && std::isnan(all->chance)))
        << trial;

    // A chance that need not be known to the last bit is still below the given one, and that of the same line.
    const auto needed = strongest_line(deviations, n, resolution, 1e-3);
    ASSERT_EQ(needed->numerator, all->numerator) << trial;
    ASSERT_EQ(needed->denominator, all->denominator) << trial;
    ASSERT_EQ(needed->chance < 1e-3, all->chance < 1e-3) << trial;
  }
}

TEST(ChanceBounds, AreCloseUnlessTheSeriesIsDegenerate) {
  SplitMix draw(6);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<PlanePoint> points;
    for (int k = 0; k < 60 + trial; ++k) points.push_back({draw.normal(), draw.normal()});
    for (const ChanceBounds& bounds : chance_bounds(points, 1, 1e-7)) {
      ASSERT_LT(bounds.most - bounds.least, 1e-7 * bounds.most);
    }
  }
}

}  // namespace
}  // namespace rocking::section
