#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#if defined(__x86_64__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

/// Several doubles side by side, in registers of the instruction set for which the including unit is compiled.
///
/// All is in an unnamed namespace: each unit has packs, and kernels made of them, of its own, so that nothing compiled for a
/// newer processor can be linked into code that runs on an older one.
namespace rocking::lanes {
namespace {

/// A register of `width` doubles: numbers, or for each of them a truth (all bits set or none).
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
// The least of a and b, and b where there is none: what smaller_of says above.
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
/// Here truths are the bits of a number.
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

/// A truth a lane.
template <int width>
struct Truth {
  typename Register<width>::Truths truths;
};

/// As many doubles as there are in a register. Models base::Lane, with the bits that a double would get.
template <int width>
struct Pack {
  using Numbers = typename Register<width>::Numbers;
  using Bits = typename Register<width>::Bits;
  static constexpr int lanes = width;

  Numbers numbers;

  Pack() = default;
  explicit Pack(Numbers value) : numbers(value) {}
  explicit Pack(double value) : numbers(value - Numbers{}) {}  // not a sum: it would make 0 of -0
};

template <int w>
inline Pack<w> operator+(const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(a.numbers + b.numbers);
}
template <int w>
inline Pack<w> operator-(const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(a.numbers - b.numbers);
}
template <int w>
inline Pack<w> operator*(const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(a.numbers * b.numbers);
}
template <int w>
inline Pack<w> operator/(const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(a.numbers / b.numbers);
}
template <int w>
inline Pack<w> operator-(const Pack<w>& a) {
  return Pack<w>(-a.numbers);
}
template <int w>
inline Truth<w> operator<(const Pack<w>& a, const Pack<w>& b) {
  return {is_less(a.numbers, b.numbers)};
}
template <int w>
inline Truth<w> operator==(const Pack<w>& a, const Pack<w>& b) {
  return {is_equal(a.numbers, b.numbers)};
}
template <int w>
inline Truth<w> operator&&(const Truth<w>& a, const Truth<w>& b) {
  return {both(a.truths, b.truths)};
}
template <int w>
inline Truth<w> operator||(const Truth<w>& a, const Truth<w>& b) {
  return {either(a.truths, b.truths)};
}
template <int w>
inline Truth<w> operator!(const Truth<w>& a) {
  return {opposite(a.truths)};
}

template <int w>
inline Pack<w> fused(const Pack<w>& a, const Pack<w>& b, const Pack<w>& c) {
  return Pack<w>(fused_of(a.numbers, b.numbers, c.numbers));
}
template <int w>
inline Pack<w> select(const Truth<w>& condition, const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(chosen(condition.truths, a.numbers, b.numbers));
}
template <int w>
inline Pack<w> smaller(const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(smaller_of(a.numbers, b.numbers));
}

/// See base::upper_word: an integer below 2^31, put into the lower bits of 2^52, is 2^52 and that integer.
template <int w>
inline Pack<w> upper_word(const Pack<w>& y) {
  constexpr std::uint64_t bits_of_2_52 = 0x4330000000000000;
  return Pack<w>((typename Pack<w>::Numbers)(((typename Pack<w>::Bits)y.numbers << 1U >> 33U) | bits_of_2_52) - 0x1p52);
}
template <int w>
inline Pack<w> from_upper_word(const Pack<w>& word) {
  return Pack<w>((typename Pack<w>::Numbers)((typename Pack<w>::Bits)(word.numbers + 0x1p52) << 32U));
}

/// From and to as many doubles in a row.
template <class Real>
struct Row {
  static constexpr int lanes = Real::lanes;
  static Real load(const double* numbers) {
    Real result;
    __builtin_memcpy(&result, numbers, sizeof(Real));
    return result;
  }
  static void store(const Real& value, double* numbers) { __builtin_memcpy(numbers, &value, sizeof(Real)); }
  /// Only those in the lanes whose bits are set, one after another; what then comes up to a whole register is overwritten.
  static void store_those(std::uint32_t those, const Real& value, double* numbers) {
    store_packed(those, value.numbers, numbers);
  }
  /// What store_those has stored, back in its lanes; any numbers in the others.
  static Real load_those(std::uint32_t those, const double* numbers) {
    return Real(load_packed<typename Real::Numbers>(those, numbers));
  }
  /// From a row each, at a place each.
  template <std::size_t length>
  static Real load_each(const std::array<double, length>* rows, const std::int64_t* places) {
    return Real(loaded_each<typename Real::Numbers>(rows, places));
  }
};
template <>
struct Row<double> {
  static constexpr int lanes = 1;
  static double load(const double* numbers) { return *numbers; }
  static void store(double value, double* numbers) { *numbers = value; }
  static void store_those(std::uint32_t, double value, double* numbers) { *numbers = value; }
  static double load_those(std::uint32_t, const double* numbers) { return *numbers; }
  template <std::size_t length>
  static double load_each(const std::array<double, length>* row, const std::int64_t* place) {
    return (*row)[static_cast<std::size_t>(*place)];
  }
};

template <int w>
inline bool in_any(const Truth<w>& truth) {
  return mask_of(truth.truths) != 0;
}

/// Bit i: the truth of lane i.
inline std::uint32_t bits_of(bool truth) { return truth ? 1U : 0U; }
template <int w>
inline std::uint32_t bits_of(const Truth<w>& truth) {
  return mask_of(truth.truths);
}
}  // namespace
}  // namespace rocking::lanes
