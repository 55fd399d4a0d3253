// The law of a suite of records: compared with lme4, its limits, and its intervals.

#include <atomic>
#include <cmath>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "rocking/stats/suite_law.hpp"
#include "support/made_up_suite.hpp"

namespace {

using rocking::stats::bootstrap_records;
using rocking::stats::fit_pooled;
using rocking::stats::fit_suite;
using rocking::stats::FragilityOutcome;
using rocking::stats::Interval;
using rocking::stats::percentile_interval;
using rocking::stats::profile_interval;
using rocking::stats::SuiteFit;
using rocking::stats::SuiteLaw;
using rocking::stats::SuiteLevels;
using rocking::stats::SuiteQuantity;
using rocking::support::MadeUpSuite;
using rocking::support::SplitMix;

constexpr std::array all_quantities{SuiteQuantity::median, SuiteQuantity::dispersion, SuiteQuantity::between_records,
                                    SuiteQuantity::within_record};

/// A suite in which every trial of a record has one outcome: a record is its outcomes at intensities 1, 2, 3, ...
SuiteLevels steps(const std::vector<std::string>& records, std::uint64_t trials = 1) {
  SuiteLevels suite;
  for (const std::string& outcomes : records) {
    auto& record = suite.emplace_back();
    for (const char outcome : outcomes) {
      record.push_back({.intensity = static_cast<double>(record.size()) + 1.0,
                        .happened = {.successes = outcome == '1' ? trials : 0, .trials = trials}});
    }
  }
  return suite;
}

SuiteLevels suite_from(const nlohmann::json& known) {
  SuiteLevels suite;
  for (std::size_t i = 0; i < known["record"].size(); ++i) {
    const auto record = known["record"][i].get<std::size_t>();
    if (suite.size() < record) suite.resize(record);
    suite[record - 1].push_back({.intensity = known["intensity"][i],
                                 .happened = {.successes = known["happened"][i], .trials = known["trials"][i]}});
  }
  return suite;
}

TEST(SuiteLaw, AgreesWithAdaptiveQuadratureOfLme4) {
  const auto oracle = nlohmann::json::parse(std::ifstream(ROCKING_SOURCE_DIR "/tests/oracles/lme4_suite.json"));
  ASSERT_GE(oracle["suites"].size(), 5U);
  for (const auto& known : oracle["suites"]) {
    const SuiteLevels suite = suite_from(known);
    const auto law = fit_suite(suite).law;
    ASSERT_TRUE(law) << known["name"];
    EXPECT_NEAR(law->median, known["median"].get<double>(), 1e-4 * law->median) << known["name"];
    EXPECT_NEAR(law->between_records, known["between_records"].get<double>(), 1e-4) << known["name"];
    EXPECT_NEAR(law->within_record, known["within_record"].get<double>(), 1e-4) << known["name"];
    const auto pooled = fit_pooled(suite);
    ASSERT_TRUE(pooled);
    EXPECT_NEAR(pooled->median, known["pooled_median"].get<double>(), 1e-8 * pooled->median);
    EXPECT_NEAR(pooled->dispersion, known["pooled_dispersion"].get<double>(), 1e-8);
  }
}

TEST(SuiteLaw, HasIntervalsAtTheLikelihoodThatTheirConfidenceAsksFor) {
  SplitMix random(3);
  const SuiteLevels suite = MadeUpSuite{.records = 10}.drawn(random);
  const auto law = fit_suite(suite).law;
  ASSERT_TRUE(law);
  for (const SuiteQuantity quantity : all_quantities) {
    const double value = value_of(quantity, *law);
    const Interval wide = profile_interval(suite, *law, quantity, 0.95);
    const Interval narrow = profile_interval(suite, *law, quantity, 0.5);
    EXPECT_LT(0.0, wide.low);
    EXPECT_LT(wide.low, narrow.low);
    EXPECT_LT(narrow.low, value);
    EXPECT_LT(value, narrow.high);
    EXPECT_LT(narrow.high, wide.high);
    EXPECT_LT(wide.high, 5.0 * value);
  }
}

// ln x -> ln x + c moves the median alone.
TEST(SuiteLaw, ChangesItsMedianAloneWithTheUnitOfTheIntensity) {
  SplitMix random(4);
  SuiteLevels suite = MadeUpSuite{.records = 6}.drawn(random);
  const auto law = fit_suite(suite).law;
  const Interval interval = profile_interval(suite, *law, SuiteQuantity::median, 0.9);
  for (auto& record : suite) {
    for (auto& level : record) level.intensity *= 9.81;
  }
  const auto scaled = fit_suite(suite).law;
  EXPECT_NEAR(scaled->median, 9.81 * law->median, 1e-7);
  EXPECT_NEAR(scaled->between_records, law->between_records, 1e-8);
  EXPECT_NEAR(scaled->log_likelihood, law->log_likelihood, 1e-8);
  EXPECT_NEAR(profile_interval(suite, *scaled, SuiteQuantity::median, 0.9).high, 9.81 * interval.high, 1e-5);
}

TEST(SuiteLaw, CountsARecordTwiceAsTwoRecords) {
  SplitMix random(5);
  SuiteLevels suite = MadeUpSuite{.records = 6}.drawn(random);
  const auto weighted = fit_suite(suite, {1.0, 2.0, 0.0, 1.0, 1.0, 1.0}).law;
  suite[2] = suite[1];
  const auto listed = fit_suite(suite).law;
  EXPECT_NEAR(weighted->log_likelihood, listed->log_likelihood, 1e-7);
  EXPECT_NEAR(weighted->between_records, listed->between_records, 1e-5);
}

// Of the records that count, each is a step; the other one is not.
TEST(SuiteLaw, IgnoresARecordOfWeightZeroWhereItLooksForSteps) {
  const auto law = fit_suite(steps({"0011", "0101", "0111", "0001", "1111"}), {1.0, 0.0, 1.0, 1.0, 1.0}).law;
  ASSERT_TRUE(law);
  EXPECT_EQ(law->within_record, 0.0);
}

TEST(SuiteLaw, HasNoScatterBetweenEqualRecords) {
  SuiteLevels suite;
  for (int r = 0; r < 5; ++r) {
    suite.push_back({{1.0, {.successes = 2, .trials = 20}},
                     {2.0, {.successes = 9, .trials = 20}},
                     {3.0, {.successes = 17, .trials = 20}}});
  }
  const auto law = fit_suite(suite).law;
  ASSERT_TRUE(law);
  EXPECT_EQ(law->between_records, 0.0);
  const auto pooled = fit_pooled(suite);
  EXPECT_NEAR(law->within_record, pooled->dispersion, 1e-12);
  EXPECT_NEAR(law->log_likelihood, pooled->log_likelihood, 1e-9);
  const Interval interval = profile_interval(suite, *law, SuiteQuantity::between_records, 0.95);
  EXPECT_EQ(interval.low, 0.0);
  EXPECT_GT(interval.high, 0.05);
  EXPECT_LT(interval.high, 1.0);
}

// The capacities ln 1.5 and so on are known up to the distance of the levels.
TEST(SuiteLaw, OfRecordsThatAreStepsHasNoScatterWithinOne) {
  const SuiteLevels suite = steps({"00001111", "00011111", "00000111", "00111111", "00001111", "00000011"});
  const auto law = fit_suite(suite).law;
  ASSERT_TRUE(law);
  EXPECT_EQ(law->within_record, 0.0);
  EXPECT_GT(law->median, 3.0);
  EXPECT_LT(law->median, 6.0);
  for (const SuiteQuantity quantity : {SuiteQuantity::median, SuiteQuantity::dispersion}) {
    const Interval interval = profile_interval(suite, *law, quantity, 0.95);
    EXPECT_LT(interval.low, value_of(quantity, *law));
    EXPECT_GT(interval.low, 0.0);
    EXPECT_GT(interval.high, value_of(quantity, *law));
    EXPECT_LT(interval.high, 10.0);
  }
  const Interval within = profile_interval(suite, *law, SuiteQuantity::within_record, 0.95);
  EXPECT_EQ(within.low, 0.0);
  EXPECT_GT(within.high, 0.02);
  EXPECT_LT(within.high, 1.0);
}

// With two intensities the law has as many parameters as there are shares.
TEST(SuiteLaw, OfStepsGoesThroughTheSharesAtTwoIntensities) {
  const SuiteLevels suite = steps({"01", "01", "01", "00", "00", "11", "11"}, 30);
  const auto law = fit_suite(suite).law;
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->probability(1.0), 2.0 / 7.0, 1e-7);
  EXPECT_NEAR(law->probability(2.0), 5.0 / 7.0, 1e-7);
  EXPECT_NEAR(law->log_likelihood, 4.0 * std::log(2.0 / 7.0) + 3.0 * std::log(3.0 / 7.0), 1e-10);
}

