// Comparison of two runs: which realisations changed, and how.

#include "rocking/studies/comparison/study.hpp"

#include <array>

#include <gtest/gtest.h>

#include "rocking/store/store.hpp"

namespace rocking {
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
                                store_of({{one, three, chaotic, three, chaotic, three}}), std::array{0.95});
  ASSERT_EQ(compared.size(), 1U);
  EXPECT_EQ(compared[0].realisations, 6U);
  EXPECT_EQ(compared[0].changed.counts.successes, 3U);
  EXPECT_EQ(compared[0].changed.counts.trials, 6U);
  ASSERT_EQ(compared[0].modes.size(), 3U);
  expect_counts(compared[0].modes.at(one).counts, {1, 2, 0, 3});
  expect_counts(compared[0].modes.at(three).counts, {1, 0, 2, 3});
  expect_counts(compared[0].modes.at(chaotic).counts, {1, 1, 1, 3});
}

TEST(Comparison, TakesOnlyWhatBothRunsHold) {
  const auto one = periodic(1, 1);
  const std::array confidences{0.95, 0.95};
  const auto compared = compare(store_of({{one, one, one}, {one}}), store_of({{one, chaotic}, {}, {one}}), confidences);
  ASSERT_EQ(compared.size(), 2U);
  EXPECT_EQ(compared[0].realisations, 2U);
  EXPECT_EQ(compared[0].changed.counts.successes, 1U);
  EXPECT_EQ(compared[1].realisations, 0U);
  EXPECT_TRUE(compared[1].modes.empty());
}

void expect_interval(const stats::Interval& found, const stats::Interval& expected) {
  EXPECT_EQ(found.low, expected.low);
  EXPECT_EQ(found.high, expected.high);
}

TEST(Comparison, StatesEachConditionAtItsOwnConfidence) {
  const auto one = periodic(1, 1);
  const std::vector<ResponseMode> before{one, one, one, one, chaotic};
  const std::vector<ResponseMode> after{one, chaotic, chaotic, one, one};
  const std::array confidences{0.8, 0.99};
  const auto compared = compare(store_of({before, before}), store_of({after, after}), confidences);
  ASSERT_EQ(compared.size(), 2U);
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const double confidence = confidences[i];
    EXPECT_EQ(compared[i].confidence, confidence);
    expect_interval(compared[i].changed.interval, stats::clopper_pearson({.successes = 3, .trials = 5}, confidence));
    const ModeComparison& mode = compared[i].modes.at(one);
    const stats::PairedCounts counts{.both = 2, .first_only = 2, .second_only = 1, .neither = 0};
    EXPECT_EQ(mode.in_first, 0.8);
    EXPECT_EQ(mode.in_second, 0.6);
    EXPECT_EQ(mode.difference, stats::paired_difference(counts));
    expect_interval(mode.score, stats::paired_difference_score(counts, confidence));
    expect_interval(mode.exact, stats::paired_difference_exact(counts, confidence));
    EXPECT_EQ(mode.test.p_value, 1.0) << "2 P(K <= 1) = 1 for K of Binomial(3, 1/2)";
    EXPECT_EQ(mode.variance_reduction, stats::variance_reduction(counts).factor);
  }
  EXPECT_EQ(number_of_tests(compared), 4U);
}

}  // namespace
}  // namespace rocking
