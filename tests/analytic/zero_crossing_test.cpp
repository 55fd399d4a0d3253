// Zero crossings of a polynomial: exact cases, and a million polynomials compared with a dense evaluation.

#include "rocking/integrate/zero_crossing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <gtest/gtest.h>

#include "rocking/integrate/polynomial.hpp"
#include "support/random_polynomial.hpp"
#include "support/split_mix.hpp"

namespace rocking::integrate {
namespace {

using support::from_roots;
using support::Polynomial;
using support::product;
using support::random_polynomial;

constexpr double unit_rounding = 0x1p-53;

double sum_of_sizes(std::span<const double> c) {
  double sum = 0.0;
  for (const double value : c) sum += std::abs(value);
  return sum;
}

/// Bound of the rounding error of a value on [0, 1]. Each of the n additions and multiplications of an evaluation, the
/// n of the change of basis and the n of each of up to 52 bisections has an error of at most one unit of sum |c|; most
/// evaluations have a much smaller one.
double slack(std::span<const double> c) {
  return (4.0 + 52.0) * static_cast<double>(c.size()) * unit_rounding * sum_of_sizes(c);
}

TEST(ZeroCrossing, IsFoundAtASimpleRoot) {
  EXPECT_EQ(first_zero_crossing(from_roots(-1.0, {0.25})), 0.25);
  EXPECT_EQ(first_zero_crossing(from_roots(1.0, {0.25, 0.75})), 0.25);
  EXPECT_EQ(first_zero_crossing(from_roots(1.0, {0.5, 2.0, -3.0})), 0.5);
  EXPECT_EQ(first_zero_crossing(from_roots(1.0, {-0.5, 2.0, 3.0})), std::nullopt) << "no root in [0, 1]";
}

TEST(ZeroCrossing, AtTheEndOfTheStepIsNoneYet) {
  EXPECT_EQ(first_zero_crossing(from_roots(-1.0, {1.0})), std::nullopt) << "p >= 0 on all of [0, 1]";
  const auto just_inside = first_zero_crossing(from_roots(-1.0, {1.0 - 0x1p-40}));
  ASSERT_TRUE(just_inside);
  EXPECT_EQ(*just_inside, 1.0 - 0x1p-40);
}

TEST(ZeroCrossing, IsAtTheStartIfItStartsBelowOrLeavesDownwards) {
  EXPECT_EQ(first_zero_crossing(Polynomial{-1.0}), 0.0);
  EXPECT_EQ(first_zero_crossing(Polynomial{-0x1p-1060, 1.0}), 0.0);
  EXPECT_EQ(first_zero_crossing(Polynomial{0.0, -1.0}), 0.0);
  EXPECT_EQ(first_zero_crossing(Polynomial{0.0, 0.0, -1.0, 100.0}), 0.0);
  EXPECT_EQ(first_zero_crossing(Polynomial{0.0, 0.0, 1.0, 100.0}), std::nullopt);
  EXPECT_EQ(first_zero_crossing(Polynomial{0.0, 0.0, 0.0}), std::nullopt) << "zero throughout is not below zero";
}

// The Bernstein coefficients of a quadratic are exact; for a higher degree, rounding may split a double root into two.
TEST(ZeroCrossing, IsNotATouch) {
  EXPECT_EQ(first_zero_crossing(from_roots(1.0, {0.5, 0.5})), std::nullopt);
  EXPECT_EQ(first_zero_crossing(from_roots(1.0, {0.0, 0.0})), std::nullopt);
  EXPECT_EQ(first_zero_crossing(from_roots(1.0, {1.0, 1.0})), std::nullopt);
}

TEST(ZeroCrossing, IsFoundBehindATouch) {
  const auto crossing = first_zero_crossing(from_roots(-1.0, {0.25, 0.25, 0.75}));
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(*crossing, 0.75, 1e-15);
}

TEST(ZeroCrossing, IsFoundBehindAStartAtZeroThatLeavesUpwards) {
  const auto crossing = first_zero_crossing(from_roots(-1.0, {0.0, 0.375}));
  ASSERT_TRUE(crossing);
  EXPECT_EQ(*crossing, 0.375);
}

// p = t q(t), where q has the Bernstein coefficients 1, -3, -1, -1: Newton's step from 1/2 leads exactly to the root at
// 0, which is no zero crossing (p rises there).
TEST(ZeroCrossing, IsNotTheZeroAtTheStartThatNewtonsStepLeadsTo) {
  const Polynomial p = product({0.0, 1.0}, {1.0, -12.0, 18.0, -8.0});
  const auto crossing = first_zero_crossing(p);
  ASSERT_TRUE(crossing);
  EXPECT_GT(*crossing, 0.05);
  EXPECT_NEAR(evaluate(std::span<const double>(p), *crossing), 0.0, slack(p));
}

TEST(ZeroCrossing, IsFoundAtATripleRoot) {
  for (const double root : {0.25, 0.5, 0.8125}) {  // dyadic: the coefficients are exact
    const auto crossing = first_zero_crossing(from_roots(-1.0, {root, root, root}));
    ASSERT_TRUE(crossing) << root;
    // Values within a rounding u of zero fill abs(t - root) < u^(1/3) = 5e-6.
    EXPECT_NEAR(*crossing, root, 2e-5) << root;
  }
}

// (t - 1/2)^2 - d^2 with d a power of two, times (1 + t)^3: exact coefficients. A zero crossing at 1/2 - d; with + d^2
// there is none.
TEST(ZeroCrossing, TellsNearRootsFromANearMiss) {
  for (int k = 2; k <= 23; ++k) {
    const double d = std::ldexp(1.0, -k);
    const Polynomial wide = from_roots(1.0, {-1.0, -1.0, -1.0});
    const auto crossing = first_zero_crossing(product({0.25 - d * d, -1.0, 1.0}, wide));
    ASSERT_TRUE(crossing) << "d = 2^-" << k;
    EXPECT_NEAR(*crossing, 0.5 - d, 32.0 * unit_rounding / d) << "d = 2^-" << k;
    EXPECT_EQ(first_zero_crossing(product({0.25 + d * d, -1.0, 1.0}, wide)), std::nullopt) << "d = 2^-" << k;
  }
}

// The same near a = 2^-20, where doubles are dense: distances down to 2^-42 = 2e-13.
TEST(ZeroCrossing, TellsRootsAtTheClosestDistances) {
  const double a = 0x1p-20;
  for (int k = 21; k <= 42; ++k) {
    const double d = std::ldexp(1.0, -k);
    const auto crossing = first_zero_crossing(Polynomial{a * a - d * d, -2.0 * a, 1.0});
    ASSERT_TRUE(crossing) << "d = 2^-" << k;
    EXPECT_NEAR(*crossing, a - d, 8.0 * unit_rounding * a * a / d) << "d = 2^-" << k;
    EXPECT_EQ(first_zero_crossing(Polynomial{a * a + d * d, -2.0 * a, 1.0}), std::nullopt) << "d = 2^-" << k;
  }
}

/// Smallest value at 65 points of [0, end].
double lowest(std::span<const double> c, double end) {
  double low = c[0];
  for (int i = 1; i <= 64; ++i) low = std::min(low, evaluate(c, end * i / 64.0));
  return low;
}

/// Number of a million random polynomials that violate each claim.
struct Offences {
  int missed = 0;         ///< below zero before the reported crossing, or without one
  int not_a_root = 0;     ///< the reported instant is no root
  int gains_instead = 0;  ///< the reported instant is a root, but the polynomial clearly rises there
};

Offences judge(const Polynomial& p) {
  Offences found;
  const double tolerance = slack(p);
  const auto crossing = first_zero_crossing(p);
  if (lowest(p, crossing.value_or(1.0)) < -tolerance && crossing != 0.0) ++found.missed;
  if (!crossing || (*crossing == 0.0 && p[0] < 0.0)) return found;
  if (std::abs(evaluate(std::span<const double>(p), *crossing)) > tolerance) ++found.not_a_root;
  const double slope = jet_at(p, *crossing).first;
  if (slope > 0.0 && evaluate(std::span<const double>(p), std::min(1.0, *crossing + 1e-3)) > tolerance &&
      slope * 1e-3 > 1e3 * tolerance) {
    ++found.gains_instead;
  }
  return found;
}

TEST(ZeroCrossing, IsNeverMissedAndNeverMadeUpInAMillionPolynomials) {
  Offences total;
  support::SplitMix draw(2012);
  for (int i = 0; i < 1'000'000; ++i) {
    const Polynomial p = random_polynomial(draw);
    const Offences found = judge(p);
    total.missed += found.missed;
    total.not_a_root += found.not_a_root;
    total.gains_instead += found.gains_instead;
    if (found.missed + found.not_a_root + found.gains_instead > 0 && i < 100'000) {
      ADD_FAILURE() << "polynomial " << i << " of seed 2012: " << testing::PrintToString(p) << ", crossing "
                    << testing::PrintToString(first_zero_crossing(p));
    }
  }
  EXPECT_EQ(total.missed, 0);
  EXPECT_EQ(total.not_a_root, 0);
  EXPECT_EQ(total.gains_instead, 0);
}

// Far from the root the lower derivatives contain no information on a high power, and would suggest a straight line.
TEST(ZeroCrossing, IsFoundWhereOneHighPowerMakesIt) {
  for (std::size_t power = 4; power <= 16; ++power) {
    for (const double slope : {0.0, 1e-6, 1e-3, 0.3, 0.99}) {
      for (int exponent = -3; exponent <= 60; ++exponent) {
        Polynomial p(power + 1, 0.0);
        p[0] = 1.0;
        p[1] = -slope;
        p[power] = -std::exp2(exponent);
        const auto crossing = first_zero_crossing(p);
        if (!crossing) continue;
        EXPECT_LE(std::abs(evaluate(std::span<const double>(p), *crossing)), 1e-14 * static_cast<double>(power))
            << "1 - " << slope << " t - 2^" << exponent << " t^" << power << " at " << *crossing;
      }
    }
  }
}

TEST(CheapBound, NeverClaimsTooMuch) {
  support::SplitMix draw(2013);
  int claims = 0;
  for (int i = 0; i < 300'000; ++i) {
    Polynomial p = random_polynomial(draw);
    p[0] = std::abs(p[0]) + std::exp2(draw.uniform(-20.0, 3.0));
    const double length = std::exp2(draw.uniform(-6.0, 1.0));
    if (!is_clearly_positive(p, length)) continue;
    ++claims;
    std::array<double, max_coefficients> storage;
    const auto scaled = scale_to_unit(p, length, storage);
    ASSERT_GT(lowest(scaled, 1.0), -slack(scaled)) << "polynomial " << i << ", length " << length;
  }
  EXPECT_GT(claims, 30'000) << "the bound has to be of some use";
}

TEST(CheapBound, IsExactForALine) {
  EXPECT_TRUE(is_clearly_positive(Polynomial{1.0, -1.0}, 1.0 - 0x1p-53));
  EXPECT_FALSE(is_clearly_positive(Polynomial{1.0, -1.0}, 1.0)) << "zero at the end is not shown to be positive";
  EXPECT_FALSE(is_clearly_positive(Polynomial{0.0, 1.0}, 1.0)) << "zero at the start neither";
}

}  // namespace
}  // namespace rocking::integrate
