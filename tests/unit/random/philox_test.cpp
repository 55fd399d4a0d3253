#include "rocking/random/philox.hpp"

#include <bit>

#include <gtest/gtest.h>

namespace {

using rocking::random::half_of;
using rocking::random::philox;
using rocking::random::Words;

// The outputs that Random123 publishes for philox4x32 with ten rounds (its file kat_vectors).
TEST(Philox, GivesThePublishedAnswers) {
  EXPECT_EQ(philox({0, 0, 0, 0}, 0), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, 0xffffffffffffffff),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0a4093822),  // digits of pi
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, ChangesAboutHalfOfAllBitsWhenOneIsFlipped) {
  const Words counter{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344};
  const Words before = philox(counter, 7);
  for (std::size_t bit = 0; bit < 128; ++bit) {
    Words flipped = counter;
    flipped[bit / 32] ^= std::uint32_t{1} << (bit % 32);
    const Words after = philox(flipped, 7);
    int changed = 0;
    for (std::size_t i = 0; i < 4; ++i) changed += std::popcount(before[i] ^ after[i]);
    // Binomial(128, 1/2): outside 26 ... 102 with probability 1e-11 per flip.
    EXPECT_GE(changed, 26) << bit;
    EXPECT_LE(changed, 102) << bit;
  }
}

TEST(Philox, HalvesTakeTheFirstWordAsTheLowOne) {
  EXPECT_EQ(half_of({1, 2, 3, 4}, 0), 0x0000000200000001U);
  EXPECT_EQ(half_of({1, 2, 3, 4}, 1), 0x0000000400000003U);
}

}  // namespace
