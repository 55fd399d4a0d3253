#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

/// Registers of the instruction set for which the including unit is compiled, and the operations on them.
///
/// All is in an unnamed namespace: each compiled unit has its own copy, so that code compiled for a newer processor is
/// never linked into a program that runs on an older one.
namespace rocking::lanes {
namespace {

/// A register of `width` doubles: numbers, or for each of them a truth value (all bits set or none).
template <int width>
struct Register {
  typedef double Numbers __attribute__((vector_size(8 * width)));
  typedef std::uint64_t Bits __attribute__((vector_size(8 * width)));
  typedef std::int64_t Truths __attribute__((vector_size(8 * width)));
};

template <class Numbers>
inline auto is_less(Numbers a, Numbers b) {
  return a < b;
}
template <class Numbers>
inline auto is_equal(Numbers a, Numbers b) {
  return a == b;
}
template <class Truths, class Numbers>
inline Numbers chosen(Truths condition, Numbers a, Numbers b) {
  return condition ? a : b;
}
template <class Numbers>
inline Numbers smaller_of(Numbers a, Numbers b) {
  return a < b ? a : b;
}
template <class Truths>
inline Truths both(Truths a, Truths b) {
  return a & b;
}
template <class Truths>
inline Truths either(Truths a, Truths b) {
  return a | b;
}
template <class Truths>
inline Truths opposite(Truths a) {
  return ~a;
}
template <class Truths>
inline std::uint32_t mask_of(Truths truths) {
  std::uint32_t mask = 0;
  for (std::size_t i = 0; i < sizeof(Truths) / 8; ++i) mask |= (truths[i] != 0 ? 1U : 0U) << i;
  return mask;
}

template <class Numbers, std::size_t length>
inline Numbers loaded_each(const std::array<double, length>* rows, const std::int64_t* places) {
  Numbers numbers;
  for (std::size_t i = 0; i < sizeof(Numbers) / 8; ++i) numbers[i] = rows[i][static_cast<std::size_t>(places[i])];
  return numbers;
}
template <class Numbers>
inline void store_packed(std::uint32_t those, Numbers numbers, double* to) {
  for (std::size_t i = 0; i < sizeof(Numbers) / 8; ++i) {
    *to = numbers[i];
    to += those >> i & 1U;
  }
}
template <class Numbers>
inline Numbers load_packed(std::uint32_t those, const double* from) {
  Numbers numbers;
  for (std::size_t i = 0; i < sizeof(Numbers) / 8; ++i) {
    numbers[i] = *from;
    from += those >> i & 1U;
  }
  return numbers;
}

#if defined(__FMA__)
inline Register<2>::Numbers fused_of(Register<2>::Numbers a, Register<2>::Numbers b, Register<2>::Numbers c) {
  return _mm_fmadd_pd(a, b, c);
}
inline Register<4>::Numbers fused_of(Register<4>::Numbers a, Register<4>::Numbers b, Register<4>::Numbers c) {
  return _mm256_fmadd_pd(a, b, c);
}
// The lesser of a and b, and b where they do not compare, as smaller_of above.
inline Register<2>::Numbers smaller_of(Register<2>::Numbers a, Register<2>::Numbers b) { return _mm_min_pd(a, b); }
inline Register<4>::Numbers smaller_of(Register<4>::Numbers a, Register<4>::Numbers b) { return _mm256_min_pd(a, b); }
inline std::uint32_t mask_of(Register<2>::Truths t) { return static_cast<std::uint32_t>(_mm_movemask_pd((__m128d)t)); }
inline std::uint32_t mask_of(Register<4>::Truths t) {
  return static_cast<std::uint32_t>(_mm256_movemask_pd((__m256d)t));
}
#elif defined(__aarch64__)
inline Register<2>::Numbers fused_of(Register<2>::Numbers a, Register<2>::Numbers b, Register<2>::Numbers c) {
  return vfmaq_f64(c, a, b);
}
#endif

#if defined(__AVX512F__) && defined(__AVX512DQ__)
/// Here the truth values are the bits of a number.
template <>
struct Register<8> {
  typedef double Numbers __attribute__((vector_size(64)));
  typedef std::uint64_t Bits __attribute__((vector_size(64)));
  typedef __mmask8 Truths;
};

inline Register<8>::Numbers fused_of(Register<8>::Numbers a, Register<8>::Numbers b, Register<8>::Numbers c) {
  return _mm512_fmadd_pd(a, b, c);
}
inline Register<8>::Numbers smaller_of(Register<8>::Numbers a, Register<8>::Numbers b) {
  return _mm512_mask_min_pd(a, 0xff, a, b);
}
inline __mmask8 is_less(Register<8>::Numbers a, Register<8>::Numbers b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
inline __mmask8 is_equal(Register<8>::Numbers a, Register<8>::Numbers b) {
  return _mm512_cmp_pd_mask(a, b, _CMP_EQ_OQ);
}
inline Register<8>::Numbers chosen(__mmask8 condition, Register<8>::Numbers a, Register<8>::Numbers b) {
  return _mm512_mask_blend_pd(condition, b, a);
}
inline __mmask8 both(__mmask8 a, __mmask8 b) { return _kand_mask8(a, b); }
inline __mmask8 either(__mmask8 a, __mmask8 b) { return _kor_mask8(a, b); }
inline __mmask8 opposite(__mmask8 a) { return _knot_mask8(a); }
inline std::uint32_t mask_of(__mmask8 truths) { return _cvtmask8_u32(truths); }
inline void store_packed(std::uint32_t those, Register<8>::Numbers numbers, double* to) {
  _mm512_storeu_pd(to, _mm512_maskz_compress_pd(_cvtu32_mask8(those), numbers));
}
template <>
inline Register<8>::Numbers load_packed<Register<8>::Numbers>(std::uint32_t those, const double* from) {
  return _mm512_maskz_expand_pd(_cvtu32_mask8(those), _mm512_loadu_pd(from));
}
#endif

}  // namespace
}  // namespace rocking::lanes
