#include "rocking/stats/normality.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/stats/moments.hpp"

namespace {

using namespace rocking::stats;
using Sample = std::vector<double>;

/// Scores at which the distribution function of the law is exactly evenly spaced: as near to a normal law as n numbers
/// can be.
Sample evenly_spread(std::size_t n) {
  Sample sample;
  for (std::size_t i = 0; i < n; ++i) {
    double low = -10.0, high = 10.0;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (normal_cdf(middle) * static_cast<double>(2 * n) < static_cast<double>(2 * i + 1) ? low : high) = middle;
    }
    sample.push_back(low);
  }
  return sample;
}

Sample whole_numbers(std::size_t n) {
  Sample sample(n);
  std::iota(sample.begin(), sample.end(), 0.0);
  return sample;
}

// Critical values of Stephens (1974, 1986) for a normal law with the mean and the standard deviation of the numbers; the
// approximations agree to the last digit of the tables.
TEST(OwnLaw, HasTheCriticalValuesOfTheTables) {
  const auto numbers = [](double a) { return a / (1.0 + 0.75 / 50.0 + 2.25 / 2500.0); };
  const auto distance = [](double d) { return d / (std::sqrt(50.0) - 0.01 + 0.85 / std::sqrt(50.0)); };
  for (const auto& [p, a, d] :
       {std::tuple{0.10, 0.631, 0.819}, {0.05, 0.752, 0.895}, {0.025, 0.873, 0.955}, {0.01, 1.035, 1.035}}) {
    EXPECT_NEAR(anderson_darling_p_value_of_own_law(numbers(a), 50) / p, 1.0, 0.03) << p;
    EXPECT_NEAR(lilliefors_p_value(distance(d), 50) / p, 1.0, 0.15) << p;
  }
  EXPECT_NEAR(anderson_darling_p_value_of_own_law(numbers(0.341), 50), 0.5, 0.01);
  double last = 1.0;
  for (double a = 0.01; a < 40.0; a += 0.01) {
    const double now = anderson_darling_p_value_of_own_law(a, 50);
    EXPECT_LE(now, last + 0.001) << a;
    last = now;
  }
}

TEST(NormalLaw, KeepsItsDigitsFarOut) {
  // mpmath, 40 digits
  const double known[][2] = {{3.0, -0.0013508099647481938}, {9.0, -1.1285884059538406e-19},
                             {-1.0, -1.8410216450092635},   {-10.0, -53.231285150512471},
                             {-29.5, -439.42947460915023},  {-30.5, -469.46273732291211},
                             {-40.0, -804.60844201375379},  {-100.0, -5005.5242086942051}};
  for (const auto& [z, logarithm] : known) EXPECT_NEAR(log_normal_cdf(z), logarithm, 4e-13 * std::abs(logarithm)) << z;
}

// The scores 3.57177 of the skewness and -1.70581 of the kurtosis are the examples of SciPy's skewtest and
// kurtosistest; the others and the sums are from 40-digit arithmetic (mpmath).
TEST(DAgostinoPearson, GivesTheKnownStatistic) {
  EXPECT_NEAR(dagostino_pearson(whole_numbers(20)).statistic, 1.7058104152122049 * 1.7058104152122049, 1e-13);
  EXPECT_NEAR(dagostino_pearson(Sample{1, 2, 3, 4, 5, 6, 7, 8000}).statistic, 22.957410548037796, 1e-12);
  EXPECT_NEAR(dagostino_pearson(Sample{1, 2, 3, 4, 5, 6, 7, 8000}).p_value, 1.0348124379791744e-5, 1e-16);
  EXPECT_NEAR(dagostino_pearson(Sample{2, 8, 0, 4, 1, 9, 9, 0}).statistic, 3.6241771605030538, 1e-13);
}

TEST(MomentTests, DoNotDependOnPlaceAndScale) {
  Sample sample = evenly_spread(30);
  sample.back() = 7.0;
  Sample moved = sample;
  for (double& x : moved) x = 0.4 + 0.03 * x;
  EXPECT_NEAR(dagostino_pearson(moved).statistic, dagostino_pearson(sample).statistic, 1e-10);
}

// The examples of SciPy's skewtest and kurtosistest.
TEST(ShapeScores, AreThoseOfTheKnownExamples) {
  const double skewness = central_moments(Sample{1, 2, 3, 4, 5, 6, 7, 8000}).skewness();
  EXPECT_NEAR(skewness_score(skewness, 8), 3.571773510360407, 1e-12);
  EXPECT_EQ(skewness_score(-skewness, 8), -skewness_score(skewness, 8));
  EXPECT_NEAR(kurtosis_score(central_moments(whole_numbers(20)).kurtosis(), 20), -1.7058104152122062, 1e-12);
}

