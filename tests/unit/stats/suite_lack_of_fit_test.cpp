// The test of the law of a suite: its distance, and suites that have such a law or none.

#include "rocking/stats/lack_of_fit.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/made_up_suite.hpp"

namespace {

using namespace rocking::stats;
using rocking::support::MadeUpSuite;
using rocking::support::SplitMix;

double draw(std::uint64_t sample, std::uint64_t number) { return SplitMix((sample << 32U) + number).uniform(); }

TEST(SuiteDeviance, IsThatOfOneTrialForEachRecord) {
  // Shares of 0.25 and 1 over two records; the law has 1/2 at 1 and Phi(1) at e.
  const SuiteLevels suite{{{1.0, {1, 2}}, {std::exp(1.0), {4, 4}}}, {{1.0, {0, 2}}, {std::exp(1.0), {4, 4}}}};
  const SuiteLaw law{.median = 1.0, .between_records = 0.6, .within_record = 0.8};
  const double expected =
      4.0 * (0.25 * std::log(0.25 / 0.5) + 0.75 * std::log(0.75 / 0.5) - std::log(0.5 * std::erfc(-std::sqrt(0.5))));
  EXPECT_NEAR(suite_deviance(suite, law), expected, 1e-12);
  const SuiteLaw far{.median = 1e9, .between_records = 1e-3, .within_record = 0.0};
  EXPECT_TRUE(std::isfinite(suite_deviance(suite, far)));
}

TEST(SuiteLackOfFit, IsFoundInASuiteOfTwoKindsOfRecords) {
  SplitMix random(5);
  const SuiteLevels weak = MadeUpSuite{.median = 0.65, .between_records = 0.05, .within_record = 0.05}.drawn(random);
  SuiteLevels suite = MadeUpSuite{.median = 1.65, .between_records = 0.05, .within_record = 0.05}.drawn(random);
  suite.insert(suite.end(), weak.begin(), weak.end());
  const auto law = fit_suite(suite).law;
  ASSERT_TRUE(law);
  const auto test = suite_lack_of_fit(suite, *law, 199, draw);
  ASSERT_TRUE(test);
  EXPECT_EQ(test->p_value, static_cast<double>(test->as_large + 1) / static_cast<double>(test->samples + 1));
  EXPECT_LT(test->p_value, 0.02);
}

// p-values of suites with such a law are uniform, so that their mean is 1/2; that of 30 has the standard error 0.053.
TEST(SuiteLackOfFit, IsNotFoundInSuitesWithSuchALaw) {
  SplitMix random(6);
  int rejected = 0;
  double sum = 0.0;
  for (int i = 0; i < 30; ++i) {
    const SuiteLevels suite = MadeUpSuite{}.drawn(random);
    const auto test = suite_lack_of_fit(suite, fit_suite(suite).law.value(), 99, draw);
    ASSERT_TRUE(test);
    EXPECT_GE(test->samples, 90U);
    rejected += test->p_value <= 0.05 ? 1 : 0;
    sum += test->p_value;
  }
  EXPECT_LE(rejected, 5);
  EXPECT_NEAR(sum / 30.0, 0.5, 0.16);
}

// Its samples are the same with any number of threads.
TEST(SuiteLackOfFit, RepeatsToTheBit) {
  SplitMix random(7);
  const SuiteLevels suite = MadeUpSuite{.records = 8}.drawn(random);
  const SuiteLaw law = fit_suite(suite).law.value();
  EXPECT_EQ(suite_lack_of_fit(suite, law, 50, draw).value().as_large,
            suite_lack_of_fit(suite, law, 50, draw, {.threads = 3}).value().as_large);
}

}  // namespace
