#include "rocking/random/box_muller_steps.hpp"
#include "rocking/random/normal_kernels.hpp"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace rocking::random {
namespace {

#if defined(__AVX2__)

constexpr std::size_t lanes = 4;

/// `number` in each lane.
__m256i in_all_lanes(std::uint64_t number) { return _mm256_set1_epi64x(static_cast<std::int64_t>(number)); }

/// One word of four blocks, in the lower half of each lane. The upper half is ignored.
struct WordLanes {
  __m256i word[4];
};

/// One round, with the multipliers of Salmon et al. (2011), section 3.3.
///
/// Written with an intrinsic because g++ does not generate it: the instruction that multiplies four 32-bit words to
/// 64-bit products ignores the upper halves of its operands. Nothing has to be masked between rounds.
void advance(WordLanes& block, __m256i key_0, __m256i key_1) {
  auto& [word_0, word_1, word_2, word_3] = block.word;
  const __m256i product_0 = _mm256_mul_epu32(word_0, in_all_lanes(0xD2511F53U));
  const __m256i product_1 = _mm256_mul_epu32(word_2, in_all_lanes(0xCD9E8D57U));
  word_0 = _mm256_xor_si256(_mm256_xor_si256(_mm256_srli_epi64(product_1, 32), word_1), key_0);
  word_1 = product_1;
  word_2 = _mm256_xor_si256(_mm256_xor_si256(_mm256_srli_epi64(product_0, 32), word_3), key_1);
  word_3 = product_0;
}

/// Ten rounds on eight blocks, as two independent groups of four, so that the latencies of their multiplications
/// overlap.
void ten_rounds(WordLanes& left, WordLanes& right, std::uint64_t key) {
  __m256i key_0 = in_all_lanes(key & 0xffffffffU);
  __m256i key_1 = in_all_lanes(key >> 32U);
  for (int round = 0; round < 10; ++round) {
    advance(left, key_0, key_1);
    advance(right, key_0, key_1);
    key_0 = _mm256_add_epi64(key_0, in_all_lanes(0x9E3779B9U));  // the Weyl sequences of the same section
    key_1 = _mm256_add_epi64(key_1, in_all_lanes(0xBB67AE85U));
  }
}

/// Stores the halves of four blocks, beginning at block i.
void store(const WordLanes& block, std::size_t i, BlockBatch& batch) {
  const auto joined = [](__m256i low, __m256i high) {
    return _mm256_blend_epi32(low, _mm256_slli_epi64(high, 32), 0b10101010);
  };
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(&batch.half_0[i]), joined(block.word[0], block.word[1]));
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(&batch.half_1[i]), joined(block.word[2], block.word[3]));
}

#endif

void make_blocks(const Words& first, std::uint64_t key, BlockBatch& batch) {
#if defined(__AVX2__)
  const auto counted_from = [&first](std::uint64_t number) -> WordLanes {
    const __m256i numbers = _mm256_add_epi64(in_all_lanes(number), _mm256_set_epi64x(3, 2, 1, 0));
    return {{numbers, _mm256_srli_epi64(numbers, 32), in_all_lanes(first[2]), in_all_lanes(first[3])}};
  };
  static_assert(BlockBatch::step == 2 * lanes);
  for (std::size_t i = 0; i < batch.size; i += BlockBatch::step) {
    WordLanes left = counted_from(half_of(first, 0) + i);
    WordLanes right = counted_from(half_of(first, 0) + i + lanes);
    ten_rounds(left, right, key);
    store(left, i, batch);
    store(right, i + lanes, batch);
  }
#else
  for (std::size_t i = 0; i < batch.size; ++i) {
    const std::uint64_t number = half_of(first, 0) + i;
    const Words block = philox(
        {static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32U), first[2], first[3]}, key);
    batch.half_0[i] = half_of(block, 0);
    batch.half_1[i] = half_of(block, 1);
  }
#endif
}

void make_normals(const BlockBatch& batch, std::span<double> normals) {
  // Two loops, because one loop would need more values than there are registers.
  std::array<double, BlockBatch::largest> radius;
  for (std::size_t i = 0; i < batch.size; ++i) radius[i] = radius_of(batch.half_0[i]);
  for (std::size_t i = 0; i < batch.size; ++i) {
    const auto [sine, cosine] = sin_cos_of_turn(batch.half_1[i]);
    normals[2 * i] = radius[i] * cosine;
    normals[2 * i + 1] = radius[i] * sine;
  }
}

}  // namespace

std::span<const NormalKernels> plain_normal_kernels() {
  static constexpr NormalKernels kernels[] = {{"as built", make_blocks, make_normals}};
  return kernels;
}

}  // namespace rocking::random
