// Two runs beside each other: which realisations changed, and how.

#include "rocking/experiment/comparison.hpp"

#include <gtest/gtest.h>

namespace rocking::experiment {
namespace {

using section::periodic;
using section::ResponseKind;
using section::ResponseMode;

constexpr ResponseMode chaotic{.kind = ResponseKind::chaotic};

Store store_of(const std::vector<std::vector<ResponseMode>>& conditions) {
  Store store = Store::in_memory({.experiment = "", .code = "", .files = "", .shard = {}});
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    for (std::size_t k = 0; k < conditions[i].size(); ++k) {
      Summary summary;
      summary.mode = conditions[i][k];
      store.add({i, k}, summary);
    }
  }
  return store;
}

void expect_counts(const stats::PairedCounts& counts, const std::vector<std::uint64_t>& expected) {
  EXPECT_EQ(counts.both, expected[0]);
  EXPECT_EQ(counts.first_only, expected[1]);
  EXPECT_EQ(counts.second_only, expected[2]);
  EXPECT_EQ(counts.neither, expected[3]);
}

TEST(Comparison, CountsForEachModeWhereItWasMet) {
  const auto one = periodic(1, 1);
  const auto three = periodic(1, 3);
  const auto compared = compare(store_of({{one, one, one, three, chaotic, chaotic}}),
                                store_of({{one, three, chaotic, three, chaotic, three}}), 1);
  ASSERT_EQ(compared.size(), 1U);
  EXPECT_EQ(compared[0].realisations, 6U);
  EXPECT_EQ(compared[0].changed.successes, 3U);
  EXPECT_EQ(compared[0].changed.trials, 6U);
  ASSERT_EQ(compared[0].modes.size(), 3U);
  expect_counts(compared[0].modes.at(one), {1, 2, 0, 3});
  expect_counts(compared[0].modes.at(three), {1, 0, 2, 3});
  expect_counts(compared[0].modes.at(chaotic), {1, 1, 1, 3});
}

TEST(Comparison, TakesOnlyWhatBothRunsHold) {
  const auto one = periodic(1, 1);
  const auto compared = compare(store_of({{one, one, one}, {one}}), store_of({{one, chaotic}, {}, {one}}), 2);
  ASSERT_EQ(compared.size(), 2U);
  EXPECT_EQ(compared[0].realisations, 2U);
  EXPECT_EQ(compared[0].changed.successes, 1U);
  EXPECT_EQ(compared[1].realisations, 0U);
  EXPECT_TRUE(compared[1].modes.empty());
}

}  // namespace
}  // namespace rocking::experiment
