// Laws of quantities: each value as a function of its random number, against other formulas.

#include "rocking/scene/quantity.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include <boost/math/constants/constants.hpp>
#include <boost/math/distributions/lognormal.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/triangular.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/base/normal_law.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {
namespace {

using boost::math::cdf;
using boost::math::complement;
using ::testing::HasSubstr;

const boost::math::normal standard_law;

/// To 50 digits: the functions for doubles lose some far out.
using Exact = boost::multiprecision::cpp_bin_float_50;
const boost::math::normal_distribution<Exact> exact_law;

double relative_error(double found, const Exact& exact) { return static_cast<double>(abs(Exact(found) / exact - 1)); }

TEST(NormalLaw, HasTheTailsAndQuantilesOfAnotherLibrary) {
  for (double x = -36.9; x < 36.9; x += 0.171) {
    EXPECT_LT(relative_error(base::normal_upper_tail(x), cdf(complement(exact_law, Exact(x)))), 5e-15) << x;
    EXPECT_LT(relative_error(base::normal_density(x), pdf(exact_law, Exact(x))), 1e-15) << x;
  }
  for (double power = 0.5; power < 900.0; power *= 1.07) {
    const double tail = std::exp2(-power);
    const Exact x = quantile(complement(exact_law, Exact(tail)));
    EXPECT_LT(static_cast<double>(abs(base::normal_quantile_of_tail(tail) - x) / (1 + abs(x))), 1e-14) << tail;
    const Exact opposite = quantile(exact_law, Exact(tail));
    if (power > 20.0) continue;  // 1 - tail keeps few digits of the tail
    EXPECT_NEAR(base::normal_quantile_of_tail(1.0 - tail), static_cast<double>(opposite), 1e-9) << tail;
  }
  EXPECT_EQ(base::normal_upper_tail(40.0), 0.0);
  EXPECT_EQ(base::normal_upper_tail(-40.0), 1.0);
}

/// Probability of at most x.
using Distribution = std::function<double(double)>;

/// The value at a uniform number u is the quantile of u; at a normal number z it is that of Phi(z).
void expect_quantiles(const Quantity& law, const Distribution& distribution) {
  double last = -std::numeric_limits<double>::infinity();
  const Reach reach = reach_of(law);
  double mean = 0.0;
  constexpr int n = 20'000;
  for (int i = 0; i < n; ++i) {
    const double u = (i + 0.5) / n;
    const double draw = drawn_from(law) == BasicDraw::uniform ? u : quantile(standard_law, u);
    const double value = value_at(law, draw);
    EXPECT_NEAR(distribution(value), u, 2e-12) << value;
    EXPECT_LE(last, value);
    EXPECT_LE(reach.least, value);
    EXPECT_GE(reach.largest, value);
    last = value;
    mean += value / n;
  }
  EXPECT_NEAR(mean, mean_of(law), 2e-4 * (reach.largest - reach.least));
  const Quantity half = divided(law, 2.0);
  EXPECT_NEAR(value_at(half, 0.3), 0.5 * value_at(law, 0.3), 1e-15 * std::abs(last));
  EXPECT_NEAR(mean_of(half), 0.5 * mean_of(law), 1e-14 * std::abs(last));
}

TEST(Laws, HaveTheirQuantiles) {
  expect_quantiles(Uniform{-1.0, 3.0}, [](double x) { return (x + 1.0) / 4.0; });
  expect_quantiles(Normal{.mean = 2.0, .sigma = 0.5}, [](double x) { return cdf(standard_law, (x - 2.0) / 0.5); });
  const double variance = std::log1p(0.15 * 0.15 / (0.6 * 0.6));
  const boost::math::lognormal lognormal(std::log(0.6) - 0.5 * variance, std::sqrt(variance));
  EXPECT_NEAR(boost::math::mean(lognormal), 0.6, 1e-15);
  EXPECT_NEAR(boost::math::standard_deviation(lognormal), 0.15, 1e-15);
  expect_quantiles(Lognormal{.mean = 0.6, .sigma = 0.15}, [&](double x) { return cdf(lognormal, x); });
  const boost::math::triangular triangular(0.4, 0.5, 0.9);
  expect_quantiles(Triangular{0.4, 0.5, 0.9}, [&](double x) { return cdf(triangular, x); });
  expect_quantiles(Triangular{0.4, 0.4, 0.9}, [](double x) { return 1.0 - std::pow((0.9 - x) / 0.5, 2); });
  expect_quantiles(Triangular{0.4, 0.9, 0.9}, [](double x) { return std::pow((x - 0.4) / 0.5, 2); });
}

TEST(TruncatedNormal, HasTheQuantilesOfItsPartAlsoFarOut) {
  for (const Reach between : {Reach{-1.0, 0.5}, Reach{5.0, 6.0}, Reach{-6.0, -5.0}, Reach{-8.0, 30.0}}) {
    const Normal law{
        .mean = 1.0, .sigma = 0.25, .between = Reach{1.0 + 0.25 * between.least, 1.0 + 0.25 * between.largest}};
    // Of the mirrored law, whose tail is the small one.
    const bool mirrored = between.least + between.largest < 0.0;
    const auto tail = [&](double score) { return cdf(complement(standard_law, mirrored ? -score : score)); };
    const double at_low = tail(between.least), at_high = tail(between.largest);
    expect_quantiles(law, [&](double x) { return (tail((x - 1.0) / 0.25) - at_low) / (at_high - at_low); });
  }
}

/// Mean of a truncated normal law: from densities and tails, whose differences lose up to 40 of 100 digits.
Exact exact_mean(const Normal& law) {
  using Digits = boost::multiprecision::cpp_bin_float_100;
  const Digits mean(law.mean), sigma(law.sigma);
  Digits low = (Digits(law.between->least) - mean) / sigma;
  Digits high = (Digits(law.between->largest) - mean) / sigma;
  const bool is_mirrored = low + high < 0;
  if (is_mirrored) std::tie(low, high) = std::pair<Digits, Digits>(-high, -low);
  const auto density = [](const Digits& x) -> Digits {
    return exp(-x * x / 2) / sqrt(2 * boost::math::constants::pi<Digits>());
  };
  const auto tail = [](const Digits& x) -> Digits { return boost::math::erfc(x / sqrt(Digits(2))) / 2; };
  const Digits score = (density(low) - density(high)) / (tail(low) - tail(high));
  return Exact(mean + sigma * (is_mirrored ? -score : score));
}

TEST(TruncatedNormal, HasItsMeanWhateverItsBounds) {
  for (const double sigma : {1e-6, 0.01, 0.3, 1.0, 1e3, 1e6}) {
    for (const double low : {-30.0, -9.0, -2.0, -1.0, -1e-7, 0.0, 0.5, 3.0, 11.0, 25.0}) {
      for (const double width : {1e-13, 1e-9, 1e-6, 1e-3, 0.1, 1.0, 2.0, 10.0, 18.0, 60.0}) {
        for (const double mean : {0.0, 1.0, -2.5 * sigma, 1e6}) {
          const Reach between{mean + sigma * low, mean + sigma * (low + width)};
          if (!(between.least < between.largest)) continue;
          const Normal law{.mean = mean, .sigma = sigma, .between = between};
          const double wide = between.largest - between.least;
          const double rounding = 0x1p-52 * std::max(std::abs(between.least), std::abs(between.largest));
          EXPECT_NEAR(static_cast<double>(Exact(law.expected()) - exact_mean(law)), 0.0, 1e-14 * wide + rounding)
              << mean << ' ' << sigma << ' ' << low << ' ' << width;
        }
      }
    }
  }
  const Normal wide{.mean = 1e6, .sigma = 1e6, .between = Reach{0.30, 0.3001}};
  EXPECT_NEAR(wide.expected(), 0.30005, 1e-14) << "the density changes by 1e-10 over the interval";
}

TEST(TruncatedNormal, IsDrawnFromATinyIntervalAsWell) {
  // Nearly uniform; by tails each value was one of its ends.
  const Normal law{.mean = 1e6, .sigma = 1e6, .between = Reach{0.3, 0.3 + 1e-9}};
  for (const double u : {0.0, 0.1, 0.5, 0.9}) EXPECT_NEAR(law.at(u), 0.3 + 1e-9 * u, 2e-16) << u;
  // Where the density falls by exp(-8e-6) over the interval.
  const Normal tail{.mean = 0.0, .sigma = 1.0, .between = Reach{8.0, 8.000001 - 1e-9}};
  const double width = tail.between->largest - tail.between->least;
  for (const double u : {0.1, 0.5, 0.9}) {
    const double slope = (8.0 + 0.5 * width) * width;
    EXPECT_NEAR(tail.at(u), 8.0 - width * std::log1p(u * std::expm1(-slope)) / slope, 2e-15) << u;
  }
}

TEST(Quantity, TakesWholeNumbersToo) {
  EXPECT_EQ(mean_of(Quantity(4)), 4.0);
  Quantity quantity = Uniform{0.0, 1.0};
  quantity = 3;
  EXPECT_EQ(quantity, Quantity(3.0));
}

TEST(Values, AreChosenByTheirWeights) {
  const Values weighted{.values = {0.3, 0.5, 0.4}, .weights = {1.0, 0.0, 3.0}};
  EXPECT_EQ(weighted.at(0.0), 0.3);
  EXPECT_EQ(weighted.at(0.2499), 0.3);
  EXPECT_EQ(weighted.at(0.2501), 0.4);
  EXPECT_EQ(weighted.at(1.0 - 0x1p-53), 0.4);
  EXPECT_DOUBLE_EQ(mean_of(weighted), 0.375);
  const Values even{.values = {2.0, 1.0}};
  EXPECT_EQ(even.at(0.4999), 2.0);
  EXPECT_EQ(even.at(0.5), 1.0);
  EXPECT_EQ(reach_of(even), (Reach{1.0, 2.0}));
  EXPECT_DOUBLE_EQ(mean_of(even), 1.5);
  EXPECT_DOUBLE_EQ(mean_of(divided(weighted, 2.0)), 0.1875);
}

TEST(RedrawnQuantities, KeepMeanAndStandardDeviationUnderEachLaw) {
  for (const FluctuationLaw law : {FluctuationLaw::normal, FluctuationLaw::lognormal, FluctuationLaw::uniform}) {
    const RedrawnQuantity friction = law_along_the_way(law, 0.4, 0.06);
    double sum = 0.0, squares = 0.0;
    constexpr double step = 1e-3;
    for (double z = -8.5; z <= 8.5; z += step) {
      const double weight = step * pdf(standard_law, z);
      const double value = value_at_normal(friction, z);
      sum += weight * value;
      squares += weight * (value - 0.4) * (value - 0.4);
    }
    EXPECT_NEAR(sum, 0.4, 1e-12) << static_cast<int>(law);
    EXPECT_NEAR(std::sqrt(squares), 0.06, 1e-12) << static_cast<int>(law);
    EXPECT_FALSE(is_drawn(law_along_the_way(law, 0.4, 0.0)));
  }
}

/// What is wrong with this law, asked of a condition made in C++.
std::string refusal_of(const Quantity& static_friction) {
  Condition condition;
  condition.scene.friction = Friction{.static_coefficient = static_friction, .kinetic_coefficient = 0.01};
  try {
    check_condition(condition);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Laws, AreRefusedWithPlaceAndReason) {
  EXPECT_EQ(refusal_of(Values{.values = {0.3, 0.4}}), "");
  EXPECT_THAT(refusal_of(Uniform{0.5, 0.4}), HasSubstr("/friction/static/uniform"));
  EXPECT_THAT(refusal_of(Uniform{0.5, -0.4}), HasSubstr("/friction/static/uniform/1"));
  EXPECT_THAT(refusal_of(Normal{.mean = 0.5, .sigma = -0.1}), HasSubstr("/friction/static/normal/sigma"));
  EXPECT_THAT(refusal_of(Normal{.mean = 0.5, .sigma = 0.1, .between = Reach{0.9, 0.8}}),
              HasSubstr("smaller end first"));
  EXPECT_THAT(refusal_of(Normal{.mean = 0.5, .sigma = 0.01, .between = Reach{0.9, 1.8}}), HasSubstr("no probability"));
  EXPECT_THAT(refusal_of(Lognormal{.mean = 0.0, .sigma = 0.1}), HasSubstr("positive mean"));
  EXPECT_THAT(refusal_of(Triangular{0.3, 0.2, 0.9}), HasSubstr("in this order"));
  EXPECT_THAT(refusal_of(Values{}), HasSubstr("/friction/static/values"));
  EXPECT_THAT(refusal_of(Values{.values = {0.3}, .weights = {1.0, 2.0}}), HasSubstr("2 weights"));
  EXPECT_THAT(refusal_of(Values{.values = {0.3}, .weights = {0.0}}), HasSubstr("no weight above 0"));
  EXPECT_THAT(refusal_of(Values{.values = {0.3, std::nan("")}}), HasSubstr("/friction/static/values/1"));
}

}  // namespace
}  // namespace rocking