// Percentage points of A^2 for a given law: Stephens (1974), J. Am. Stat. Assoc. 69, 730-737, Table 1. The density is
// at most 0.1, and the table is accurate to half a unit of its third decimal; at 3.857 it is known to be wrong by 2 %.
TEST(AndersonDarling, HasThePublishedPercentPoints) {
  EXPECT_NEAR(anderson_darling_p_value(1.933, 1000000), 0.100, 5e-5);
  EXPECT_NEAR(anderson_darling_p_value(2.492, 1000000), 0.050, 5e-5);
  EXPECT_NEAR(anderson_darling_p_value(3.070, 1000000), 0.025, 3e-4);
  EXPECT_NEAR(anderson_darling_p_value(3.857, 1000000), 0.010, 3e-4);
}

constexpr std::size_t so_many_that_n_does_not_show = 1000000000000;

// The limit law by another method: Imhof's (1961, Biometrika 48) inversion of the characteristic function of the sum of
// Y_j^2/(j (j + 1)), with sixty factors and the rest to second order, in steps of 0.01. Its relative error is 1e-9: two
// hundred factors change it by 7e-10.
TEST(AndersonDarling, HasTheLimitLawToItsDigits) {
  const double known[][2] = {{2.492, 0.05002218632516}, {3.07, 0.02521827112237},  {3.857, 0.01024115322476},
                             {4.5, 0.004990026457567},  {6.0, 0.0009674519411136}, {8.0, 0.0001138141556786}};
  for (const auto& [statistic, p] : known) {
    EXPECT_NEAR(anderson_darling_p_value(statistic, so_many_that_n_does_not_show), p, 1e-9 * p) << statistic;
  }
  EXPECT_NEAR(anderson_darling_p_value(1.933, so_many_that_n_does_not_show), 0.0999946230, 1.2e-5);
}

// For large z only the first factor matters: sqrt(3) erfc(sqrt z) (1 + 0.3/z) (Zolotarev 1961, Theory Probab. Appl. 6).
TEST(AndersonDarling, HasTheRightTail) {
  for (const double z : {8.0, 12.0, 16.0, 20.0}) {
    const double leading = std::sqrt(3.0) * std::erfc(std::sqrt(z));
    EXPECT_NEAR(anderson_darling_p_value(z, so_many_that_n_does_not_show) / leading, 1.0 + 0.3 / z, 0.002 / z) << z;
  }
}

TEST(AndersonDarling, IsItsDefinitionOnOneNumber) {
  // One number at the median: A^2 = -1 - ln(1/4).
  EXPECT_DOUBLE_EQ(anderson_darling(Sample{0.4}, {0.4, 0.03}).statistic, 2.0 * std::log(2.0) - 1.0);
}

TEST(AndersonDarling, StaysFiniteForNumbersThatTheLawHardlyAllows) {
  const TestOfFit test = anderson_darling(Sample{-1e6, 0.0, 1e6}, {});
  EXPECT_TRUE(std::isfinite(test.statistic));
  EXPECT_EQ(test.p_value, std::clamp(test.p_value, 0.0, 1e-3));
}

TEST(AndersonDarling, IsAProbabilityThatFallsWithTheStatistic) {
  for (const std::size_t n : {10U, 100U, 20000U}) {
    double before = 1.0;
    for (double statistic = 0.01; statistic < 20.0; statistic += 0.01) {
      const double p = anderson_darling_p_value(statistic, n);
      ASSERT_TRUE(0.0 <= p && p <= before + 3e-6 + 1e-3 / static_cast<double>(n)) << n << " " << statistic;
      before = p;
    }
  }
}

TEST(KolmogorovSmirnov, MeasuresTheLargestStep) {
  EXPECT_DOUBLE_EQ(kolmogorov_smirnov(Sample{0.4}, {0.4, 0.03}).statistic, 0.5);
  EXPECT_NEAR(kolmogorov_smirnov(evenly_spread(100), {}).statistic, 0.005, 1e-12);
  EXPECT_DOUBLE_EQ(kolmogorov_smirnov(Sample{-50.0, -50.0, 50.0}, {}).statistic, 2.0 / 3.0);
}

