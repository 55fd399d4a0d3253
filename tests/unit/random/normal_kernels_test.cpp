// Every kernel that this machine can run gives the bits of one block at a time.

#include "rocking/random/normal_kernels.hpp"

#include <bit>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/random/box_muller.hpp"
#include "rocking/random/draws.hpp"

namespace {

using namespace rocking::random;
using ::testing::Each;

constexpr std::uint64_t every_bit = ~std::uint64_t{0};

Words words_of(std::uint64_t first, std::uint64_t second) {
  const auto low = [](std::uint64_t bits) { return static_cast<std::uint32_t>(bits); };
  const auto high = [](std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32U); };
  return {low(first), high(first), low(second), high(second)};
}

std::vector<std::uint64_t> bits_of(std::span<const double> numbers) {
  std::vector<std::uint64_t> bits;
  for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

/// Bits of the pairs, computed one block at a time.
std::vector<std::uint64_t> normal_bits_one_by_one(const BlockBatch& batch) {
  std::vector<double> normals;
  for (std::size_t i = 0; i < batch.size; ++i) {
    const NormalPair pair = box_muller(words_of(batch.half_0[i], batch.half_1[i]));
    normals.insert(normals.end(), {pair.cosine, pair.sine});
  }
  return bits_of(normals);
}

// Also where the counter carries into word 1, and where it starts again after 2^64 blocks.
TEST(NormalKernels, MakeTheBlocksOfOneByOne) {
  constexpr std::uint64_t untouched = 0x0123456789abcdef;
  const std::uint64_t upper = 0x03fedcba98765432;
  for (const NormalKernels& kernels : available_normal_kernels()) {
    for (const std::uint64_t first :
         std::initializer_list<std::uint64_t>{0, 7, 0xfffffff5, 0xfffffffc, 0x123456789abcdef0, every_bit - 6}) {
      for (const std::uint64_t key : {std::uint64_t{0}, std::uint64_t{0xfedcba9876543210}, every_bit}) {
        for (BlockBatch batch; batch.size > 0; batch.size -= BlockBatch::step) {
          batch.half_0.fill(untouched);
          batch.half_1.fill(untouched);
          kernels.make_blocks(words_of(first, upper), key, batch);
          for (std::size_t i = 0; i < batch.size; ++i) {
            const Words block = philox(words_of(first + i, upper), key);
            ASSERT_EQ(batch.half_0[i], half_of(block, 0)) << kernels.name << std::hex << ", " << first << " + " << i;
            ASSERT_EQ(batch.half_1[i], half_of(block, 1)) << kernels.name << std::hex << ", " << first << " + " << i;
          }
          EXPECT_THAT(std::span(batch.half_0).subspan(batch.size), Each(untouched)) << kernels.name;
          EXPECT_THAT(std::span(batch.half_1).subspan(batch.size), Each(untouched)) << kernels.name;
        }
      }
    }
  }
}

TEST(NormalKernels, MakeTheNormalsOfOneByOne) {
  for (const NormalKernels& kernels : available_normal_kernels()) {
    for (std::uint32_t round = 0; round < 500; ++round) {
      BlockBatch batch{.size = BlockBatch::step * (1 + round % 4), .half_0 = {}, .half_1 = {}};
      for (std::uint32_t i = 0; i < BlockBatch::largest; ++i) {
        batch.half_0[i] = half_of(philox({i, round, 0, 0}, 7), 0);
        batch.half_1[i] = half_of(philox({i, round, 0, 0}, 7), 1);
      }
      std::vector<double> normals(2 * batch.size + 1, 0.5);
      kernels.make_normals(batch, std::span(normals).first(2 * batch.size));
      EXPECT_EQ(normals.back(), 0.5) << "written beyond the end";
      normals.pop_back();
      ASSERT_EQ(bits_of(normals), normal_bits_one_by_one(batch)) << kernels.name << ", round " << round;
    }
  }
}

// Where the logarithm is zero or changes its exponent, and at and next to every eighth of a turn, including the signs
// of zeros; each in every lane.
TEST(NormalKernels, MakeTheNormalsOfOneByOneAtEveryEdge) {
  std::vector<std::uint64_t> radii = {0, 2047, 2048, every_bit, every_bit - 2047, every_bit - 2048};
  for (unsigned exponent = 12; exponent < 64; ++exponent) {
    for (const std::uint64_t less : {0U, 1U, 2048U, 4096U}) radii.push_back((std::uint64_t{1} << exponent) - less);
  }
  std::vector<std::uint64_t> turns;
  for (std::uint64_t eighth = 0; eighth < 8; ++eighth) {
    for (const std::uint64_t more :
         {std::uint64_t{0}, std::uint64_t{2047}, std::uint64_t{2048}, every_bit, every_bit - 2047}) {
      turns.push_back((eighth << 61U) + more);
    }
  }
  for (const NormalKernels& kernels : available_normal_kernels()) {
    for (std::size_t round = 0; round < radii.size(); ++round) {
      BlockBatch batch;
      for (std::size_t i = 0; i < batch.size; ++i) {
        batch.half_0[i] = radii[(round + i) % radii.size()];
        batch.half_1[i] = turns[(round * batch.size + i) % turns.size()];
      }
      std::vector<double> normals(2 * batch.size);
      kernels.make_normals(batch, normals);
      ASSERT_EQ(bits_of(normals), normal_bits_one_by_one(batch)) << kernels.name << ", round " << round;
    }
  }
}

// For any first index and any number: batches begin and end anywhere.
TEST(NormalKernels, GiveAnArrayTheBitsOfOneByOne) {
  const Draws draws(0x0123456789abcdef, (std::uint64_t{3} << 32U) + 11);
  for (const NormalKernels& kernels : available_normal_kernels()) {
    for (const std::uint64_t first :
         {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{31}, 2 * std::uint64_t{0xfffffff3} + 1}) {
      for (const std::size_t n : {0U, 1U, 2U, 15U, 16U, 17U, 31U, 32U, 33U, 63U, 64U, 65U, 200U}) {
        std::vector<double> numbers(n + 1, 0.5);
        draws.standard_normals(Source::kinetic_friction, first, std::span(numbers).first(n), kernels);
        for (std::size_t i = 0; i < n; ++i) {
          ASSERT_EQ(numbers[i], draws.standard_normal(Source::kinetic_friction, first + i))
              << kernels.name << ", " << first << " + " << i;
        }
        EXPECT_EQ(numbers.back(), 0.5) << "written beyond the end";
      }
    }
  }
}

#if defined(__x86_64__)
TEST(NormalKernels, AreTheBestThatTheProcessorHas) {
  const bool has_avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                          __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
  EXPECT_EQ(available_normal_kernels().back().name == "AVX-512", has_avx512);
}
#endif

}  // namespace
