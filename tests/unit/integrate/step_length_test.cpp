// Length of a step from the last two terms of its series.

#include "rocking/integrate/step_length.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/split_mix.hpp"

namespace rocking::integrate {
namespace {

/// Largest error of using the bits of a double as its binary logarithm: max of log2(1 + f) - f.
constexpr double bits_error = 0.08608;

// Read as a logarithm the bits are too small by up to 0.0861, for numerator and denominator alike (divided by the
// degree). Read as an exponential they are too large by up to as much.
TEST(RoughRoot, IsWithinItsBoundsOverTheWholeRangeOfDoubles) {
  support::SplitMix draw(1);
  for (int i = 0; i < 1'000'000; ++i) {
    const int degree = 2 + draw.below(19);
    const auto number = [&draw] { return std::ldexp(draw.uniform(1.0, 2.0), draw.below(2046) - 1022); };
    const double a = number();
    const double b = draw.below(2) == 0 ? number() : -number();
    const double error = std::log2(rough_root(a, b, degree)) - (std::log2(a) - std::log2(std::abs(b))) / degree;
    ASSERT_LE(error, bits_error + bits_error / degree + 1e-6) << a << " over " << b << ", degree " << degree;
    ASSERT_GE(error, -bits_error / degree - 1e-6) << a << " over " << b << ", degree " << degree;
  }
}

TEST(RoughRoot, IsExactAtPowersOfItsDegree) {
  for (int exponent = -60; exponent <= 60; ++exponent) {
    EXPECT_EQ(rough_root(std::ldexp(1.0, 7 * exponent), std::ldexp(-1.0, -7 * exponent), 14),
              std::ldexp(1.0, exponent));
  }
}

TEST(RoughRoot, NeverFallsAsItsArgumentGrows) {
  double last = 0.0;
  for (int i = -30000; i <= 30000; ++i) {
    const double root = rough_root(std::exp2(i / 31.0), 1.0, 13);
    EXPECT_GE(root, last);
    last = root;
  }
}

/// Larger of the last two terms at length h, over the largest one allowed.
double larger_term(double last_but_one, double last, int order, double largest, double h) {
  return std::fmax(std::abs(last_but_one) * std::pow(h, order - 1), std::abs(last) * std::pow(h, order)) / largest;
}

TEST(StepLength, BringsTheLargerLastTermToTheLargestAllowed) {
  support::SplitMix draw(2);
  for (int i = 0; i < 100'000; ++i) {
    const int order = 2 + draw.below(14);
    const double a = std::exp2(draw.uniform(-40.0, 60.0)) * (draw.below(2) == 0 ? 1.0 : -1.0);
    const double b = std::exp2(draw.uniform(-40.0, 60.0)) * (draw.below(2) == 0 ? 1.0 : -1.0);
    const double largest = std::exp2(draw.uniform(-55.0, -20.0));
    const double h = step_length(a, b, order, largest);
    const double logarithm = std::log2(larger_term(a, b, order, largest, h));
    ASSERT_LE(logarithm, bits_error * (order + 1) + 1e-5) << a << " " << b << " " << order << " " << largest;
    ASSERT_GE(logarithm, -bits_error - 1e-5) << a << " " << b << " " << order << " " << largest;
  }
}

// Near a zero of a sine every second coefficient is nearly zero: the other one of the last two determines the length.
TEST(StepLength, SeesASineAboutItsZero) {
  const double frequency = 10.0;
  for (const int order : {9, 14}) {
    const auto coefficient = [&](int k) { return k % 2 == 0 ? 0.0 : std::pow(frequency, k) / std::tgamma(k + 1.0); };
    const double h = step_length(coefficient(order - 1), coefficient(order), order, 1e-13);
    ASSERT_TRUE(std::isfinite(h));
    const double term = larger_term(coefficient(order - 1), coefficient(order), order, 1e-13, h);
    EXPECT_LT(term, std::exp2(bits_error * (order + 1)));
    EXPECT_GT(term, std::exp2(-bits_error));
  }
}

TEST(StepLength, IsBeyondAllUseWhereBothTermsVanish) {
  EXPECT_GT(step_length(0.0, 0.0, 14, 1e-13), 0x1p60);
  EXPECT_GT(step_length(1e-320, 0.0, 14, 1e-13), 0x1p60) << "a term that no length of use brings to 1e-13";
  EXPECT_LT(step_length(1.0, 0.0, 14, 1e-13), 1.0);
  EXPECT_LT(step_length(0.0, 1.0, 14, 1e-13), 1.0);
}

TEST(StepLength, ShrinksByTheRootOfTheTolerance) {
  const double coarse = step_length(1.0, 1.0, 14, 1e-6);
  const double fine = step_length(1.0, 1.0, 14, 1e-13);
  EXPECT_NEAR(std::log2(coarse / fine), std::log2(1e7) / 13.0, 2.0 * bits_error);
}

}  // namespace
}  // namespace rocking::integrate
