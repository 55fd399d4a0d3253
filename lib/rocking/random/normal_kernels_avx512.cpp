#include "rocking/random/normal_kernels.hpp"

// All code here is in an unnamed namespace or inlined. Otherwise the linker could use a function compiled here, for a
// newer processor, in code that runs on an older one.
#if defined(__AVX512F__) && defined(__AVX512DQ__)

#include <immintrin.h>

#include "rocking/random/box_muller_steps.hpp"

namespace rocking::random {
namespace {

constexpr std::size_t lanes = 8;
static_assert(BlockBatch::step == lanes);

/// Eight doubles. Models base::Number; each lane gets the bits that a double would get.
struct Numbers {
  typedef double Register __attribute__((vector_size(64)));
  Register lanes;

  explicit Numbers(Register value) : lanes(value) {}
  explicit Numbers(double value) : lanes(value - Register{}) {}  // not a sum: it would turn -0 into 0

  friend Numbers operator+(Numbers a, Numbers b) { return Numbers(a.lanes + b.lanes); }
  friend Numbers operator-(Numbers a, Numbers b) { return Numbers(a.lanes - b.lanes); }
  friend Numbers operator*(Numbers a, Numbers b) { return Numbers(a.lanes * b.lanes); }
  friend Numbers operator/(Numbers a, Numbers b) { return Numbers(a.lanes / b.lanes); }
  friend Numbers operator-(Numbers a) { return Numbers(-a.lanes); }
};

/// The bits of eight doubles, or one half of each of eight blocks.
struct Bits {
  typedef std::uint64_t Register __attribute__((vector_size(64)));
  Register lanes;

  explicit Bits(Register value) : lanes(value) {}
  explicit Bits(__m512i value) : lanes((Register)value) {}
  explicit Bits(std::uint64_t value) : lanes(value + Register{}) {}

  friend Bits operator+(Bits a, std::uint64_t b) { return Bits(a.lanes + b); }
  friend Bits operator-(Bits a, Bits b) { return Bits(a.lanes - b.lanes); }
  friend Bits operator&(Bits a, Bits b) { return Bits(a.lanes & b.lanes); }
  friend Bits operator&(Bits a, std::uint64_t b) { return Bits(a.lanes & b); }
  friend Bits operator^(Bits a, Bits b) { return Bits(a.lanes ^ b.lanes); }
  friend Bits operator<<(Bits a, unsigned places) { return Bits(a.lanes << places); }
  friend Bits operator>>(Bits a, unsigned places) { return Bits(a.lanes >> places); }
};

Bits bits_of(Numbers a) { return Bits((Bits::Register)a.lanes); }
Numbers number_of(Bits a) { return Numbers((Numbers::Register)a.lanes); }
Numbers fused(Numbers a, Numbers b, Numbers c) { return Numbers(_mm512_fmadd_pd(a.lanes, b.lanes, c.lanes)); }
// The masked form with all lanes selected avoids a g++ 12 warning about undefined values in its own header.
Numbers sqrt(Numbers a) { return Numbers(_mm512_maskz_sqrt_pd(0xff, a.lanes)); }

/// As for one number; AVX-512 has a conversion of integers.
Numbers exact_number(Bits k) { return Numbers(_mm512_cvtepu64_pd((__m512i)k.lanes)); }
Numbers uniform_to_one(Bits bits) { return exact_number((bits >> 11U) + 1) * Numbers(0x1p-53); }

/// One word of eight blocks, in the lower half of each lane. The upper half is ignored.
struct WordLanes {
  Bits word[4];
};

Bits product(Bits words, std::uint64_t factor) {
  return Bits(_mm512_maskz_mul_epu32(0xff, (__m512i)words.lanes, (__m512i)Bits(factor).lanes));
}

/// a xor b xor c in one instruction.
Bits exclusive_or(Bits a, Bits b, std::uint32_t c) {
  const __m512i in_all_halves = _mm512_set1_epi32(static_cast<std::int32_t>(c));
  return Bits(_mm512_ternarylogic_epi32((__m512i)a.lanes, (__m512i)b.lanes, in_all_halves, 0x96));
}

/// One round, with the multipliers of Salmon et al. (2011), section 3.3, as in normal_kernels_plain.cpp.
void advance(WordLanes& block, std::uint32_t key_0, std::uint32_t key_1) {
  auto& [word_0, word_1, word_2, word_3] = block.word;
  const Bits product_0 = product(word_0, 0xD2511F53U);
  const Bits product_1 = product(word_2, 0xCD9E8D57U);
  word_0 = exclusive_or(product_1 >> 32U, word_1, key_0);
  word_1 = product_1;
  word_2 = exclusive_or(product_0 >> 32U, word_3, key_1);
  word_3 = product_0;
}

/// Stores the words as halves of eight blocks.
void store(Bits low, Bits high, std::uint64_t* halves) {
  const __m512i raised = (__m512i)(high << 32U).lanes;
  _mm512_storeu_si512(halves, _mm512_mask_blend_epi32(0b1010101010101010, (__m512i)low.lanes, raised));
}

void make_blocks(const Words& first, std::uint64_t key, BlockBatch& batch) {
  for (std::size_t i = 0; i < batch.size; i += lanes) {
    const Bits numbers = Bits(Bits::Register{0, 1, 2, 3, 4, 5, 6, 7}) + (half_of(first, 0) + i);
    WordLanes block = {{numbers, numbers >> 32U, Bits(std::uint64_t{first[2]}), Bits(std::uint64_t{first[3]})}};
    auto key_0 = static_cast<std::uint32_t>(key);
    auto key_1 = static_cast<std::uint32_t>(key >> 32U);
#pragma GCC unroll 10
    for (int round = 0; round < 10; ++round) {
      advance(block, key_0, key_1);
      key_0 += 0x9E3779B9U;  // the Weyl sequences of the same section
      key_1 += 0xBB67AE85U;
    }
    store(block.word[0], block.word[1], &batch.half_0[i]);
    store(block.word[2], block.word[3], &batch.half_1[i]);
  }
}

void make_normals(const BlockBatch& batch, std::span<double> normals) {
  const __m512i lower_pairs = _mm512_set_epi64(11, 3, 10, 2, 9, 1, 8, 0);
  const __m512i upper_pairs = _mm512_set_epi64(15, 7, 14, 6, 13, 5, 12, 4);
  for (std::size_t i = 0; i < batch.size; i += lanes) {
    const Numbers radius = radius_of(Bits(_mm512_loadu_si512(&batch.half_0[i])));
    const auto [sine, cosine] = sin_cos_of_turn(Bits(_mm512_loadu_si512(&batch.half_1[i])));
    const Numbers even = radius * cosine;
    const Numbers odd = radius * sine;
    _mm512_storeu_pd(&normals[2 * i], _mm512_permutex2var_pd(even.lanes, lower_pairs, odd.lanes));
    _mm512_storeu_pd(&normals[2 * i + lanes], _mm512_permutex2var_pd(even.lanes, upper_pairs, odd.lanes));
  }
}

}  // namespace

std::span<const NormalKernels> avx512_normal_kernels() {
  static constexpr NormalKernels kernels[] = {{"AVX-512", make_blocks, make_normals}};
  return kernels;
}

}  // namespace rocking::random

#else

namespace rocking::random {
std::span<const NormalKernels> avx512_normal_kernels() { return {}; }
}  // namespace rocking::random

#endif
