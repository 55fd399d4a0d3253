// Where a polynomial loses its sign: exact cases, and a million polynomials against a dense evaluation.

#include "rocking/integrate/sign_loss.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

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

/// What rounding can do to a value on [0, 1]. Each of the n additions and multiplications of an evaluation, the n of the
/// change of basis and the n of each of up to 52 halvings loses at most one unit of sum |c|; most evaluations lose far less.
double slack(std::span<const double> c) {
  return (4.0 + 52.0) * static_cast<double>(c.size()) * unit_rounding * sum_of_sizes(c);
}

TEST(SignLoss, IsFoundAtASimpleRoot) {
  EXPECT_EQ(first_sign_loss(from_roots(-1.0, {0.25})), 0.25);
  EXPECT_EQ(first_sign_loss(from_roots(1.0, {0.25, 0.75})), 0.25);
  EXPECT_EQ(first_sign_loss(from_roots(1.0, {0.5, 2.0, -3.0})), 0.5);
  EXPECT_EQ(first_sign_loss(from_roots(1.0, {-0.5, 2.0, 3.0})), std::nullopt) << "no root in [0, 1]";
}

TEST(SignLoss, AtTheEndOfTheStepIsNoneYet) {
  EXPECT_EQ(first_sign_loss(from_roots(-1.0, {1.0})), std::nullopt) << "p >= 0 on all of [0, 1]";
  const auto just_inside = first_sign_loss(from_roots(-1.0, {1.0 - 0x1p-40}));
  ASSERT_TRUE(just_inside);
  EXPECT_EQ(*just_inside, 1.0 - 0x1p-40);
}

TEST(SignLoss, IsAtTheStartIfItStartsBelowOrLeavesDownwards) {
  EXPECT_EQ(first_sign_loss(Polynomial{-1.0}), 0.0);
  EXPECT_EQ(first_sign_loss(Polynomial{-0x1p-1060, 1.0}), 0.0);
  EXPECT_EQ(first_sign_loss(Polynomial{0.0, -1.0}), 0.0);
  EXPECT_EQ(first_sign_loss(Polynomial{0.0, 0.0, -1.0, 100.0}), 0.0);
  EXPECT_EQ(first_sign_loss(Polynomial{0.0, 0.0, 1.0, 100.0}), std::nullopt);
  EXPECT_EQ(first_sign_loss(Polynomial{0.0, 0.0, 0.0}), std::nullopt) << "zero throughout is not below zero";
}

// Of a quadratic, whose Bernstein coefficients are exact; of a higher degree rounding may make two roots of a touch.
TEST(SignLoss, IsNotATouch) {
  EXPECT_EQ(first_sign_loss(from_roots(1.0, {0.5, 0.5})), std::nullopt);
  EXPECT_EQ(first_sign_loss(from_roots(1.0, {0.0, 0.0})), std::nullopt);
  EXPECT_EQ(first_sign_loss(from_roots(1.0, {1.0, 1.0})), std::nullopt);
}

TEST(SignLoss, IsFoundBehindATouch) {
  const auto loss = first_sign_loss(from_roots(-1.0, {0.25, 0.25, 0.75}));
  ASSERT_TRUE(loss);
  EXPECT_NEAR(*loss, 0.75, 1e-15);
}

TEST(SignLoss, IsFoundBehindAStartAtZeroThatLeavesUpwards) {
  const auto loss = first_sign_loss(from_roots(-1.0, {0.0, 0.375}));
  ASSERT_TRUE(loss);
  EXPECT_EQ(*loss, 0.375);
}

// p = t q(t) with q's Bernstein coefficients 1, -3, -1, -1: Newton's step from 1/2 leads to the root at 0 exactly, which is
// no loss of sign (p rises there).
TEST(SignLoss, IsNotTheZeroAtTheStartThatNewtonsStepLeadsTo) {
  const Polynomial p = product({0.0, 1.0}, {1.0, -12.0, 18.0, -8.0});
  const auto loss = first_sign_loss(p);
  ASSERT_TRUE(loss);
  EXPECT_GT(*loss, 0.05);
  EXPECT_NEAR(evaluate(std::span<const double>(p), *loss), 0.0, slack(p));
}

TEST(SignLoss, IsFoundAtATripleRoot) {
  for (const double root : {0.25, 0.5, 0.8125}) {  // dyadic: the coefficients are exact
    const auto loss = first_sign_loss(from_roots(-1.0, {root, root, root}));
    ASSERT_TRUE(loss) << root;
    // Values within rounding u of zero fill abs(t - root) < u^(1/3) = 5e-6.
    EXPECT_NEAR(*loss, root, 2e-5) << root;
  }
}

