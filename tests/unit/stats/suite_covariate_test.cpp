// How the capacities of a suite depend on a number of its records.

#include "rocking/stats/fit_suite.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/made_up_suite.hpp"

namespace {

using namespace rocking::stats;
using rocking::support::MadeUpSuite;
using rocking::support::SplitMix;

/// A suite whose median grows by the factor exp(slope) for each unit of the number of a record.
SuiteLevels depending(double slope, const std::vector<double>& numbers, SplitMix& random) {
  SuiteLevels suite;
  for (const double number : numbers) {
    const MadeUpSuite one{.records = 1, .median = std::exp(slope * (number - 6.5)), .between_records = 0.2};
    suite.push_back(one.drawn(random).front());
  }
  return suite;
}

std::vector<double> magnitudes(SplitMix& random) {
  std::vector<double> numbers;
  for (int i = 0; i < 30; ++i) numbers.push_back(random.uniform(5.5, 7.5));
  return numbers;
}

TEST(SuiteCovariate, FindsADependence) {
  SplitMix random(11);
  const std::vector<double> numbers = magnitudes(random);
  const auto found = suite_covariate(depending(-0.4, numbers, random), numbers);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->slope, -0.4, 0.2);
  EXPECT_LT(found->p_value, 0.01);
}

// A made-up suite without a dependence has a p-value below 5 % in one of twenty cases.
TEST(SuiteCovariate, RarelyFindsOneThatIsNotThere) {
  SplitMix random(12);
  int found = 0;
  for (int i = 0; i < 20; ++i) {
    const std::vector<double> numbers = magnitudes(random);
    found += suite_covariate(depending(0.0, numbers, random), numbers).value().p_value < 0.05 ? 1 : 0;
  }
  EXPECT_LE(found, 3);
}

TEST(SuiteCovariate, IsAbsentWithoutRecordsOrNumbersThatDiffer) {
  SplitMix random(13);
  const std::vector<double> equal(30, 6.5);
  EXPECT_FALSE(suite_covariate(depending(0.0, equal, random), equal));
  EXPECT_FALSE(suite_covariate(depending(0.0, {6.0, 6.5, 7.0}, random), {6.0, 6.5, 7.0}));
}

}  // namespace
