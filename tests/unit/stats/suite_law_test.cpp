// The law of a suite of records: compared with lme4, its limits, and its intervals.

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "rocking/stats/centred_suite.hpp"
#include "rocking/stats/fit_suite.hpp"
#include "rocking/stats/suite_bootstrap.hpp"
#include "support/made_up_suite.hpp"

namespace {

using rocking::stats::bootstrap_records;
using rocking::stats::fit_suite;
using rocking::stats::FragilityOutcome;
using rocking::stats::Interval;
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

/// The probit of all trials as if they were independent, from which the search starts, over ln intensity less a centre.
std::pair<double, rocking::stats::ProbitLine> line_through(const SuiteLevels& suite) {
  const rocking::stats::CentredSuite data = rocking::stats::centred(suite);
  return {data.centre, most_likely_line(pooled_counts(data.records))};
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
    const auto [centre, line] = line_through(suite);
    EXPECT_NEAR(std::exp(centre - line.a / line.b) / known["pooled_median"].get<double>(), 1.0, 1e-8);
    EXPECT_NEAR(1.0 / line.b, known["pooled_dispersion"].get<double>(), 1e-8);
  }
}

double log_normal_cdf(double x) { return std::log(0.5 * std::erfc(-x / std::numbers::sqrt2)); }

/// The logarithm of the likelihood without binomial coefficients, by the trapezoidal rule over the normal number z of a
/// record, in intervals from -9 to 9. The integrand is smooth on a scale of at least within/(between sqrt(trials)). With
/// five intervals or more on that scale the rule is exact to rounding. The tails beyond 9 hold 2e-19.
double direct_log_likelihood(const SuiteLevels& suite, const SuiteLaw& law, int intervals = 9000) {
  constexpr double reach = 9.0;
  double sum = 0.0;
  for (const auto& record : suite) {
    double likelihood = 0.0;
    for (int i = 0; i <= intervals; ++i) {
      const double z = reach * (2.0 * i / intervals - 1.0);
      double logarithm = -0.5 * z * z;
      for (const auto& level : record) {
        const double eta = (std::log(level.intensity / law.median) - law.between_records * z) / law.within_record;
        const auto [happened, trials] = level.happened;
        if (happened > 0) logarithm += static_cast<double>(happened) * log_normal_cdf(eta);
        if (happened < trials) logarithm += static_cast<double>(trials - happened) * log_normal_cdf(-eta);
      }
      likelihood += std::exp(logarithm);
    }
    sum += std::log(likelihood * 2.0 * reach / intervals / std::sqrt(2.0 * std::numbers::pi));
  }
  return sum;
}

// Where records are nearly steps, glmer and the fit differ. The fit has the larger likelihood, and a law that differs
// from it by 1e-4 in one parameter has a smaller one.
TEST(SuiteLaw, HasTheLargestLikelihoodWhereItDiffersFromLme4) {
  const auto oracle = nlohmann::json::parse(std::ifstream(ROCKING_SOURCE_DIR "/tests/oracles/lme4_suite.json"));
  ASSERT_EQ(oracle["steep"].size(), 4U);
  double largest_difference = 0.0;
  for (const auto& known : oracle["steep"]) {
    SCOPED_TRACE(known["name"].get<std::string>());
    const SuiteLevels suite = suite_from(known);
    const auto law = fit_suite(suite).law;
    ASSERT_TRUE(law);
    const double likelihood = direct_log_likelihood(suite, *law);
    EXPECT_NEAR(law->log_likelihood, likelihood, 1e-6);
    SuiteLaw theirs = *law;
    theirs.median = known["median"];
    theirs.between_records = known["between_records"];
    theirs.within_record = known["within_record"];
    EXPECT_LE(direct_log_likelihood(suite, theirs), likelihood + 1e-9);
    for (double SuiteLaw::*parameter : {&SuiteLaw::median, &SuiteLaw::between_records, &SuiteLaw::within_record}) {
      const double difference = std::abs(theirs.*parameter / law.value().*parameter - 1.0);
      largest_difference = std::max(largest_difference, difference);
      for (const double factor : {1.0 - 1e-4, 1.0 + 1e-4}) {
        SuiteLaw other = *law;
        other.*parameter *= factor;
        EXPECT_LT(direct_log_likelihood(suite, other), likelihood) << factor;
      }
    }
  }
  EXPECT_GT(largest_difference, 1e-3) << "reports/evidence/intervals.md says that they differ";
}

