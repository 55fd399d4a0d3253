#include "rocking/ensemble/mode_family.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "rocking/stats/interval.hpp"

namespace {

using namespace rocking;
using section::ResponseKind;
using section::ResponseMode;

std::vector<ModeEstimate> estimates(const ModeTally& tally) { return estimate_modes(tally, 0.95); }

Estimate of(const std::vector<ModeEstimate>& modes, const ResponseMode& wanted) {
  for (const auto& [mode, probability] : modes) {
    if (mode == wanted) return probability;
  }
  ADD_FAILURE() << to_string(wanted) << " is not listed";
  return {};
}

void expect_same(const stats::Interval& found, const stats::Interval& expected) {
  EXPECT_EQ(found.low, expected.low);
  EXPECT_EQ(found.high, expected.high);
}

const ResponseMode chaotic{.kind = ResponseKind::chaotic};
const ResponseMode rest{.kind = ResponseKind::rest};

TEST(EstimateModes, GivesEachPrespecifiedModeASeventhOfTheSignificanceLevelHoweverManyOccurred) {
  for (const ModeTally& others : {ModeTally{}, ModeTally{{section::periodic(2, 2), 1}, {section::periodic(5, 7), 3}}}) {
    ModeTally tally = others;
    tally[section::periodic(1, 1)] = 0;
    tally[section::periodic(1, 3)] = 70;
    tally[rest] = others.empty() ? 130 : 126;
    const auto modes = estimates(tally);
    expect_same(of(modes, section::periodic(1, 1)).simultaneous, stats::bonferroni_clopper_pearson({0, 200}, 0.95, 7));
    expect_same(of(modes, section::periodic(1, 3)).simultaneous, stats::bonferroni_clopper_pearson({70, 200}, 0.95, 7));
    expect_same(of(modes, rest).simultaneous, stats::bonferroni_clopper_pearson({tally[rest], 200}, 0.95, 7));
  }
}

TEST(EstimateModes, LetsTheModesThatWereNotPrespecifiedShareTheSeventhPart) {
  const auto modes = estimates({{section::periodic(2, 2), 40}, {section::periodic(0, 1), 1}, {chaotic, 159}});
  const stats::Significance significance = stats::Family{.prespecified = 6, .confidence = 0.95}.of_others();
  expect_same(of(modes, section::periodic(2, 2)).simultaneous, stats::exact_interval({40, 200}, significance));
  EXPECT_EQ(of(modes, section::periodic(0, 1)).simultaneous.low, 0.0);
}

TEST(EstimateModes, GivesEveryIntervalOfItsOwnCount) {
  const Estimate found = of(estimates({{section::periodic(1, 1), 30}, {chaotic, 170}, {rest, 0}}), chaotic);
  EXPECT_EQ(found.estimate, 0.85);
  EXPECT_EQ(found.counts.trials, 200U);
  expect_same(found.alone[0], stats::wilson({170, 200}, 0.95));
  expect_same(found.alone[1], stats::clopper_pearson({170, 200}, 0.95));
}

TEST(EstimateModes, SaysWhatItCanOfOneModeAndOfOneRealisation) {
  for (const std::uint64_t n : {1U, 200U}) {
    const auto modes = estimates({{chaotic, 0}, {rest, n}});
    EXPECT_EQ(of(modes, rest).simultaneous.high, 1.0);
    EXPECT_GT(of(modes, rest).simultaneous.low, 0.0);
    EXPECT_EQ(of(modes, chaotic).simultaneous.low, 0.0);
    EXPECT_LT(of(modes, chaotic).simultaneous.high, 1.0);
  }
}

// Two of the five unresolved realisations ended without an answer: they may have any mode.
TEST(EstimateModes, CoversEveryModeThatRealisationsWithoutAnAnswerMayHave) {
  const ResponseMode overturned{.kind = ResponseKind::overturned};
  const ModeTally tally{{section::periodic(1, 1), 30}, {overturned, 0}, {ResponseMode{}, 5}};
  const auto modes = estimate_modes(tally, 0.95, 2);
  const Estimate none = of(modes, overturned);
  EXPECT_EQ(none.estimate, 0.0);
  expect_same(none.alone[1], {0.0, stats::clopper_pearson({2, 35}, 0.95).high});
  expect_same(none.simultaneous, {0.0, stats::bonferroni_clopper_pearson({2, 35}, 0.95, 7).high});
  expect_same(of(modes, section::periodic(1, 1)).alone[0],
              {stats::wilson({30, 35}, 0.95).low, stats::wilson({32, 35}, 0.95).high});
  expect_same(of(modes, ResponseMode{}).alone[1],
              {stats::clopper_pearson({3, 35}, 0.95).low, stats::clopper_pearson({5, 35}, 0.95).high});
}

TEST(EstimateSides, DividesTheSignificanceOfOverturningBetweenBothSides) {
  const ResponseMode overturned{.kind = ResponseKind::overturned};
  const ModeTally tally{{section::periodic(1, 1), 150}, {overturned, 50}};
  const auto [left, right] = estimate_sides(tally, {42, 8}, 0.95);
  EXPECT_EQ(left.probability.estimate, 0.21);
  EXPECT_EQ(right.probability.counts.successes, 8U);
  EXPECT_EQ(right.probability.counts.trials, 200U);
  expect_same(left.probability.alone[1], stats::clopper_pearson({42, 200}, 0.95));
  // Half of the seventh of a mode: each tail has (1 - 0.95)/7/2/2.
  expect_same(left.probability.simultaneous, stats::bonferroni_clopper_pearson({42, 200}, 0.95, 14));
  expect_same(right.probability.simultaneous, stats::bonferroni_clopper_pearson({8, 200}, 0.95, 14));
}

TEST(EstimateSides, CoversWhatRealisationsWithoutAnAnswerMayDo) {
  const auto [left, right] = estimate_sides({{section::periodic(1, 1), 30}, {ResponseMode{}, 5}}, {0, 0}, 0.95, 2);
  expect_same(left.probability.simultaneous, {0.0, stats::bonferroni_clopper_pearson({2, 35}, 0.95, 14).high});
  expect_same(right.probability.simultaneous, left.probability.simultaneous);
}

}  // namespace
