#include "rocking/stats/quantile.hpp"

#include <cstdint>
#include <map>

#include <gtest/gtest.h>

namespace {

using rocking::stats::censored_quantile;
using rocking::stats::lower_median;
using Tally = std::map<std::int64_t, std::uint64_t>;

/// 1, 2, ... n, once each.
Tally first_numbers(std::int64_t n) {
  Tally tally;
  for (std::int64_t value = 1; value <= n; ++value) tally[value] = 1;
  return tally;
}

TEST(CensoredQuantile, IsTheSmallestValueThatEnoughDoNotExceed) {
  const Tally four = first_numbers(4);
  EXPECT_EQ(censored_quantile(four, 0, 0.25), 1.0);
  EXPECT_EQ(censored_quantile(four, 0, 0.2501), 2.0);
  EXPECT_EQ(censored_quantile(four, 0, 0.5), 2.0);
  EXPECT_EQ(censored_quantile(four, 0, 0.75), 3.0);
  EXPECT_EQ(censored_quantile(four, 0, 1.0), 4.0);
  EXPECT_EQ(censored_quantile(four, 0, 1e-300), 1.0);
}

TEST(CensoredQuantile, HitsWholeRanksInSpiteOfRounding) {
  for (const int n : {10, 100, 1000}) {
    const Tally values = first_numbers(n);
    for (int rank = 1; rank <= n; ++rank) {
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

TEST(CensoredQuantile, CountsAValueAsOftenAsItOccurred) {
  const Tally tally{{3, 5}, {8, 1}, {9, 4}};
  EXPECT_EQ(censored_quantile(tally, 0, 0.5), 3.0);
  EXPECT_EQ(censored_quantile(tally, 0, 0.51), 8.0);
  EXPECT_EQ(censored_quantile(tally, 0, 0.7), 9.0);
  EXPECT_EQ(censored_quantile(tally, 10, 0.3), 8.0);
}

TEST(CensoredQuantile, IsAbsentWhereThereIsNothingToSee) {
  EXPECT_EQ(censored_quantile({}, 0, 0.5), std::nullopt);
  EXPECT_EQ(censored_quantile({}, 5, 0.01), std::nullopt);
}

TEST(LowerMedian, IsAValueThatOccurred) {
  EXPECT_FALSE(lower_median({}).has_value());
  EXPECT_EQ(lower_median({3.0}), 3.0);
  EXPECT_EQ(lower_median({4.0, 1.0}), 1.0);
  EXPECT_EQ(lower_median({9.0, 1.0, 4.0}), 4.0);
  EXPECT_EQ(lower_median({9.0, 4.0, 1.0, 2.0}), 2.0);
}

}  // namespace
