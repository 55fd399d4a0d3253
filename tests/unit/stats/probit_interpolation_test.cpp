// A probability between intensities at which it is known.

#include "rocking/stats/probit.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/stats/normal_law.hpp"

namespace {

using namespace rocking::stats;

double lognormal(double intensity) { return normal_cdf(std::log(intensity / 0.7) / 0.4); }

// Rounding: the clamped probits have ten digits at least where the probability is above 1e-6.
TEST(ProbitInterpolation, IsExactForALognormalLaw) {
  std::vector<KnownProbability> points;
  for (const double intensity : {0.3, 0.4, 0.8, 1.1}) points.push_back({intensity, lognormal(intensity)});
  const ProbitInterpolation law(points);
  for (double intensity = 0.25; intensity < 1.3; intensity += 0.01) {
    EXPECT_NEAR(law.probability(intensity), lognormal(intensity), 1e-10) << intensity;
  }
}

TEST(ProbitInterpolation, PassesThroughItsPointsAndDoesNotLeaveTheirRange) {
  const std::vector<KnownProbability> points{{0.1, 0.0}, {0.2, 0.05}, {0.3, 0.9}, {0.5, 1.0}};
  const ProbitInterpolation law(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(law.probability(points[i].intensity), points[i].probability, 2e-9);
    if (i == 0) continue;
    const double between = law.probability(0.5 * (points[i - 1].intensity + points[i].intensity));
    EXPECT_GT(between, points[i - 1].probability);
    EXPECT_LT(between, points[i].probability);
  }
}

}  // namespace