TEST(SuiteLaw, IsNamedWhereThereIsNone) {
  using enum FragilityOutcome;
  EXPECT_EQ(fit_suite(steps({"0011"})).outcome, too_little);
  EXPECT_EQ(fit_suite(steps({"0", "1"})).outcome, too_little);
  EXPECT_EQ(fit_suite(steps({"00", "00"})).outcome, never_happened);
  EXPECT_EQ(fit_suite(steps({"11", "11"})).outcome, always_happened);
  EXPECT_EQ(fit_suite(steps({"0011", "0011"})).outcome, separated);
  EXPECT_EQ(fit_suite(steps({"0011", "0111"}, 50)).outcome, separated) << "a capacity of 2 in both";
  EXPECT_EQ(fit_suite(steps({"1100", "1000"})).outcome, does_not_rise);
  EXPECT_EQ(fit_suite(steps({"111", "000", "111", "000"})).outcome, does_not_rise);
  EXPECT_EQ(fit_suite(steps({"0011", "0101", "0111", "0001"})).outcome, fitted) << "a record that survives again";
}

TEST(SuiteLaw, FindsTheLawOfRecordsThatMostlyAreSteps) {
  SplitMix random(6);
  const MadeUpSuite truth{.records = 200, .trials = 100, .between_records = 0.4, .within_record = 0.02};
  const auto law = fit_suite(truth.drawn(random)).law;
  ASSERT_TRUE(law);
  EXPECT_NEAR(law->within_record, 0.02, 0.002);
  EXPECT_NEAR(law->between_records, 0.4, 0.1);
  EXPECT_NEAR(law->median, 1.0, 0.12);
}

