// Binomial numbers: their ends, how many draws they take, and that they do not depend on what was drawn before.

#include "rocking/random/binomial.hpp"

#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

namespace {

using namespace rocking::random;

PhiloxEngine bits_from(std::uint64_t index) {
  PhiloxEngine bits(Draws(7, 0), Source::inference_counts);
  bits.seek(index);
  return bits;
}

TEST(Binomial, IsCertainWhereTheProbabilityIs) {
  PhiloxEngine bits = bits_from(0);
  for (const std::uint64_t trials : {0U, 1U, 50U, 1000000U}) {
    EXPECT_EQ(binomial(bits, trials, 0.0), 0U);
    EXPECT_EQ(binomial(bits, trials, 1.0), trials);
  }
}

TEST(Binomial, IsAtMostTheTrials) {
  PhiloxEngine bits = bits_from(0);
  for (const double probability : {1e-300, 1e-12, 0.3, 0.5, 0.9, 1.0 - 0x1p-53}) {
    for (std::uint64_t trials = 0; trials < 400; ++trials) EXPECT_LE(binomial(bits, trials, probability), trials);
  }
}

TEST(Binomial, OfFailuresIsTheRest) {
  for (std::uint64_t index = 0; index < 100; ++index) {
    PhiloxEngine one = bits_from(index);
    PhiloxEngine other = bits_from(index);
    EXPECT_EQ(binomial(one, 1000, 0.75), 1000 - binomial(other, 1000, 0.25));
  }
}

// A million trials take as many draws as fifty: the time does not grow.
TEST(Binomial, TakesAboutThreeDrawsHoweverManyTrials) {
  for (const std::uint64_t trials : {50ULL, 1000ULL, 1000000ULL, 1000000000ULL}) {
    PhiloxEngine bits = bits_from(0);
    for (int i = 0; i < 1000; ++i) static_cast<void>(binomial(bits, trials, 0.4));
    EXPECT_LE(bits.index(), 3200U) << trials;
  }
}

// The smallest k with P(K <= k) > u, where u is the uniform number of the draw.
TEST(Binomial, IsTheInverseOfTheDistributionWhereFewSuccessesAreExpected) {
  constexpr std::uint64_t trials = 30;
  constexpr double probability = 0.1;
  for (std::uint64_t index = 0; index < 200; ++index) {
    PhiloxEngine bits = bits_from(index);
    const double u = Draws(7, 0).uniform(Source::inference_counts, index);
    double share = std::pow(0.9, 30);
    double sum = share;
    std::uint64_t k = 0;
    for (; sum <= u; ++k) {
      share *= static_cast<double>(trials - k) / static_cast<double>(k + 1) / 9.0;
      sum += share;
    }
    EXPECT_EQ(binomial(bits, trials, probability), k);
  }
}

}  // namespace
