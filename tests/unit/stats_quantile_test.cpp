#include "rocking/stats/quantile.hpp"

#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace {

using rocking::stats::censored_quantile;

/// 1, 2, ... n.
std::vector<double> first_numbers(std::size_t n) {
  std::vector<double> values(n);
  std::iota(values.begin(), values.end(), 1.0);
  return values;
}

TEST(CensoredQuantile, IsTheSmallestValueThatEnoughDoNotExceed) {
  const std::vector<double> four = first_numbers(4);
  EXPECT_EQ(censored_quantile(four, 0, 0.25), 1.0);
  EXPECT_EQ(censored_quantile(four, 0, 0.2501), 2.0);
  EXPECT_EQ(censored_quantile(four, 0, 0.5), 2.0);
  EXPECT_EQ(censored_quantile(four, 0, 0.75), 3.0);
  EXPECT_EQ(censored_quantile(four, 0, 1.0), 4.0);
  EXPECT_EQ(censored_quantile(four, 0, 1e-300), 1.0);
}

TEST(CensoredQuantile, HitsWholeRanksInSpiteOfRounding) {
  for (const std::size_t n : {10U, 100U, 1000U}) {
    const std::vector<double> values = first_numbers(n);
    for (std::size_t rank = 1; rank <= n; ++rank) {
      const double level = static_cast<double>(rank) / static_cast<double>(n);
      ASSERT_EQ(censored_quantile(values, 0, level), static_cast<double>(rank)) << level;
    }
  }
}

TEST(CensoredQuantile, CountsTheLaterOnesAsLarger) {
  EXPECT_EQ(censored_quantile(first_numbers(2), 2, 0.5), 2.0);
  EXPECT_EQ(censored_quantile(first_numbers(2), 2, 0.51), std::nullopt);
  EXPECT_EQ(censored_quantile(first_numbers(2), 3, 0.25), 2.0);
}

TEST(CensoredQuantile, IsAbsentWhereThereIsNothingToSee) {
  EXPECT_EQ(censored_quantile({}, 0, 0.5), std::nullopt);
  EXPECT_EQ(censored_quantile({}, 5, 0.01), std::nullopt);
}

}  // namespace
