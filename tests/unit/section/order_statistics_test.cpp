#include "rocking/section/order_statistics.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "support/split_mix.hpp"

namespace rocking::section {
namespace {

using support::SplitMix;

/// Some values with many ties, some with none, some in order.
std::vector<double> some_values(std::size_t count, SplitMix& draw) {
  const int kind = static_cast<int>(4.0 * draw.uniform());
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) {
    values.push_back(kind == 1 ? std::floor(4.0 * draw.uniform()) : std::exp(10.0 * draw.normal()));
  }
  if (kind == 2) std::ranges::sort(values);
  if (kind == 3 && count > 3) values[count / 3] = std::numeric_limits<double>::infinity();
  return values;
}

double median_by_sorting(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half] + values[half - 1]);
}

TEST(ValueOfRank, IsTheValueAtThisIndexAfterSorting) {
  SplitMix draw(1);
  for (int trial = 0; trial < 3000; ++trial) {
    const std::vector<double> values = some_values(1 + static_cast<std::size_t>(trial % 200), draw);
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    std::vector<double> scratch(values.size());
    for (const double share : {0.0, 0.5, 0.9, 0.999}) {
      const auto rank = static_cast<std::size_t>(share * static_cast<double>(values.size()));
      ASSERT_EQ(value_of_rank(values, rank, scratch), sorted[rank]) << trial << ", rank " << rank;
      const double guess = draw.uniform() < 0.5 ? sorted[rank] * (0.5 + draw.uniform()) : draw.normal();
      ASSERT_EQ(value_of_rank(values, rank, scratch, guess), sorted[rank]) << trial << ", rank " << rank;
    }
    ASSERT_EQ(median_of(values, scratch), median_by_sorting(values)) << trial;
  }
}

TEST(ValueOfRank, IsThatOfTheLibraryIfValuesAreNaN) {
  SplitMix draw(2);
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<double> values = some_values(60, draw);
    for (int i = 0; i < 5; ++i) {
      values[static_cast<std::size_t>(60.0 * draw.uniform())] = std::numeric_limits<double>::quiet_NaN();
    }
    std::vector<double> library = values;
    std::nth_element(library.begin(), library.begin() + 30, library.end());
    const double lower = *std::max_element(library.begin(), library.begin() + 30);
    std::vector<double> scratch(values.size());
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    ASSERT_EQ(bits(value_of_rank(values, 30, scratch)), bits(library[30])) << trial;
    const double median = 0.5 * (library[30] + lower);
    const double found = median_of(values, scratch);
    ASSERT_TRUE(bits(found) == bits(median) || (std::isnan(found) && std::isnan(median))) << trial;
  }
}

TEST(Median, OfNoValuesIsZero) { EXPECT_EQ(median_of({}, {}), 0.0); }

}  // namespace
}  // namespace rocking::section
