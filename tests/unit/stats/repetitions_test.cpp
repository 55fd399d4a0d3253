// Sums of independent estimates: cases with known answers.

#include "rocking/stats/repetitions.hpp"

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "rocking/stats/student_law.hpp"

namespace {

using rocking::stats::mean_of_repetitions;
using rocking::stats::Stratum;
using rocking::stats::sum_of_strata;
using rocking::stats::two_sided_t_quantile;

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

}  // namespace
