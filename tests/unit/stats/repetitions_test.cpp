// Sums of independent estimates: cases with known answers.

#include "rocking/stats/repetitions.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <boost/math/distributions/normal.hpp>
#include <gtest/gtest.h>

#include "rocking/stats/normal_law.hpp"

namespace {

using rocking::stats::mean_of_repetitions;
using rocking::stats::Stratum;
using rocking::stats::sum_of_strata;
using rocking::stats::two_sided_t_quantile;

/// The quantiles of a lognormal law at even steps of probability, but the upper ones.
std::vector<double> lognormal_without_tail(double sigma, std::size_t count, std::size_t missing) {
  std::vector<double> estimates;
  for (std::size_t i = 0; i + missing < count; ++i) {
    const double p = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    estimates.push_back(1e-8 * std::exp(sigma * boost::math::quantile(boost::math::normal(), p)));
  }
  return estimates;
}

double sampled_error(const std::vector<double>& estimates) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double each : estimates) {
    sum += each;
    squares += each * each;
  }
  const auto n = static_cast<double>(estimates.size());
  return std::sqrt((squares * n / (sum * sum) - 1.0) / (n - 1.0));
}

// The law has the coefficient of variation sqrt(e^1.44 - 1) = 1.80. Without its largest 3 % a sample shows 1.1.
TEST(MeanOfRepetitions, HasAnErrorThatKnowsOfLargeOnesBeforeTheyCome) {
  const std::vector<double> estimates = lognormal_without_tail(1.2, 200, 6);
  const auto mean = mean_of_repetitions(estimates, 0.95);
  const double root = std::sqrt(194.0);
  EXPECT_LT(sampled_error(estimates) * root, 1.3);
  EXPECT_NEAR(*mean.relative_error * root, 1.80, 0.3);
  EXPECT_NEAR(std::log(mean.interval->high / mean.mean), two_sided_t_quantile(0.95, 193.0) * *mean.relative_error,
              1e-12);
}

TEST(MeanOfRepetitions, HasAtMostTwiceTheSampledError) {
  const std::vector<double> far_apart{1e-30, 1e-20, 1e-8, 1.1e-8, 0.9e-8, 1e-8, 1e-8};
  EXPECT_NEAR(*mean_of_repetitions(far_apart, 0.95).relative_error, 2.0 * sampled_error(far_apart), 1e-14);
}

TEST(MeanOfRepetitions, HasTheSampledErrorWhereThatIsTheLargerOne) {
  std::vector<double> one_large(20, 1e-8);
  one_large.push_back(5e-8);
  EXPECT_NEAR(*mean_of_repetitions(one_large, 0.95).relative_error, sampled_error(one_large), 1e-14);
  const std::vector<double> one_seen{0.0, 0.0, 3e-8, 0.0};
  EXPECT_NEAR(*mean_of_repetitions(one_seen, 0.95).relative_error, sampled_error(one_seen), 1e-14);
}

TEST(SumOfStrata, IsThatOfTheRepetitionsForOneStratum) {
  const std::array estimates{1e-6, 3e-6, 2e-6, 6e-6};
  const auto mean = mean_of_repetitions(estimates, 0.9);
  const std::array one{
      Stratum{.mean = mean.mean, .standard_error = mean.mean * *mean.relative_error, .degrees_of_freedom = 3.0}};
  const auto sum = sum_of_strata(one, 0.9);
  EXPECT_DOUBLE_EQ(sum.mean, mean.mean);
  EXPECT_DOUBLE_EQ(*sum.relative_error, *mean.relative_error);
  EXPECT_NEAR(sum.interval->low / mean.interval->low, 1.0, 1e-12);
  EXPECT_NEAR(sum.interval->high / mean.interval->high, 1.0, 1e-12);
}

// Variances add up, and so do the degrees of freedom of equal ones.
TEST(SumOfStrata, OfEqualOnesHasTheirDegreesOfFreedomTogether) {
  const Stratum one{.mean = 2e-9, .standard_error = 4e-10, .degrees_of_freedom = 5.0};
  const auto sum = sum_of_strata(std::array{one, one, one, one}, 0.95);
  EXPECT_DOUBLE_EQ(sum.mean, 8e-9);
  EXPECT_DOUBLE_EQ(*sum.relative_error, 0.1);
  EXPECT_NEAR(std::log(sum.interval->high / 8e-9), 0.1 * two_sided_t_quantile(0.95, 20.0), 1e-12);
}

// One that decides the variance decides the degrees of freedom.
TEST(SumOfStrata, HasTheDegreesOfFreedomOfTheLeastCertain) {
  const auto sum = sum_of_strata(std::array{Stratum{.mean = 1.0, .standard_error = 0.3, .degrees_of_freedom = 4.0},
                                            Stratum{.mean = 1e6, .standard_error = 1e-6, .degrees_of_freedom = 1e9}},
                                 0.95);
  EXPECT_NEAR(std::log(sum.interval->high / sum.mean), 0.3 / sum.mean * two_sided_t_quantile(0.95, 4.0), 1e-14);
}

TEST(SumOfStrata, HasNoWidthWithoutErrors) {
  const auto sum = sum_of_strata(std::array{Stratum{.mean = 1.0}, Stratum{.mean = 0.5}}, 0.95);
  EXPECT_EQ(sum.interval->low, 1.5);
  EXPECT_EQ(sum.interval->high, 1.5);
  EXPECT_EQ(sum.relative_error, 0.0);
}

// An event that always happens: the probability of 16 repetitions of 16 is 1 - 0.025 at 0.025^(1/16).
TEST(MeanOfRepetitions, HasTheExactIntervalWhereAllAreEqual) {
  const std::vector<double> estimates(16, 1.0);
  const auto mean = mean_of_repetitions(estimates, 0.95);
  EXPECT_EQ(mean.mean, 1.0);
  EXPECT_NEAR(mean.interval->low, std::pow(0.025, 1.0 / 16.0), 1e-12);
  EXPECT_EQ(mean.interval->high, 1.0);
}

TEST(MeanOfRepetitions, IsTheMeanWithStudentsIntervalOfItsLogarithm) {
  const std::vector<double> estimates{1.5e-9, 1.5e-9, 3e-9};
  const auto mean = mean_of_repetitions(estimates, 0.95);
  EXPECT_DOUBLE_EQ(mean.mean, 2e-9);
  ASSERT_TRUE(mean.relative_error && mean.interval);
  EXPECT_NEAR(*mean.relative_error, 0.25, 1e-14) << "a lognormal law would have 0.240";
  EXPECT_NEAR(std::log(mean.interval->high / 2e-9), 0.95 / std::sqrt(2.0 * 0.975 * 0.025) * 0.25, 1e-12);
  EXPECT_NEAR(mean.interval->low * mean.interval->high, 4e-18, 1e-30);
}

TEST(MeanOfRepetitions, HasNoIntervalWithoutTheEventOrFromOneEstimate) {
  EXPECT_FALSE(mean_of_repetitions(std::vector<double>{0.0, 0.0}, 0.95).interval);
  EXPECT_FALSE(mean_of_repetitions(std::vector<double>{0.1}, 0.95).interval);
}

}  // namespace
