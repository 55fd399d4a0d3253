#include "rocking/random/box_muller.hpp"

#include <bit>
#include <cmath>

#include "rocking/base/elementary.hpp"
#include "rocking/random/uniform.hpp"

namespace rocking::random {
namespace {

// One block at a time and many at once share these two, so that they cannot differ in a bit. They have no branch, no
// call and no conversion that a vector unit lacks, once they stand in the loop that uses them.

[[gnu::always_inline]] inline double radius_of(std::uint64_t bits) {
  return std::sqrt(-2.0 * base::natural_logarithm(uniform_to_one(bits)));
}

/// cos and sin of 2 pi k 2^-53, k the upper 53 bits.
[[gnu::always_inline]] inline base::SinCos<double> sin_cos_of_turn(std::uint64_t bits) {
  constexpr double half_pi = 0x1.921fb54442d18p+0;
  constexpr unsigned quarter_bits = 51;
  const std::uint64_t k = bits >> 11U;
  const std::uint64_t quadrant = (k + (std::uint64_t{1} << (quarter_bits - 1))) >> quarter_bits;  // nearest, 0 ... 4
  const std::uint64_t rest = k - (quadrant << quarter_bits);  // -2^50 ... 2^50, modulo 2^64
  const double signed_rest = std::bit_cast<double>(0x4338000000000000ULL + rest) - 0x1.8p52;  // exact
  const auto [sine, cosine] = base::reduced_sin_cos(signed_rest * 0x1p-51 * half_pi);
  // A quarter turn swaps the two, half a turn changes a sign.
  const auto sine_bits = std::bit_cast<std::uint64_t>(sine);
  const auto cosine_bits = std::bit_cast<std::uint64_t>(cosine);
  const std::uint64_t swap = (sine_bits ^ cosine_bits) & (0 - (quadrant & 1U));
  const auto sign = [](std::uint64_t quarters) { return (quarters & 2U) << 62U; };
  return {std::bit_cast<double>(sine_bits ^ swap ^ sign(quadrant)),
          std::bit_cast<double>(cosine_bits ^ swap ^ sign(quadrant + 1))};
}

}  // namespace

NormalPair box_muller(const Words& block) {
  const double radius = radius_of(half_of(block, 0));
  const auto [sine, cosine] = sin_cos_of_turn(half_of(block, 1));
  return {radius * cosine, radius * sine};
}

NormalBatch box_muller(const BlockBatch& blocks) {
  // Two loops: in one the numbers at work would not fit into the registers.
  std::array<double, BlockBatch::size> radius;
  for (std::size_t i = 0; i < BlockBatch::size; ++i) radius[i] = radius_of(blocks.half_0[i]);
  NormalBatch normals;
  for (std::size_t i = 0; i < BlockBatch::size; ++i) {
    const auto [sine, cosine] = sin_cos_of_turn(blocks.half_1[i]);
    normals[2 * i] = radius[i] * cosine;
    normals[2 * i + 1] = radius[i] * sine;
  }
  return normals;
}

}  // namespace rocking::random
