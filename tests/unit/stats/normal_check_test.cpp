#include "rocking/stats/normal_check.hpp"

#include <cmath>
#include <functional>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/false_alarms.hpp"
#include "support/split_mix.hpp"

namespace {

using namespace rocking::stats;
using Sample = std::vector<double>;

Sample normal_numbers(std::size_t n, std::uint64_t seed, const NormalLaw& law) {
  rocking::support::SplitMix random(seed);
  Sample sample(n);
  for (double& x : sample) x = law.mean + law.sigma * random.normal();
  return sample;
}

NormalCheck checked(std::size_t n, const NormalLaw& law = {}) {
  const Sample first = normal_numbers(n, 1, law), second = normal_numbers(n, 2, law), third = normal_numbers(n, 3, law);
  return check_normal({first, second, third}, law).value();
}

TEST(OwnLaw, IsThatOfTheNumbersWhoseShapeIsTestedAlike) {
  const NormalLaw law{4.0, 0.3};
  const Sample numbers = normal_numbers(500, 1, law);
  const NormalCheck own = check_own_law(numbers).value(), given = check_normal({numbers, {}, {}}, law).value();
  EXPECT_NEAR(own.law.mean, given.mean.moment.value, 1e-14);
  EXPECT_NEAR(own.law.sigma, given.standard_deviation.moment.value, 1e-14);
  EXPECT_NEAR(own.skewness.test.p_value, given.skewness.test.p_value, 1e-9) << "whatever mean and sigma are";
  EXPECT_NEAR(own.dagostino_pearson.p_value, given.dagostino_pearson.p_value, 1e-9);
  EXPECT_EQ(own.correlations.back().between, "lag_200") << "there are no neighbours";
  EXPECT_FALSE(is_refuted(own));
  Sample cubes = numbers;
  for (double& x : cubes) x = std::pow((x - 4.0) / 0.3, 3.0);
  EXPECT_TRUE(is_refuted(check_own_law(cubes).value()));
  EXPECT_FALSE(check_own_law(Sample(30, 2.5)));
}

// P(chi-squared of 20 degrees >= 2x) = exp(-x) sum x^k/k! over k < 10.
TEST(NormalCheck, TestsTheStandardDeviationByItsExactLaw) {
  const NormalLaw law{0.4, 0.03};
  const NormalCheck check = checked(21, law);
  const double ratio = check.standard_deviation.moment.value / law.sigma;
  const double x = 10.0 * ratio * ratio;
  double term = std::exp(-x), above = 0.0;
  for (int k = 0; k < 10; ++k) {
    above += term;
    term *= x / (k + 1);
  }
  EXPECT_NEAR(check.standard_deviation.p_value, 2.0 * std::min(above, 1.0 - above), 1e-12);
}

// The standard error of the skewness of 20000 normal numbers is 0.01732: erf(0.01/0.01732/sqrt 2) = 0.4363. The score,
// which uses the fourth moment too, gives 1.5e-4 more. For the kurtosis erf(0.01/0.03463/sqrt 2) = 0.2272.
TEST(NormalCheck, SaysHowOftenATrueSampleIsAsNear) {
  const NormalCheck check = checked(20000);
  EXPECT_EQ(check.skewness.nearness[0].distance, 0.01);
  EXPECT_NEAR(check.skewness.nearness[0].probability, 0.4363, 3e-4);
  EXPECT_NEAR(check.kurtosis.nearness[0].probability, 0.2272, 3e-3);
  for (const ShapeTest& shape : {check.skewness, check.kurtosis}) {
    EXPECT_GT(shape.nearness[1].probability, 0.0);
    EXPECT_LT(shape.nearness[1].probability, 1.0);
  }
  EXPECT_EQ(check.skewness.nearness[1].distance, std::abs(check.skewness.test.moment.value));
  EXPECT_NEAR(check.skewness.nearness[1].probability, 1.0 - check.skewness.test.p_value, 1e-14);
  EXPECT_EQ(check.kurtosis.nearness[1].distance, std::abs(check.kurtosis.test.moment.value - 3.0));
}

TEST(NormalCheck, NamesItsCorrelations) {
  std::vector<std::string> names;
  for (const CorrelationTest& correlation : checked(201).correlations) names.push_back(correlation.between);
  EXPECT_THAT(names, ::testing::ElementsAre("members_of_a_pair", "squares_in_a_pair", "lag_1", "lag_2", "lag_3",
                                            "lag_200", "neighbouring_realisations", "neighbouring_sources"));
  EXPECT_EQ(checked(200).correlations.size(), 7U) << "no number has one 200 places later";
  EXPECT_EQ(p_values_of(checked(201)).size(), 18U);
}

TEST(NormalCheck, SaysHowOftenTheSmallestPValueIsAsSmall) {
  NormalCheck check = checked(201);
  check.kurtosis.test.p_value = 1e-9;
  const SmallestPValue smallest = smallest_p_value(check);
  EXPECT_EQ(smallest.value, 1e-9);
  EXPECT_EQ(smallest.tests, 18U);
  // 1 - (1 - p)^18 = 18 p - 153 p^2 + ...
  EXPECT_NEAR(smallest.probability, 18e-9 - 153e-18, 1e-23);
}

TEST(NormalCheck, ComparesWithTheStreamsThatItIsGiven) {
  rocking::support::FalseAlarms alarms;
  const Sample a = normal_numbers(1000, 1, {}), b = normal_numbers(1000, 2, {});
  const NormalCheck same_realisation = check_normal({a, a, b}, {}).value();
  EXPECT_GT(same_realisation.correlations[6].test.moment.value, 0.8);
  EXPECT_LT(std::abs(same_realisation.correlations[7].test.moment.z), alarms.score());
  EXPECT_TRUE(is_refuted(same_realisation));
  EXPECT_TRUE(is_refuted(check_normal({a, b, a}, {}).value()));
  const NormalCheck none = check_normal({a, b, b}, {}).value();
  EXPECT_LT(std::abs(none.correlations[6].test.moment.z), alarms.score());
  EXPECT_LT(std::abs(none.correlations[7].test.moment.z), alarms.score());
}

TEST(NormalCheck, IsAbsentWhereAllNumbersAreAlike) {
  const Sample alike(100, 0.4);
  EXPECT_FALSE(check_normal({alike, alike, alike}, {0.4, 0.03}).has_value());
}

/// The check of a good sample with one p-value replaced.
NormalCheck with(const std::function<double&(NormalCheck&)>& member, double p_value, std::uint64_t n = 1000) {
  NormalCheck check = checked(1000);
  check.n = n;
  member(check) = p_value;
  return check;
}

TEST(Refutation, LooksAtEachPValueThatIsGoodSoFarOut) {
  const std::vector<std::function<double&(NormalCheck&)>> members = {
      [](NormalCheck& c) -> double& { return c.mean.p_value; },
      [](NormalCheck& c) -> double& { return c.standard_deviation.p_value; },
      [](NormalCheck& c) -> double& { return c.anderson_darling.p_value; },
      [](NormalCheck& c) -> double& { return c.kolmogorov_smirnov.p_value; },
      [](NormalCheck& c) -> double& { return c.tails[0].p_value; },
      [](NormalCheck& c) -> double& { return c.tails[2].p_value; }};
  for (std::size_t i = 0; i < members.size(); ++i) {
    EXPECT_TRUE(is_refuted(with(members[i], 0.9e-6))) << i;
    EXPECT_TRUE(is_refuted(with(members[i], 0.9e-6, 20))) << i;
    EXPECT_FALSE(is_refuted(with(members[i], 1.1e-6))) << i;
  }
}

TEST(Refutation, LooksAtCorrelationsWhereTheyAreNormal) {
  const auto lag = [](NormalCheck& c) -> double& { return c.correlations[2].test.p_value; };
  const auto squares = [](NormalCheck& c) -> double& { return c.correlations[1].test.p_value; };
  EXPECT_TRUE(is_refuted(with(lag, 0.9e-6, 1000)));
  EXPECT_FALSE(is_refuted(with(lag, 0.9e-6, 999)));
  EXPECT_FALSE(is_refuted(with(lag, 1.1e-6, 1000)));
  EXPECT_FALSE(is_refuted(with(squares, 0.0, 1000)));
}

}  // namespace
