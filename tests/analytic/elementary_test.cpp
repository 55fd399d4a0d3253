// The portable elementary functions, compared with 50-digit arithmetic. Errors are in units in the last place of the
// true value.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "rocking/base/elementary.hpp"

namespace {

using namespace rocking::base;
using Exact = boost::multiprecision::cpp_bin_float_50;

double ulps(double found, const Exact& truth) {
  int exponent = 0;
  std::frexp(static_cast<double>(abs(truth)), &exponent);
  return static_cast<double>(abs(Exact(found) - truth) / ldexp(Exact(1), exponent - 53));
}

/// `count` evenly spaced numbers in [low, high).
std::vector<double> spread(int count, double low, double high) {
  std::mt19937_64 bits(20120213);
  std::vector<double> values;
  for (int i = 0; i < count; ++i) {
    values.push_back(low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1p-53));
  }
  return values;
}

/// The same with evenly spaced logarithms.
std::vector<double> spread_logarithmically(int count, double low, double high) {
  std::vector<double> values = spread(count, std::log(low), std::log(high));
  for (double& value : values) value = std::exp(value);
  return values;
}

/// Doubles up to `limit` so close to a multiple of pi/2 that a sine or cosine is nearly zero.
std::vector<double> almost_multiples_of_a_quarter_turn(double limit, double closeness) {
  const Exact quarter = boost::math::constants::half_pi<Exact>();
  std::vector<double> values;
  for (int k = 1; k < limit / 1.5708; ++k) {
    const Exact multiple = quarter * k;
    const auto nearest = static_cast<double>(multiple);
    if (abs(multiple - nearest) < closeness) values.push_back(nearest);
  }
  return values;
}

double sine_and_cosine_error(const SinCos<double>& found, double x) {
  return std::max(ulps(found.sine, sin(Exact(x))), ulps(found.cosine, cos(Exact(x))));
}

double sin_cos_error(double x) { return sine_and_cosine_error(sin_cos(x), x); }
double reduced_sin_cos_error(double x) { return sine_and_cosine_error(reduced_sin_cos(x), x); }
double logarithm_error(double x) { return ulps(natural_logarithm(x), log(Exact(x))); }
double exponential_error(double x) { return ulps(exponential(x), exp(Exact(x))); }
double arc_tangent_error(double x) { return ulps(arc_tangent(x), atan(Exact(x))); }

/// Fails unless `error` is at most `bound` ulp for all values; prints the worst argument.
void expect_within(double bound, double (*error)(double), const std::vector<double>& values) {
  ASSERT_FALSE(values.empty());
  double worst = -1.0;
  double place = 0.0;
  for (const double x : values) {
    const double here = error(x);
    if (here > worst) {
      worst = here;
      place = x;
    }
  }
  EXPECT_LE(worst, bound) << "ulp, at x = " << std::hexfloat << place;
}

TEST(ExactNumber, IsWhatACastGives) {
  EXPECT_EQ(exact_number(0), 0.0);
  EXPECT_EQ(exact_number(std::uint64_t{1} << 53U), 0x1p53);
  EXPECT_EQ(exact_number((std::uint64_t{1} << 53U) - 1), 0x1p53 - 1);
  std::mt19937_64 bits(20120213);
  for (int i = 0; i < 10000; ++i) {
    const std::uint64_t k = bits() >> (11 + i % 53);
    ASSERT_EQ(exact_number(k), static_cast<double>(k)) << k;
  }
}

TEST(ReducedSinCos, IsWithinOneUlpUpToAnEighthOfATurn) {
  expect_within(1.0, reduced_sin_cos_error, spread(20000, -std::numbers::pi / 4, std::numbers::pi / 4));
}

TEST(ReducedSinCos, HasTheBitsOfSinCosUpToAlmostAnEighthOfATurn) {
  for (const double x : spread(20000, -almost_quarter_pi, almost_quarter_pi)) {
    ASSERT_EQ(reduced_sin_cos(x).sine, sin_cos(x).sine) << std::hexfloat << x;
    ASSERT_EQ(reduced_sin_cos(x).cosine, sin_cos(x).cosine) << std::hexfloat << x;
  }
}