/// A law with one quantity fixed, and two free numbers: logarithms of other quantities.
SuiteLaw restricted(SuiteQuantity quantity, double value, const std::array<double, 2>& free) {
  SuiteLaw law;
  const double first = std::exp(free[0]);
  const double second = std::exp(free[1]);
  switch (quantity) {
    case SuiteQuantity::median: law = {.median = value, .between_records = first, .within_record = second}; break;
    case SuiteQuantity::between_records:
      law = {.median = first, .between_records = value, .within_record = second};
      break;
    case SuiteQuantity::within_record:
      law = {.median = first, .between_records = second, .within_record = value};
      break;
    case SuiteQuantity::dispersion: {  // `second`: between_records over within_record
      const double within = value / std::hypot(1.0, second);
      law = {.median = first, .between_records = second * within, .within_record = within};
      break;
    }
  }
  return law;
}

/// The largest log-likelihood with one quantity fixed, from the free numbers of a law: Newton's method with central
/// differences, steps at most 0.3.
double largest_log_likelihood(const SuiteLevels& suite, const SuiteLaw& law, SuiteQuantity quantity, double value) {
  const bool is_median = quantity == SuiteQuantity::median;
  std::array<double, 2> at{std::log(is_median ? law.between_records : law.median),
                           std::log(quantity == SuiteQuantity::within_record ? law.between_records
                                    : quantity == SuiteQuantity::dispersion  ? law.between_records / law.within_record
                                                                             : law.within_record)};
  constexpr double h = 1e-3;
  const auto f = [&](double x, double y) {
    return direct_log_likelihood(suite, restricted(quantity, value, {at[0] + x, at[1] + y}), 800);
  };
  double largest = f(0.0, 0.0);
  for (int step = 0; step < 30; ++step) {
    const double gx = (f(h, 0.0) - f(-h, 0.0)) / (2.0 * h);
    const double gy = (f(0.0, h) - f(0.0, -h)) / (2.0 * h);
    const double xx = (f(h, 0.0) - 2.0 * largest + f(-h, 0.0)) / (h * h);
    const double yy = (f(0.0, h) - 2.0 * largest + f(0.0, -h)) / (h * h);
    const double xy = (f(h, h) - f(h, -h) - f(-h, h) + f(-h, -h)) / (4.0 * h * h);
    const double determinant = xx * yy - xy * xy;
    const bool is_hill = xx < 0.0 && determinant > 0.0;
    const double dx = is_hill ? (xy * gy - yy * gx) / determinant : 0.1 * gx;
    const double dy = is_hill ? (xy * gx - xx * gy) / determinant : 0.1 * gy;
    at[0] += std::clamp(dx, -0.3, 0.3);
    at[1] += std::clamp(dy, -0.3, 0.3);
    largest = f(0.0, 0.0);
    if (is_hill && std::hypot(dx, dy) < 1e-6) return largest;
  }
  ADD_FAILURE() << "no maximum was found";
  return largest;
}

