// Confidence limits of a mean over records, with one more record than there are, and samples of records.

#include "rocking/stats/suite_bootstrap.hpp"

#include <array>
#include <atomic>
#include <cmath>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/stats/fit_suite.hpp"
#include "rocking/stats/interval.hpp"
#include "support/made_up_suite.hpp"

namespace {

using namespace rocking::stats;
using rocking::support::MadeUpSuite;
using rocking::support::SplitMix;

RecordDraws draws() {
  return [](std::uint64_t sample, std::uint64_t number) { return SplitMix(1000 * sample + number).uniform(); };
}

// Of numbers that are 0 or 1 the shares of the ones are beta numbers, whose quantiles are the limits of Clopper and
// Pearson. 0.015 is five standard errors of their quantiles, sqrt(0.025 0.975/20000) over the density, at least 0.37 there.
TEST(UnseenRecord, GivesTheLimitsOfClopperAndPearson) {
  constexpr std::uint64_t samples = 20000;
  for (const std::uint64_t events : {0U, 1U, 4U, 9U, 10U}) {
    std::vector<double> lows, highs;
    for (std::uint64_t sample = 0; sample < samples; ++sample) {
      const std::vector<double> shares = shares_with_unseen(10, sample, draws());
      double mean = 0.0, sum = 0.0;
      for (std::size_t r = 0; r < 10; ++r) {
        sum += shares[r];
        if (r < events) mean += shares[r];
      }
      const std::vector<double> seen{mean / sum};
      lows.push_back(mean_with_unseen(seen, std::array{shares.back()}, std::array{0.0}).front());
      highs.push_back(mean_with_unseen(seen, std::array{shares.back()}, std::array{1.0}).front());
    }
    const Interval expected = clopper_pearson({.successes = events, .trials = 10}, 0.95);
    EXPECT_NEAR(percentile_interval(lows, samples, 0.95)->low, expected.low, 0.015) << events;
    EXPECT_NEAR(percentile_interval(highs, samples, 0.95)->high, expected.high, 0.015) << events;
  }
}

TEST(UnseenRecord, SharesAddUpToOne) {
  const std::vector<double> shares = shares_with_unseen(3, 7, draws());
  ASSERT_EQ(shares.size(), 4U);
  double sum = 0.0;
  for (const double share : shares) {
    EXPECT_GT(share, 0.0);
    sum += share;
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
  const std::vector<double> mean = mean_with_unseen({0.5, 0.0}, std::array{0.2, 0.2}, std::array{1.0, 1.0});
  EXPECT_THAT(mean, testing::ElementsAre(testing::DoubleEq(0.6), testing::DoubleEq(0.2)));
}

TEST(SuiteBootstrap, HasTheSpreadOfRecords) {
  SplitMix random(7);
  const SuiteLevels suite = MadeUpSuite{}.drawn(random);
  const auto found = bootstrap_records(suite, 60, draws());
  ASSERT_EQ(found.laws.size(), 60U);
  std::vector<double> medians;
  for (const SuiteLaw& law : found.laws) medians.push_back(law.median);
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
  std::size_t parts = 0;
  const auto one = bootstrap_records(suite, 30, draws());
  const auto several = bootstrap_records(suite, 30, draws(), {.threads = 3, .on_part = [&parts] { ++parts; }});
  EXPECT_EQ(parts, 30U);
  ASSERT_EQ(several.laws.size(), one.laws.size());
  for (std::size_t i = 0; i < one.laws.size(); ++i) {
    EXPECT_EQ(several.laws[i].median, one.laws[i].median);
    EXPECT_EQ(several.laws[i].between_records, one.laws[i].between_records);
  }
  std::atomic<bool> stop{false};
  parts = 0;
  const auto stops = [&] { stop = ++parts == 4; };
  EXPECT_THROW(static_cast<void>(bootstrap_records(suite, 30, draws(), {.stop = &stop, .on_part = stops})),
               rocking::base::Stopped);
  EXPECT_EQ(parts, 4U);
}

// The whole suite is a sample in which each record is drawn once: the search from its own law returns that law.
TEST(SuiteBootstrap, OfTheSuiteItselfIsItsLaw) {
  SplitMix random(9);
  const SuiteLevels suite = MadeUpSuite{}.drawn(random);
  const auto each_once = [&suite](std::uint64_t, std::uint64_t number) {
    // Further numbers are the shares of an unseen record.
    const std::uint64_t record = number < suite.size() ? number : 0;
    return (static_cast<double>(record) + 0.5) / static_cast<double>(suite.size());
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

// Of 1 ... 999 the share below 750 is 0.75, with z_0 = 0.674490: the percentiles are Phi(1.348980 -+ 1.959964).
TEST(SuiteBootstrap, HasPercentilesCorrectedForTheBiasOfTheSamples) {
  std::vector<double> values;
  for (int i = 1; i <= 999; ++i) values.push_back(i);
  const auto found = bias_corrected_interval(values, 750.0, 999, 0.95);
  EXPECT_NEAR(found->low, 270.6, 1.0);
  EXPECT_NEAR(found->high, 998.9, 0.7);
  const auto unbiased = bias_corrected_interval(values, 500.0, 999, 0.95);
  EXPECT_NEAR(unbiased->low, percentile_interval(values, 999, 0.95)->low, 1e-6);
  EXPECT_FALSE(bias_corrected_interval(values, 500.0, 2000, 0.95));
  // Of two records the expanded percentiles are 0 and 1.
  const auto all = bias_corrected_interval(values, 750.0, 999, 1.0);
  EXPECT_EQ(all->low, 1.0);
  EXPECT_EQ(all->high, 999.0);
}

// t(9) at 97.5 % is 2.262157; times sqrt(10/9) it is 2.384523, and Phi(-2.384523) = 0.008551.
TEST(ExpandedConfidence, GrowsForFewRecords) {
  EXPECT_NEAR(expanded_confidence(0.95, 10), 1.0 - 2.0 * 0.008551, 1e-6);
  EXPECT_NEAR(expanded_confidence(0.95, 1'000'000), 0.95, 1e-6);
  EXPECT_EQ(expanded_confidence(0.95, 1), 0.95);
}

TEST(RecordBootstrap, DrawsWithinALevelThatHasRecordsOfItsOwn) {
  SuiteLevels suite(5, {{1.0, {1, 4}}});
  for (int i = 0; i < 3; ++i)
    suite.insert(suite.begin() + 2 * i,
                 std::vector<RecordLevel>{{.intensity = 2.0, .happened = {3, 4}}});  // between the others
  const auto found = bootstrap_records(suite, 60, draws());
  EXPECT_EQ(found.fewest, 3U);
  bool scatters = false;
  for (const std::vector<double>& weights : found.weights) {
    double of_first = 0.0, of_second = 0.0;
    for (std::size_t r = 0; r < suite.size(); ++r) {
      (suite[r].front().intensity == 1.0 ? of_first : of_second) += weights[r];
      scatters = scatters || weights[r] == 2.0;
    }
    EXPECT_EQ(of_first, 5.0);
    EXPECT_EQ(of_second, 3.0);
  }
  EXPECT_TRUE(scatters);
}

}  // namespace
