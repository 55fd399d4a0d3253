#include "rocking/stats/normal_check.hpp"

#include <cmath>
#include <numeric>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace rocking::stats;
using ::testing::ElementsAre;

TEST(NormalHistogram, PutsANumberOnAnEdgeIntoTheBinAboveIt) {
  const std::vector<double> sample{-2.5, -2.0, -1.5, -1.0, 0.0, 1.0, 1.5, 2.0, 2.5};
  const Histogram histogram = normal_histogram(sample, {}, 4, 2.0);
  EXPECT_THAT(histogram.edges, ElementsAre(-2.0, -1.0, 0.0, 1.0, 2.0));
  EXPECT_THAT(histogram.counts, ElementsAre(2, 1, 1, 2));
  EXPECT_EQ(histogram.below, 1U);
  EXPECT_EQ(histogram.above, 2U);
}

TEST(NormalHistogram, DropsNothing) {
  std::vector<double> sample;
  for (int i = -1000; i <= 1000; ++i) sample.push_back(0.4 + 0.03 * 0.007 * i);
  for (const std::size_t bins : {1U, 7U, 50U}) {
    const Histogram histogram = normal_histogram(sample, {0.4, 0.03}, bins, 4.0);
    const std::uint64_t inside = std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0});
    const double expected = std::accumulate(histogram.expected.begin(), histogram.expected.end(), 0.0);
    EXPECT_EQ(histogram.edges.size(), bins + 1);
    EXPECT_EQ(inside + histogram.below + histogram.above, sample.size());
    EXPECT_NEAR(expected + histogram.expected_below + histogram.expected_above, 2001.0, 1e-9);
  }
}

TEST(NormalHistogram, ExpectsWhatTheLawSays) {
  const std::vector<double> sample(1000, 0.0);
  const Histogram histogram = normal_histogram(sample, {}, 2, 1.0);
  EXPECT_NEAR(histogram.expected[0], 341.3447460685429, 1e-10);  // 1000 (erf(1/sqrt 2)/2)
  EXPECT_EQ(histogram.expected[0], histogram.expected[1]);
  EXPECT_NEAR(histogram.expected_above, 158.65525393145705, 1e-10);
}

TEST(NormalHistogram, CountsAsAReaderOfItsEdgesWould) {
  const NormalLaw law{0.4, 0.03};
  std::vector<double> sample;
  const Histogram empty = normal_histogram(sample, law, 40, 4.0);
  for (const double edge : empty.edges) {
    sample.push_back(edge);
    sample.push_back(std::nextafter(edge, -1.0));
  }
  const Histogram histogram = normal_histogram(sample, law, 40, 4.0);
  EXPECT_THAT(histogram.counts, ::testing::Each(2));
  EXPECT_EQ(histogram.below, 1U);
  EXPECT_EQ(histogram.above, 1U);
}

}  // namespace