// The likelihood at the ends is exp(-t^2/2) of the largest one, with the quantile t of Student's law with 9 degrees of
// freedom: 2.262157 for 95 % and 0.702722 for 50 %.
TEST(SuiteLaw, HasIntervalsAtTheLikelihoodThatTheirConfidenceAsksFor) {
  SplitMix random(3);
  const SuiteLevels suite = MadeUpSuite{.records = 10}.drawn(random);
  const auto law = fit_suite(suite).law;
  ASSERT_TRUE(law);
  for (const SuiteQuantity quantity : all_quantities) {
    for (const auto& [confidence, quantile] : {std::pair{0.95, 2.262157}, std::pair{0.5, 0.702722}}) {
      const Interval found = profile_interval(suite, *law, quantity, confidence);
      ASSERT_LT(found.low, value_of(quantity, *law));
      ASSERT_GT(found.high, value_of(quantity, *law));
      for (const double end : {found.low, found.high}) {
        EXPECT_NEAR(largest_log_likelihood(suite, *law, quantity, end) - law->log_likelihood,
                    -0.5 * quantile * quantile * excess_of_variance(suite, *law, quantity), 1e-5)
            << static_cast<int>(quantity) << ' ' << confidence << ' ' << end;
      }
    }
  }
}

// The same counts at a second level next to each say nothing new. The likelihood has twice the information of the scatter
// within a record, and the intervals stay nearly as wide.
TEST(SuiteLaw, HasIntervalsThatLevelsWithCommonNumbersDoNotNarrow) {
  SplitMix random(11);
  const SuiteLevels once = MadeUpSuite{.records = 30, .between_records = 0.2}.drawn(random);
  SuiteLevels twice = once;
  for (auto& record : twice) {
    const auto levels = record;
    for (auto level : levels) {
      level.intensity *= 1.0 + 1e-9;
      record.push_back(level);
    }
    std::ranges::sort(record, {}, &rocking::stats::RecordLevel::intensity);
  }
  const auto width = [](const SuiteLevels& suite) {
    const Interval found = profile_interval(suite, *fit_suite(suite).law, SuiteQuantity::within_record, 0.95);
    return std::log(found.high / found.low);
  };
  EXPECT_NEAR(excess_of_variance(twice, *fit_suite(twice).law, SuiteQuantity::within_record) /
                  excess_of_variance(once, *fit_suite(once).law, SuiteQuantity::within_record),
              2.0, 0.6);
  EXPECT_GT(width(twice), 0.85 * width(once));
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

/// The law of the bootstrap sample that has these records.
SuiteLaw law_of_sample(const SuiteLevels& suite, const std::vector<std::size_t>& records) {
  const auto draws = [&](std::uint64_t, std::uint64_t number) {
    // Further numbers are the shares of an unseen record.
    const std::size_t record = number < records.size() ? records[number] : 0;
    return (static_cast<double>(record) + 0.5) / static_cast<double>(suite.size());
  };
  return bootstrap_records(suite, 1, draws).laws.at(0);
}

TEST(SuiteLaw, CountsARecordThatIsDrawnTwiceAsTwoRecords) {
  SplitMix random(5);
  SuiteLevels suite = MadeUpSuite{.records = 6}.drawn(random);
  const SuiteLaw drawn = law_of_sample(suite, {0, 1, 1, 3, 4, 5});
  suite[2] = suite[1];
  const auto listed = fit_suite(suite).law;
  EXPECT_NEAR(drawn.log_likelihood, listed->log_likelihood, 1e-7);
  EXPECT_NEAR(drawn.between_records, listed->between_records, 1e-5);
}

// Of the records that are drawn, each is a step; the other one is not.
TEST(SuiteLaw, IgnoresARecordThatIsNotDrawnWhereItLooksForSteps) {
  EXPECT_EQ(law_of_sample(steps({"0011", "0101", "0111", "0001", "1111"}), {0, 2, 3, 4, 4}).within_record, 0.0);
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
  const auto [centre, line] = line_through(suite);
  EXPECT_NEAR(law->within_record, 1.0 / line.b, 1e-12);
  EXPECT_NEAR(law->median, std::exp(centre - line.a / line.b), 1e-12);
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

}  // namespace