// (t - 1/2)^2 - d^2 with d a power of two, times (1 + t)^3: exact coefficients. A loss at 1/2 - d; with + d^2, none.
TEST(SignLoss, TellsNearRootsFromANearMiss) {
  for (int k = 2; k <= 23; ++k) {
    const double d = std::ldexp(1.0, -k);
    const Polynomial wide = from_roots(1.0, {-1.0, -1.0, -1.0});
    const auto crossing = first_sign_loss(product({0.25 - d * d, -1.0, 1.0}, wide));
    ASSERT_TRUE(crossing) << "d = 2^-" << k;
    EXPECT_NEAR(*crossing, 0.5 - d, 32.0 * unit_rounding / d) << "d = 2^-" << k;
    EXPECT_EQ(first_sign_loss(product({0.25 + d * d, -1.0, 1.0}, wide)), std::nullopt) << "d = 2^-" << k;
  }
}

// The same about a = 2^-20, where doubles are dense: distances down to 2^-42 = 2e-13.
TEST(SignLoss, TellsRootsAtTheClosestDistances) {
  const double a = 0x1p-20;
  for (int k = 21; k <= 42; ++k) {
    const double d = std::ldexp(1.0, -k);
    const auto crossing = first_sign_loss(Polynomial{a * a - d * d, -2.0 * a, 1.0});
    ASSERT_TRUE(crossing) << "d = 2^-" << k;
    EXPECT_NEAR(*crossing, a - d, 8.0 * unit_rounding * a * a / d) << "d = 2^-" << k;
    EXPECT_EQ(first_sign_loss(Polynomial{a * a + d * d, -2.0 * a, 1.0}), std::nullopt) << "d = 2^-" << k;
  }
}

/// Lowest value at 65 points of [0, end].
double lowest(std::span<const double> c, double end) {
  double low = c[0];
  for (int i = 1; i <= 64; ++i) low = std::min(low, evaluate(c, end * i / 64.0));
  return low;
}

/// How many of a million random polynomials break each claim.
struct Offences {
  int missed = 0;         ///< below zero before the reported loss, or without one
  int not_a_root = 0;     ///< the reported instant is no root
  int gains_instead = 0;  ///< it is a root at which the polynomial clearly rises
};

Offences judge(const Polynomial& p) {
  Offences found;
  const double tolerance = slack(p);
  const auto loss = first_sign_loss(p);
  if (lowest(p, loss.value_or(1.0)) < -tolerance && loss != 0.0) ++found.missed;
  if (!loss || (*loss == 0.0 && p[0] < 0.0)) return found;
  if (std::abs(evaluate(std::span<const double>(p), *loss)) > tolerance) ++found.not_a_root;
  const double slope = jet_at(p, *loss).first;
  if (slope > 0.0 && evaluate(std::span<const double>(p), std::min(1.0, *loss + 1e-3)) > tolerance &&
      slope * 1e-3 > 1e3 * tolerance) {
    ++found.gains_instead;
  }
  return found;
}

TEST(SignLoss, IsNeverMissedAndNeverMadeUpInAMillionPolynomials) {
  Offences total;
  support::SplitMix draw(2012);
  for (int i = 0; i < 1'000'000; ++i) {
    const Polynomial p = random_polynomial(draw);
    const Offences found = judge(p);
    total.missed += found.missed;
    total.not_a_root += found.not_a_root;
    total.gains_instead += found.gains_instead;
    if (found.missed + found.not_a_root + found.gains_instead > 0 && i < 100'000) {
      ADD_FAILURE() << "polynomial " << i << " of seed 2012: " << testing::PrintToString(p) << ", loss "
                    << testing::PrintToString(first_sign_loss(p));
    }
  }
  EXPECT_EQ(total.missed, 0);
  EXPECT_EQ(total.not_a_root, 0);
  EXPECT_EQ(total.gains_instead, 0);
}

// Far from the root the lower derivatives know nothing of a high power, and would take a straight line for the polynomial.
TEST(SignLoss, IsFoundWhereOneHighPowerMakesIt) {
  for (std::size_t power = 4; power <= 16; ++power) {
    for (const double slope : {0.0, 1e-6, 1e-3, 0.3, 0.99}) {
      for (int exponent = -3; exponent <= 60; ++exponent) {
        Polynomial p(power + 1, 0.0);
        p[0] = 1.0;
        p[1] = -slope;
        p[power] = -std::exp2(exponent);
        const auto loss = first_sign_loss(p);
        if (!loss) continue;
        EXPECT_LE(std::abs(evaluate(std::span<const double>(p), *loss)), 1e-14 * static_cast<double>(power))
            << "1 - " << slope << " t - 2^" << exponent << " t^" << power << " at " << *loss;
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
