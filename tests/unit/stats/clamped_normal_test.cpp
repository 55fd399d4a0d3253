// Moments of normal numbers that are clamped, beside sums over a fine grid of the density.

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "rocking/stats/normal_law.hpp"

namespace {

using namespace rocking::stats;

constexpr double density_step = 1e-3;
constexpr int density_steps = 9000;  // to 9 sigma on both sides

double density_weight(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::acos(-1.0)) * density_step; }

/// Moments of value(z) over a standard normal z, by the midpoint rule.
template <class Value>
MeanAndSigma by_sum(Value value) {
  double mean = 0.0, square = 0.0;
  for (int i = -density_steps; i < density_steps; ++i) {
    const double z = (i + 0.5) * density_step;
    mean += density_weight(z) * value(z);
    square += density_weight(z) * value(z) * value(z);
  }
  return {mean, std::sqrt(square - mean * mean)};
}

// The midpoint rule is exact to the square of the step at a kink.
TEST(ClampedNormal, HasTheMomentsOfASumOverItsDensity) {
  struct Case {
    MeanAndSigma law;
    double low, high;
  };
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Case& given : {Case{{0.02, 0.03}, 0.0, infinity}, Case{{0.9, 0.2}, -0.999, 1.0},
                            Case{{0.5, 0.1}, -infinity, 0.45}, Case{{2.0, 0.1}, -infinity, infinity}}) {
    const MeanAndSigma found = clamped_normal(given.law, given.low, given.high);
    const MeanAndSigma summed =
        by_sum([&given](double z) { return std::clamp(given.law.mean + given.law.sigma * z, given.low, given.high); });
    EXPECT_NEAR(found.mean, summed.mean, 1e-6);
    EXPECT_NEAR(found.sigma, summed.sigma, 1e-6);
  }
}

TEST(SmallerOfNormals, HasTheMomentsOfASumOverOneAndTheOtherGivenIt) {
  // Given the first number z1, the second is normal, and the smaller one is that clamped from above at the first.
  const MeanAndSigma first{0.30, 0.03}, second{0.35, 0.02};
  for (const double correlation : {-0.5, 0.0, 0.6}) {
    double mean = 0.0, square = 0.0;
    for (int i = -density_steps; i < density_steps; i += 9) {
      const double z = (i + 0.5 * 9) * density_step;
      const double own = first.mean + first.sigma * z;
      const MeanAndSigma other{second.mean + correlation * second.sigma * z,
                               second.sigma * std::sqrt(1.0 - correlation * correlation)};
      const MeanAndSigma smaller = clamped_normal(other, -std::numeric_limits<double>::infinity(), own);
      mean += 9 * density_weight(z) * smaller.mean;
      square += 9 * density_weight(z) * (smaller.mean * smaller.mean + smaller.sigma * smaller.sigma);
    }
    const MeanAndSigma found = smaller_of_normals(first, second, correlation);
    EXPECT_NEAR(found.mean, mean, 1e-6) << correlation;
    EXPECT_NEAR(found.sigma, std::sqrt(square - mean * mean), 1e-6) << correlation;
  }
  const MeanAndSigma together = smaller_of_normals(first, {0.35, 0.03}, 1.0);
  EXPECT_EQ(together.mean, first.mean);
  EXPECT_EQ(together.sigma, first.sigma);
}

// lib/docs/model.md, section 5: sigma 0.03 on means 0.05 apart.
TEST(SmallerOfNormals, LowersTheKineticFrictionOfTheHeadlineByAFourthOfAHundredth) {
  EXPECT_NEAR(smaller_of_normals({0.30, 0.03}, {0.35, 0.03}, 0.0).mean, 0.30 - 0.0025, 5e-5);
}

}  // namespace
