// Our intervals, compared with those of statsmodels and SciPy, from tests/oracles.

#include <algorithm>
#include <fstream>

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
  const Json& known = oracle();
  for (const Json& row : known["proportions"]) {
    const Proportion counts{row["k"], row["n"]};
    const double confidence = row["confidence"];
    expect_agrees(wilson(counts, confidence), row["wilson"], row);
    expect_agrees(clopper_pearson(counts, confidence), row["clopper_pearson"], row);
    expect_agrees(bonferroni_clopper_pearson(counts, confidence, 7), row["seven"], row);
  }
}

TEST(Oracle, AgreesOnTheIntervalsOfCategoriesThatWereNotPrespecified) {
  const Json& known = oracle();
  for (const Json& row : known["proportions"]) {
    const Family family{.prespecified = 6, .confidence = row["confidence"]};
    expect_agrees(exact_interval({row["k"], row["n"]}, family.of_others()), row["not_prespecified"], row, 0x1p-40);
  }
}

}  // namespace
