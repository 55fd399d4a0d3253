// Box-Muller with chosen words, so that every case is exact or has a known number of roundings.

#include "rocking/random/box_muller.hpp"

#include <cmath>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "rocking/random/uniform.hpp"

namespace {

using namespace rocking::random;
using Exact = boost::multiprecision::cpp_bin_float_50;

/// The block whose halves are these bits.
Words block_of(std::uint64_t first, std::uint64_t second) {
  const auto low = [](std::uint64_t bits) { return static_cast<std::uint32_t>(bits); };
  const auto high = [](std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32U); };
  return {low(first), high(first), low(second), high(second)};
}

constexpr std::uint64_t all_ones = ~std::uint64_t{0};
constexpr std::uint64_t eighth_of_a_turn = std::uint64_t{1} << 61U;

TEST(Uniform, ReachesTheEndsThatItsNameSays) {
  EXPECT_EQ(uniform_from_zero(0), 0.0);
  EXPECT_EQ(uniform_from_zero(all_ones), 1.0 - 0x1p-53);
  EXPECT_EQ(uniform_to_one(0), 0x1p-53);
  EXPECT_EQ(uniform_to_one(all_ones), 1.0);
  EXPECT_EQ(uniform_inside(0), 0x1p-53);
  EXPECT_EQ(uniform_inside(all_ones), 1.0 - 0x1p-53);
}

TEST(Uniform, InsideIsSymmetricAboutOneHalf) {
  for (std::uint64_t bits = 12345; bits < all_ones / 2; bits = 3 * bits + 1) {
    EXPECT_EQ(uniform_inside(bits), 1.0 - uniform_inside(~bits));
  }
}

TEST(BoxMuller, HasNoTailBeyondItsLimitAndReachesIt) {
  const NormalPair pair = box_muller(block_of(0, 0));
  EXPECT_EQ(pair.cosine, normal_tail_limit);
  EXPECT_EQ(pair.sine, 0.0);
  EXPECT_DOUBLE_EQ(normal_tail_limit, std::sqrt(106.0 * std::log(2.0)));
}

TEST(BoxMuller, IsFiniteWhereTheLogarithmVanishes) {
  const NormalPair pair = box_muller(block_of(all_ones, 5 * eighth_of_a_turn));
  EXPECT_EQ(pair.cosine, 0.0);
  EXPECT_EQ(pair.sine, 0.0);
}

TEST(BoxMuller, TurnsExactlyByQuartersAndEighths) {
  const double radius = normal_tail_limit;
  const auto at_eighth = [](std::uint64_t k) { return box_muller(block_of(0, k * eighth_of_a_turn)); };
  const double expected[8][2] = {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}};
  const double diagonal = radius * std::sqrt(0.5);
  for (std::uint64_t k = 0; k < 8; ++k) {
    const double length = k % 2 == 0 ? radius : diagonal;
    EXPECT_DOUBLE_EQ(at_eighth(k).cosine, length * expected[k][0]) << k;
    EXPECT_DOUBLE_EQ(at_eighth(k).sine, length * expected[k][1]) << k;
  }
}

TEST(BoxMuller, GivesTheCosineToEvenIndicesAndTheSineToOdd) {
  const NormalPair pair{1.0, 2.0};
  EXPECT_EQ(pair[0], 1.0);
  EXPECT_EQ(pair[7], 2.0);
  EXPECT_EQ(pair[all_ones - 1], 1.0);
}

// The next largest radii are sqrt(-2 ln(2 2^-53)) and so on: the tail becomes sparse and ends as (0, 1] implies.
TEST(BoxMuller, HasARadiusForEveryStepOfTheUniformNumber) {
  double before = normal_tail_limit;
  for (std::uint64_t k = 1; k < 100; ++k) {
    const double radius = box_muller(block_of(k << 11U, 0)).cosine;
    EXPECT_DOUBLE_EQ(radius, std::sqrt(-2.0 * std::log(static_cast<double>(k + 1) * 0x1p-53)));
    EXPECT_LT(radius, before);
    before = radius;
  }
}

// Roundings in units of 2^-53 of the result: logarithm 2, halved by the root; root 1; angle 1 and pi/2 itself 0.4, with
// a condition number of at most 1; sine or cosine 2; product 1: together 6.4.
TEST(BoxMuller, IsRightToItsRoundings) {
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const Words block = philox({i, 0, 0, 0}, 2012);
    const Exact u1 = Exact((half_of(block, 0) >> 11U) + 1) / (std::uint64_t{1} << 53U);
    const Exact u2 = Exact(half_of(block, 1) >> 11U) / (std::uint64_t{1} << 53U);
    const Exact radius = sqrt(-2 * log(u1));
    const Exact angle = 2 * boost::math::constants::pi<Exact>() * u2;
    const auto error = [](double found, const Exact& truth) { return static_cast<double>(abs(found / truth - 1)); };
    const NormalPair pair = box_muller(block);
    ASSERT_LE(error(pair.cosine, radius * cos(angle)), 6.4 * 0x1p-53) << i;
    ASSERT_LE(error(pair.sine, radius * sin(angle)), 6.4 * 0x1p-53) << i;
  }
}

}  // namespace
