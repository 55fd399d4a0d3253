// Our intervals, compared with those of statsmodels and SciPy, from tests/oracles.

#include <algorithm>
#include <fstream>
#include <numeric>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "rocking/stats/interval.hpp"

namespace {

using namespace rocking::stats;
using Json = nlohmann::json;

const Json& oracle() {
  static const Json json = Json::parse(std::ifstream(ROCKING_SOURCE_DIR "/tests/oracles/statsmodels_intervals.json"));
  return json;
}

/// Both ends agree to ten digits, relative to 0 or to 1, except for rounding; statsmodels' Wilson gives 4e-18 instead
/// of 0.
void expect_agrees(const Interval& found, const Json& known, const Json& where, double rounding = 1e-15) {
  const auto tolerance = [&](double x) { return 4e-18 + rounding * x + 1e-10 * std::min(x, 1.0 - x); };
  const double low = known.at(0);
  const double high = known.at(1);
  EXPECT_NEAR(found.low, low, tolerance(low)) << where;
  EXPECT_NEAR(found.high, high, tolerance(high)) << where;
}

TEST(Oracle, AgreesOnTheIntervalsOfOneProportion) {
  EXPECT_GT(oracle()["proportions"].size(), 100U);
  for (const Json& row : oracle()["proportions"]) {
    const Proportion counts{row["k"], row["n"]};
    const double confidence = row["confidence"];
    expect_agrees(wilson(counts, confidence), row["wilson"], row);
    expect_agrees(clopper_pearson(counts, confidence), row["clopper_pearson"], row);
    expect_agrees(bonferroni_clopper_pearson(counts, confidence, 7), row["seven"], row);
  }
}

// statsmodels leaves the ends at the quantiles; ours extend to 0 and 1 (Brown, Cai, DasGupta 2001), since otherwise p
// near 0 and 1 would never be covered.
TEST(Oracle, AgreesOnJeffreysButAtTheEnds) {
  for (const Json& row : oracle()["proportions"]) {
    const Proportion counts{row["k"], row["n"]};
    Json known = row["jeffreys"];
    if (counts.successes == 0) known[0] = 0.0;
    if (counts.successes == counts.trials) known[1] = 1.0;
    expect_agrees(jeffreys(counts, row["confidence"]), known, row);
  }
}

TEST(Oracle, AgreesOnTheIntervalsOfCategoriesThatWereNotPrespecified) {
  for (const Json& row : oracle()["proportions"]) {
    const Family family{.prespecified = 6, .confidence = row["confidence"]};
    expect_agrees(exact_interval({row["k"], row["n"]}, family.of_others()), row["not_prespecified"], row, 0x1p-40);
  }
}

TEST(Oracle, AgreesOnGoodman) {
  for (const Json& row : oracle()["samples"]) {
    const std::vector<std::uint64_t> counts = row["counts"];
    const std::uint64_t n = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
    for (std::size_t i = 0; i < counts.size(); ++i) {
      expect_agrees(goodman({counts[i], n}, row["confidence"], counts.size()), row["goodman"][i], row);
    }
  }
}

// statsmodels' central moments are computed from factorial ones and lose n^2 eps: 1e-7 at n = 20000.
TEST(Oracle, AgreesOnSisonAndGlazWhereItHasAnAnswer) {
  std::size_t answers = 0;
  for (const Json& row : oracle()["samples"]) {
    if (row["sison_glaz"].is_null()) continue;
    const std::vector<std::uint64_t> counts = row["counts"];
    const auto found = sison_glaz(counts, row["confidence"]);
    ASSERT_TRUE(found.has_value()) << row;
    const bool is_large = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}) > 1000;
    const double tolerance = is_large ? 1e-6 : 1e-9;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      EXPECT_NEAR((*found)[i].low, row["sison_glaz"][i][0].get<double>(), tolerance) << row;
      EXPECT_NEAR((*found)[i].high, row["sison_glaz"][i][1].get<double>(), tolerance) << row;
    }
    ++answers;
  }
  EXPECT_GT(answers, 20U);
}

}  // namespace
