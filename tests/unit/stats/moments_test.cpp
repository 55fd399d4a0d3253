#include "rocking/stats/moments.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace rocking::stats;
using Sample = std::vector<double>;

TEST(CompensatedSum, KeepsWhatAPlainSumLoses) {
  CompensatedSum sum;
  for (const double term : {1.0, 1e100, 1.0, -1e100}) sum.add(term);
  EXPECT_EQ(sum.value(), 2.0);
}

TEST(CentralMoments, AreExactOnSmallIntegers) {
  const CentralMoments moments = central_moments(Sample{0, 0, 0, 4});  // deviations -1, -1, -1, 3
  EXPECT_EQ(moments.n, 4U);
  EXPECT_EQ(moments.mean, 1.0);
  EXPECT_EQ(moments.second, 3.0);
  EXPECT_EQ(moments.third, 6.0);
  EXPECT_EQ(moments.fourth, 21.0);
  EXPECT_DOUBLE_EQ(moments.skewness(), 2.0 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(moments.kurtosis(), 7.0 / 3.0);
}

TEST(CentralMoments, DoNotDependOnWhereTheSampleLies) {
  const CentralMoments moments = central_moments(Sample{0x1p50, 0x1p50, 0x1p50, 0x1p50 + 4});
  EXPECT_EQ(moments.mean, 0x1p50 + 1);
  EXPECT_EQ(moments.second, 3.0);
  EXPECT_EQ(moments.fourth, 21.0);
}

TEST(SampleMoments, ReportTheUsualEstimators) {
  const SampleMoments moments = sample_moments(Sample{0, 0, 0, 4}, {0.5, 3.0}).value();
  EXPECT_EQ(moments.n, 4U);
  EXPECT_EQ(moments.mean.value, 1.0);
  EXPECT_EQ(moments.mean.standard_error, 1.5);
  EXPECT_DOUBLE_EQ(moments.mean.z, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(moments.standard_deviation.value, 2.0);
  EXPECT_DOUBLE_EQ(moments.skewness.value, 2.0 / std::sqrt(3.0));
  EXPECT_DOUBLE_EQ(moments.kurtosis.value, 7.0 / 3.0);
  EXPECT_DOUBLE_EQ(moments.skewness.standard_error, std::sqrt(12.0 / 35.0));
  EXPECT_DOUBLE_EQ(moments.kurtosis.standard_error, std::sqrt(192.0 / (25.0 * 63.0)));
  EXPECT_DOUBLE_EQ(moments.kurtosis.z, (7.0 / 3.0 - 9.0 / 5.0) / std::sqrt(192.0 / (25.0 * 63.0)));
}

TEST(SampleMoments, KnowTheExactLawOfTheStandardDeviation) {
  const double c4 = 0.92131773192356128;  // sqrt(2/3) Gamma(2)/Gamma(3/2), by mpmath
  const SampleMoments moments = sample_moments(Sample{0, 0, 0, 4}, {0.0, 3.0}).value();
  EXPECT_NEAR(moments.standard_deviation.standard_error, 3.0 * std::sqrt(1.0 - c4 * c4), 1e-14);
  EXPECT_NEAR(moments.standard_deviation.z, (2.0 - 3.0 * c4) / (3.0 * std::sqrt(1.0 - c4 * c4)), 1e-14);
}

// For large n the standard error is sigma/sqrt(2n) (1 + O(1/n)).
TEST(SampleMoments, KeepTheDigitsOfTheStandardErrorInLargeSamples) {
  Sample sample(1000000, 1.0);
  sample[0] = 2.0;
  const double found = sample_moments(sample, {0.0, 1.0}).value().standard_deviation.standard_error;
  EXPECT_NEAR(found * std::sqrt(2.0e6), 1.0, 1e-6);
}

TEST(SampleMoments, AreAbsentWhereShapeHasNoMeaning) {
  EXPECT_EQ(sample_moments(Sample{}, {}), std::nullopt);
  EXPECT_EQ(sample_moments(Sample{1, 2, 3}, {}), std::nullopt);
  for (std::size_t n = 4; n < 100; ++n) EXPECT_EQ(sample_moments(Sample(n, 0.7), {}), std::nullopt) << n;
}

}  // namespace
