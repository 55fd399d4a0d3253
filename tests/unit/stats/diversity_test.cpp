#include "rocking/stats/diversity.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace {

using rocking::stats::entropy;
using rocking::stats::probability_of_difference;
using Counts = std::vector<std::uint64_t>;

TEST(ProbabilityOfDifference, CountsPairs) {
  EXPECT_EQ(probability_of_difference(Counts{1, 1}), 1.0);
  EXPECT_EQ(probability_of_difference(Counts{2}), 0.0);
  EXPECT_EQ(probability_of_difference(Counts{2, 1}), 2.0 / 3.0);
  EXPECT_EQ(probability_of_difference(Counts{2, 3, 5}), 62.0 / 90.0);
  EXPECT_EQ(probability_of_difference(Counts{0, 2, 0, 3, 5, 0}), 62.0 / 90.0);
}

TEST(ProbabilityOfDifference, NeitherOverflowsNorLosesThePairThatDiffers) {
  const std::uint64_t n = 0xffffffff;
  EXPECT_EQ(probability_of_difference(Counts{n}), 0.0);
  EXPECT_DOUBLE_EQ(probability_of_difference(Counts{n - 1, 1}), 2.0 / static_cast<double>(n));
}

// E[1 - sum k(k-1)/(n(n-1))] over all outcomes of n draws, two classes of probability p and 1 - p, is 2 p (1 - p).
TEST(ProbabilityOfDifference, IsUnbiased) {
  const double p = 0.3;
  for (const std::uint64_t n : {2U, 3U, 8U}) {
    double mean = 0.0;
    double choose = 1.0;
    for (std::uint64_t k = 0; k <= n; ++k) {
      const double weight = choose * std::pow(p, k) * std::pow(1.0 - p, n - k);
      mean += weight * probability_of_difference(Counts{k, n - k});
      choose = choose * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    EXPECT_NEAR(mean, 2.0 * p * (1.0 - p), 1e-15);
  }
}

TEST(Entropy, IsTheLogarithmOfAsManyEqualClasses) {
  EXPECT_EQ(entropy(Counts{17}), 0.0);
  EXPECT_DOUBLE_EQ(entropy(Counts{4, 4}), std::log(2.0));
  EXPECT_DOUBLE_EQ(entropy(Counts{9, 9, 9, 0}), std::log(3.0));
}

TEST(Entropy, AddsUpOverASplit) {
  // H(1/2, 1/4, 1/4) = H(1/2, 1/2) + 1/2 H(1/2, 1/2).
  EXPECT_DOUBLE_EQ(entropy(Counts{2, 1, 1}), 1.5 * std::log(2.0));
}

}  // namespace
