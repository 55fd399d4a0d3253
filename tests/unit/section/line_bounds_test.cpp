#include "rocking/section/line_bounds.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/section/clouds.hpp"
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

/// Deviations from the classes of some series, and what they are tested with.
struct Tested {
  int n;
  std::vector<PlanePoint> deviations;
  double resolution;
};

Tested some_tested(SplitMix& draw) {
  const auto points = some_series(draw);
  const int n = 1 + static_cast<int>(12.0 * draw.uniform());
  const Classes classes = classes_by_phase(points.size(), static_cast<std::size_t>(n));
  return {n, deviations_of(points, classes, centres_of(points, classes)), some_resolution(draw)};
}

/// The strongest line by the chances of all lines.
std::optional<Line> strongest_of_all(const Tested& tested) {
  std::optional<Line> strongest;
  for (const LineFrequency& line : tested_lines()) {
    if (tested.n % line.denominator == 0) continue;
    const double chance = line_chance(line, tested.deviations, tested.n, tested.resolution);
    if (!strongest || chance < strongest->chance) strongest = Line{line, chance};
  }
  return strongest;
}

bool are_same(const LineFrequency& a, const LineFrequency& b) {
  return a.numerator == b.numerator && a.denominator == b.denominator;
}

TEST(StrongestLine, HasTheBitsOfTheStrongestOfAll) {
  SplitMix draw(5);
  int certain_ones = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    const Tested tested = some_tested(draw);
    const auto all = strongest_of_all(tested);
    const auto bounds = chance_bounds(tested.deviations, tested.n, tested.resolution);
    const auto one = strongest_line(tested.deviations, tested.n, tested.resolution, bounds);
    ASSERT_TRUE(one && all);
    ASSERT_TRUE(are_same(one->frequency, all->frequency)) << trial;
    ASSERT_TRUE(bits(one->chance) == bits(all->chance) || (std::isnan(one->chance) && std::isnan(all->chance)))
        << trial;

    ASSERT_FALSE(least_chance(bounds, tested.n) > all->chance) << trial;
    if (const auto certain = certain_line(bounds, tested.n, 1e-3)) {
      ASSERT_TRUE(are_same(*certain, all->frequency)) << trial;
      ASSERT_LT(all->chance, 1e-3) << trial;
      ++certain_ones;
    }
  }
  EXPECT_GT(certain_ones, 500);
}

/// Expects the chance of every line between its bounds. Returns the number of finite bounds.
int expect_within(const AllChanceBounds& bounds, const Tested& tested) {
  int bounded = 0;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const LineFrequency& line = tested_lines()[i];
    if (tested.n % line.denominator == 0 || std::isinf(bounds[i].most)) continue;
    const double chance = line_chance(line, tested.deviations, tested.n, tested.resolution);
    EXPECT_LE(bounds[i].least, chance) << line.numerator << '/' << line.denominator;
    EXPECT_GE(bounds[i].most, chance) << line.numerator << '/' << line.denominator;
    ++bounded;
  }
  return bounded;
}

TEST(ChanceBounds, ContainTheChanceOfEveryLine) {
  SplitMix draw(7);
  int bounded = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Tested tested = some_tested(draw);
    bounded += expect_within(chance_bounds(tested.deviations, tested.n, tested.resolution), tested);
    ASSERT_FALSE(HasFailure()) << trial;
  }
  EXPECT_GT(bounded, 10000);
}

TEST(ChanceBounds, ContainTheChanceAlsoAfterClassesWereRemoved) {
  SplitMix draw(8);
  int bounded = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const auto points = some_series(draw);
    const double resolution = some_resolution(draw);
    const auto about_classes = [&](int n) {
      const Classes classes = classes_by_phase(points.size(), static_cast<std::size_t>(n));
      return Tested{n, deviations_of(points, classes, centres_of(points, classes)), resolution};
    };
    const Tested medians = about_classes(1);
    LineSearch search(medians.deviations, 1, resolution);
    bounded += expect_within(search.bounds(), medians);
    for (const int n : {1 + static_cast<int>(6.0 * draw.uniform()), 12}) {
      if (12 % n != 0) continue;
      const Tested tested = about_classes(n);
      search.remove_classes(tested.deviations, n);
      bounded += expect_within(search.bounds(), tested);
    }
    ASSERT_FALSE(HasFailure()) << trial;
  }
  EXPECT_GT(bounded, 20000);
}

// Noise far below the resolution: the chances differ by a few roundings, which are known without their computation.
TEST(ChanceBounds, AreTheChanceWhereTheResolutionExceedsTheNoiseByFar) {
  SplitMix draw(9);
  int known = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const double size = 1e-7 * std::pow(10.0, -5.0 - 5.0 * draw.uniform());
    Tested tested{.n = 1, .deviations = {}, .resolution = 1e-7};
    const double line = draw.uniform() < 0.5 ? 0.0 : 1e-7 * std::pow(10.0, -4.0 * draw.uniform());  // of period 3
    for (int k = 0; k < 48 + trial; ++k) {
      const double x = line * std::cos(2.0 * std::numbers::pi * k / 3.0);
      tested.deviations.push_back({x + size * draw.normal(), 0.5 * x + size * draw.normal()});
    }
    const auto bounds = chance_bounds(tested.deviations, 1, tested.resolution);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      if (bounds[i].least != bounds[i].most) continue;
      const double chance = line_chance(tested_lines()[i], tested.deviations, 1, tested.resolution);
      ASSERT_EQ(bits(bounds[i].least), bits(chance)) << trial << ", line " << i;
      ++known;
    }
  }
  EXPECT_GT(known, 8000);
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
