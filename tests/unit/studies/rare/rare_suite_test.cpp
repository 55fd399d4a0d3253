// The probability over the records of a suite, from that of each: cases with known answers.

#include "rocking/studies/rare/summarise.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/stats/normal_law.hpp"

namespace {

using rocking::Condition;
using rocking::rare_suites;
using rocking::RareEstimate;
using rocking::RareSuite;

Condition condition_of(const std::string& file, std::int64_t scale) {
  Condition condition;
  condition.parameters = {{"/excitation/file", file}, {"/excitation/scale", scale}};
  return condition;
}

RareEstimate estimate_of(double probability, double relative_error) {
  RareEstimate estimate;
  estimate.probability = probability;
  estimate.relative_error = relative_error;
  estimate.interval = {0.5 * probability, 2.0 * probability};
  estimate.repetitions.resize(16);
  return estimate;
}

RareEstimate unknown(std::optional<double> probability, double low, double high) {
  RareEstimate estimate;
  estimate.probability = probability;
  estimate.interval = {low, high};
  return estimate;
}

RareSuite suite_of(const std::vector<RareEstimate>& estimates) {
  std::vector<Condition> conditions;
  for (std::size_t i = 0; i < estimates.size(); ++i) conditions.push_back(condition_of(std::to_string(i), 1));
  return rare_suites(conditions, estimates).front();
}

TEST(RareSuites, AreTheMeansOverTheRecordsOfEachScale) {
  const std::vector<Condition> conditions{condition_of("a", 1), condition_of("a", 2), condition_of("b", 1),
                                          condition_of("b", 2)};
  const auto suites = rare_suites(
      conditions, {estimate_of(1e-6, 0.1), estimate_of(1e-4, 0.1), estimate_of(3e-6, 0.1), estimate_of(5e-4, 0.1)});
  ASSERT_EQ(suites.size(), 2U);
  EXPECT_DOUBLE_EQ(*suites[0].probability, 2e-6);
  EXPECT_DOUBLE_EQ(*suites[1].probability, 3e-4);
  EXPECT_EQ(suites[1].records, 2U);
  ASSERT_EQ(suites[1].parameters.size(), 1U);
  EXPECT_EQ(suites[1].parameters.front().value, rocking::SweptValue(2));
  EXPECT_DOUBLE_EQ(*suites[0].relative_error, std::hypot(0.1, 0.3) / 4.0);
}

TEST(RareSuites, AreFoundOnlyWhereSeveralRecordsAreSwept) {
  Condition scaled;
  scaled.parameters = {{"/excitation/scale", 2}};
  EXPECT_TRUE(rare_suites({scaled, scaled}, {estimate_of(0.1, 0.1), estimate_of(0.2, 0.1)}).empty());
  EXPECT_TRUE(rare_suites({condition_of("a", 1)}, {estimate_of(0.1, 0.1)}).empty());
}

TEST(RareSuites, HaveTheEndsOfTheIntervalOfARecordWhoseErrorIsNotKnown) {
  const RareSuite suite = suite_of({estimate_of(1e-6, 0.1), unknown(0.0, 0.0, 4e-6)});
  const double reach = std::exp(0.1 * rocking::stats::two_sided_t_quantile(0.95, 15.0));
  EXPECT_DOUBLE_EQ(*suite.probability, 0.5e-6);
  EXPECT_NEAR(suite.interval.low / (0.5e-6 / reach), 1.0, 1e-12);
  EXPECT_NEAR(suite.interval.high / (0.5e-6 * reach + 2e-6), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(*suite.relative_error, 0.1);
}

TEST(RareSuites, HaveNoProbabilityWhereARecordHasNone) {
  const RareSuite suite = suite_of({estimate_of(1e-6, 0.1), unknown({}, 0.0, 1.0)});
  EXPECT_FALSE(suite.probability);
  EXPECT_FALSE(suite.relative_error);
  EXPECT_GT(suite.interval.low, 0.0);
  EXPECT_GT(suite.interval.high, 0.5);
  EXPECT_LE(suite.interval.high, 1.0);
}

TEST(RareSuites, AreZeroWhereNoRecordSawTheEvent) {
  const RareSuite suite = suite_of({unknown(0.0, 0.0, 1e-4), unknown(0.0, 0.0, 3e-4)});
  EXPECT_EQ(suite.probability, 0.0);
  EXPECT_FALSE(suite.relative_error);
  EXPECT_EQ(suite.interval.low, 0.0);
  EXPECT_DOUBLE_EQ(suite.interval.high, 2e-4);
}

}  // namespace