TEST(SinCos, IsWithinOneAndAHalfUlpUpToAMillion) {
  for (const double limit : {1.0, 30.0, 1000.0, 1e6}) {
    expect_within(1.5, sin_cos_error, spread(5000, -limit, limit));
  }
}

TEST(SinCos, KeepsItsDigitsWhereItAllButVanishes) {
  expect_within(1.5, sin_cos_error, almost_multiples_of_a_quarter_turn(1e6, 5e-13));
  expect_within(1.5, sin_cos_error, almost_multiples_of_a_quarter_turn(1e3, 1.0));
}

TEST(SinCos, IsExactAtZeroAndHasTheRightSymmetry) {
  EXPECT_EQ(sin_cos(0.0).sine, 0.0);
  EXPECT_EQ(sin_cos(0.0).cosine, 1.0);
  for (const double x : spread(1000, 0.0, 1000.0)) {
    EXPECT_EQ(sin_cos(-x).sine, -sin_cos(x).sine);
    EXPECT_EQ(sin_cos(-x).cosine, sin_cos(x).cosine);
  }
}

TEST(NaturalLogarithm, IsWithinOneUlp) {
  expect_within(1.0, logarithm_error, spread(10000, 0.0, 1.0));
  expect_within(1.0, logarithm_error, spread(10000, 0.5, 2.0));
  expect_within(1.0, logarithm_error, spread_logarithmically(10000, 1e-307, 1e308));
}

TEST(NaturalLogarithm, KeepsItsDigitsNextToOne) {
  std::vector<double> values;
  for (int power = 1; power <= 52; ++power) {
    values.push_back(1.0 + std::ldexp(1.0, -power));
    values.push_back(1.0 - std::ldexp(1.0, -power - 1));
  }
  expect_within(1.0, logarithm_error, values);
}

TEST(NaturalLogarithm, IsRightAtTheEndsOfItsDomainAndOfItsReduction) {
  EXPECT_EQ(natural_logarithm(1.0), 0.0);
  expect_within(1.0, logarithm_error,
                {0x1p-1022, 0x1p-53, 0x1.fffffffffffffp+1023, 0x1.6a09e667f3bccp-1, 0x1.6a09e667f3bcdp-1});
}

TEST(Exponential, IsWithinOneUlp) {
  for (const double limit : {0.4, 20.0, 708.0}) expect_within(1.0, exponential_error, spread(10000, -limit, limit));
}

TEST(Exponential, IsRightWhereTheReductionTurnsAndAtTheEndsOfItsDomain) {
  EXPECT_EQ(exponential(0.0), 1.0);
  expect_within(1.0, exponential_error, {-708.0, 709.0, 0x1p-54, -0x1p-54});
  std::vector<double> half_multiples;
  for (int k = -1020; k <= 1020; ++k) {
    for (const double nearby : {-1e-12, 0.0, 1e-12}) half_multiples.push_back((k + 0.5) * std::numbers::ln2 + nearby);
  }
  expect_within(1.0, exponential_error, half_multiples);
}

TEST(ArcTangent, IsWithinTwoUlp) {
  expect_within(2.0, arc_tangent_error, spread(20000, -3.0, 3.0));
  expect_within(2.0, arc_tangent_error, spread_logarithmically(10000, 1e-17, 1e17));
}

TEST(ArcTangent, IsRightAtTheEndsOfItsDomain) {
  EXPECT_EQ(arc_tangent(0.0), 0.0);
  EXPECT_TRUE(std::signbit(arc_tangent(-0.0)));
  EXPECT_EQ(arc_tangent(1.0), std::numbers::pi / 4);
  EXPECT_EQ(arc_tangent(1e300), std::numbers::pi / 2);
  EXPECT_EQ(arc_tangent(-1e300), -std::numbers::pi / 2);
}

}  // namespace