TEST(SuiteBootstrap, RepeatsAndNarrowsTheSpreadOfRecords) {
  SplitMix random(7);
  const SuiteLevels suite = MadeUpSuite{}.drawn(random);
  const auto draws = [](std::uint64_t sample, std::uint64_t number) {
    return SplitMix(1000 * sample + number + 1).uniform();
  };
  const auto once = bootstrap_records(suite, 60, draws);
  const auto again = bootstrap_records(suite, 60, draws);
  ASSERT_EQ(once.laws.size(), 60U);
  ASSERT_EQ(once.pooled.size(), 60U);
  std::vector<double> medians;
  for (std::size_t i = 0; i < 60; ++i) {
    EXPECT_EQ(once.laws[i].median, again.laws[i].median);
    medians.push_back(once.laws[i].median);
  }
  const auto interval = percentile_interval(medians, 60, 0.9);
  ASSERT_TRUE(interval);
  EXPECT_LT(interval->low, 1.0);
  EXPECT_GT(interval->high, 1.0);
  EXPECT_LT(interval->high - interval->low, 0.6);
  EXPECT_GT(interval->high - interval->low, 0.1);
}

TEST(SuiteBootstrap, DoesNotDependOnTheThreadsAndStopsIfAsked) {
  SplitMix random(8);
  const SuiteLevels suite = MadeUpSuite{}.drawn(random);
  const auto draws = [](std::uint64_t sample, std::uint64_t number) {
    return SplitMix(1000 * sample + number + 1).uniform();
  };
  std::size_t parts = 0;
  const auto one = bootstrap_records(suite, 30, draws);
  const auto several = bootstrap_records(suite, 30, draws, {.threads = 3, .on_part = [&parts] { ++parts; }});
  EXPECT_EQ(parts, 30U);
  ASSERT_EQ(several.laws.size(), one.laws.size());
  for (std::size_t i = 0; i < one.laws.size(); ++i) {
    EXPECT_EQ(several.laws[i].median, one.laws[i].median);
    EXPECT_EQ(several.laws[i].between_records, one.laws[i].between_records);
    EXPECT_EQ(several.pooled[i].dispersion, one.pooled[i].dispersion);
  }
  std::atomic<bool> stop{false};
  parts = 0;
  const auto stops = [&] { stop = ++parts == 4; };
  EXPECT_THROW(static_cast<void>(bootstrap_records(suite, 30, draws, {.stop = &stop, .on_part = stops})),
               rocking::base::Stopped);
  EXPECT_EQ(parts, 4U);
}

// The whole suite is a sample in which each record is drawn once: the search from its own law returns that law.
TEST(SuiteBootstrap, OfTheSuiteItselfIsItsLaw) {
  SplitMix random(9);
  const SuiteLevels suite = MadeUpSuite{}.drawn(random);
  const auto each_once = [&suite](std::uint64_t, std::uint64_t number) {
    return (static_cast<double>(number) + 0.5) / static_cast<double>(suite.size());
  };
  const auto law = fit_suite(suite).law.value();
  const auto found = bootstrap_records(suite, 1, each_once).laws.at(0);
  EXPECT_NEAR(found.median, law.median, 1e-9);
  EXPECT_NEAR(found.between_records, law.between_records, 1e-9);
  EXPECT_NEAR(found.log_likelihood, law.log_likelihood, 1e-9 * std::abs(law.log_likelihood));
}

TEST(SuiteBootstrap, HasNoIntervalWhereATenthOfTheSamplesHasNoLaw) {
  EXPECT_FALSE(percentile_interval(std::vector<double>(89, 1.0), 100, 0.95));
  EXPECT_TRUE(percentile_interval(std::vector<double>(90, 1.0), 100, 0.95));
  EXPECT_FALSE(percentile_interval({}, 0, 0.95));
}

}  // namespace