// Kolmogorov's limit law: the percentage points of the published tables, to their digits.
TEST(KolmogorovSmirnov, HasThePublishedPercentPoints) {
  const std::size_t n = 10000000000;  // so large that the correction for n is negligible
  EXPECT_NEAR(kolmogorov_p_value(1.22385e-5, n), 0.10, 1e-5);
  EXPECT_NEAR(kolmogorov_p_value(1.35810e-5, n), 0.05, 1e-5);
  EXPECT_NEAR(kolmogorov_p_value(1.62762e-5, n), 0.01, 1e-5);
  EXPECT_NEAR(kolmogorov_p_value(0.82757e-5, n), 0.50, 1e-5);
}

TEST(KolmogorovSmirnov, JoinsItsTwoSeriesWithoutAStep) {
  const auto tail = [](double x) { return kolmogorov_p_value(1e-6 * x, 1000000000000); };
  const double h = 1e-5;
  // The second derivative is below 5 here, so that a second difference above 5 h^2 shows a discontinuity.
  for (double x = 0.84; x < 0.86; x += h) EXPECT_NEAR(tail(x - h) - 2.0 * tail(x) + tail(x + h), 0.0, 5.0 * h * h) << x;
}

/// P(D < d) exactly: the middle element of (n!/n^n) H^n. Durbin's matrix as in Marsaglia, Tsang & Wang (2003), J. Stat.
/// Softw. 8(18); for n up to a few hundred, where nothing overflows if n!/n^n is distributed over the factors.
double exact_probability_below(std::size_t n, double d) {
  const auto size = static_cast<double>(n);
  const auto k = static_cast<std::size_t>(size * d) + 1;
  const std::size_t m = 2 * k - 1;
  const double h = static_cast<double>(k) - size * d;
  std::vector<std::vector<double>> matrix(m, std::vector<double>(m, 0.0));
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < std::min(m, i + 2); ++j) matrix[i][j] = 1.0;
  }
  for (std::size_t i = 0; i < m; ++i) {
    matrix[i][0] -= std::pow(h, i + 1);
    matrix[m - 1][i] -= std::pow(h, m - i);
  }
  if (2.0 * h > 1.0) matrix[m - 1][0] += std::pow(2.0 * h - 1.0, m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < std::min(m, i + 2); ++j) matrix[i][j] /= std::tgamma(static_cast<double>(i + 2 - j));
  }
  std::vector<double> row(m, 0.0);
  row[k - 1] = 1.0;
  for (std::size_t factor = 1; factor <= n; ++factor) {
    std::vector<double> next(m, 0.0);
    for (std::size_t i = 0; i < m; ++i) {
      for (std::size_t j = 0; j < m; ++j) next[j] += row[i] * matrix[i][j] * static_cast<double>(factor) / size;
    }
    row = next;
  }
  return row[k - 1];
}

TEST(KolmogorovSmirnov, IsAsNearToTheExactLawAsItSays) {
  EXPECT_NEAR(exact_probability_below(10, 0.274), 0.628480, 1e-6);  // the example of Marsaglia, Tsang & Wang
  for (const std::size_t n : {20U, 100U, 400U}) {
    for (double x = 0.3; x < 2.2; x += 0.05) {
      const double distance = x / std::sqrt(static_cast<double>(n));
      const double exact = 1.0 - exact_probability_below(n, distance);
      EXPECT_NEAR(kolmogorov_p_value(distance, n), exact, 0.03 / static_cast<double>(n)) << n << " " << x;
    }
  }
}

TEST(TestsOfTheGivenLaw, DoNotDependOnTheOrderOfTheSample) {
  Sample sample = evenly_spread(25);
  sample[3] = 4.0;
  Sample reversed(sample.rbegin(), sample.rend());
  EXPECT_EQ(kolmogorov_smirnov(sample, {}).statistic, kolmogorov_smirnov(reversed, {}).statistic);
  EXPECT_EQ(anderson_darling(sample, {}).statistic, anderson_darling(reversed, {}).statistic);
}

TEST(TestsOfTheGivenLaw, SeeAShiftAndAScale) {
  const Sample sample = evenly_spread(2000);
  EXPECT_GT(kolmogorov_smirnov(sample, {}).p_value, 0.999);
  EXPECT_GT(anderson_darling(sample, {}).p_value, 0.999);
  for (const NormalLaw& other : {NormalLaw{0.1, 1.0}, NormalLaw{0.0, 1.15}}) {
    EXPECT_LT(kolmogorov_smirnov(sample, other).p_value, 0.05);
    EXPECT_LT(anderson_darling(sample, other).p_value, 0.01);
  }
}

}  // namespace
