#include "lib/live/engine/fused.hpp"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/split_mix.hpp"

namespace rocking::live {
namespace {

/// Whether two results have the same bits; of what is not a number the bits are left open.
bool are_same(double a, double b) { return (std::isnan(a) && std::isnan(b)) || base::bits_of(a) == base::bits_of(b); }

void expect_fused(double a, double b, double c) {
  const double expected = std::fma(a, b, c);
  const double found = fused_in_software(a, b, c, [](double x, double y, double z) { return std::fma(x, y, z); });
  EXPECT_TRUE(are_same(found, expected)) << a << ' ' << b << ' ' << c << ": " << found << ", not " << expected;
}

TEST(FusedInSoftware, HasTheBitsOfTheProcessorForNumbersOfAnySize) {
  support::SplitMix random(0x90);
  for (int i = 0; i < 1'000'000; ++i) {
    expect_fused(base::number_of(random.bits()), base::number_of(random.bits()), base::number_of(random.bits()));
  }
}

/// The product and the third number nearly cancel, or differ by so much that one of them is hardly felt.
TEST(FusedInSoftware, HasThemWhereDigitsCancelOrAreHardlyFelt) {
  support::SplitMix random(0x91);
  const auto number = [&random](int exponents) {
    const double mantissa = 1.0 + static_cast<double>(random.bits() >> 12U) * 0x1p-52;
    const int exponent = static_cast<int>(random.bits() % static_cast<unsigned>(2 * exponents + 1)) - exponents;
    return std::ldexp(random.bits() % 2 == 0 ? mantissa : -mantissa, exponent);
  };
  for (int i = 0; i < 1'000'000; ++i) {
    const double a = number(40), b = number(40);
    expect_fused(a, b, number(120));
    expect_fused(a, b, -(a * b));
    expect_fused(a, b, -(a * b) * (1.0 + std::ldexp(number(0), -static_cast<int>(random.bits() % 55))));
    // Few digits: ties are frequent.
    const double few = std::ldexp(std::round(std::ldexp(number(0), 20)), -20);
    expect_fused(few, std::ldexp(std::round(std::ldexp(b, 8)), -8), std::ldexp(number(0) < 0.0 ? 1.0 : -3.0, 50));
  }
}

/// The exact sum is next to the middle between two numbers: a second rounding of the rest would put it there.
TEST(FusedInSoftware, HasThemNextToTies) {
  for (int k = 1; k < 100; ++k) {
    for (int j = 0; j < 8; ++j) {
      for (const double sign : {1.0, -1.0}) {
        const double more = 1.0 + k * 0x1p-52, less = 1.0 - k * 0x1p-52;
        expect_fused(more, less, sign * (0x1p53 + 2.0 * j));
        expect_fused(sign * more, more, 0x1p53 + 2.0 * j);
        expect_fused(0x1p-300 * more, less, sign * 0x1p-300 * (0x1p53 + 2.0 * j));
      }
    }
  }
}

TEST(FusedInSoftware, HasThemAtTheEdgesOfItsRange) {
  using Limits = std::numeric_limits<double>;
  const std::array numbers{0.0,
                           -0.0,
                           1.0,
                           -1.0,
                           Limits::denorm_min(),
                           Limits::min(),
                           Limits::max(),
                           Limits::infinity(),
                           -Limits::infinity(),
                           Limits::quiet_NaN(),
                           0x1p-900,
                           0x1.fp-901,
                           0x1p900,
                           0x1.fffffffffffffp900,
                           0x1p901,
                           0x1p-450,
                           0x1.8p-451,
                           0x1p450,
                           0x1.8p451,
                           0x1.0000000000001p-1022,
                           3.0,
                           0x1p53};
  for (const double a : numbers) {
    for (const double b : numbers) {
      for (const double c : numbers) expect_fused(a, b, c);
    }
  }
}

}  // namespace
}  // namespace rocking::live
