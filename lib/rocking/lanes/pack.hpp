#pragma once

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

template <int width>
struct Register {
  typedef double Numbers __attribute__((vector_size(8 * width)));
  typedef std::int64_t Truths __attribute__((vector_size(8 * width)));
  typedef std::uint64_t Bits __attribute__((vector_size(8 * width)));
};

#if defined(__FMA__)
inline Register<2>::Numbers fused_register(Register<2>::Numbers a, Register<2>::Numbers b, Register<2>::Numbers c) {
  return _mm_fmadd_pd(a, b, c);
}
inline Register<4>::Numbers fused_register(Register<4>::Numbers a, Register<4>::Numbers b, Register<4>::Numbers c) {
  return _mm256_fmadd_pd(a, b, c);
}
#elif defined(__aarch64__)
inline Register<2>::Numbers fused_register(Register<2>::Numbers a, Register<2>::Numbers b, Register<2>::Numbers c) {
  return vfmaq_f64(c, a, b);
}
#endif
#if defined(__AVX512F__)
inline Register<8>::Numbers fused_register(Register<8>::Numbers a, Register<8>::Numbers b, Register<8>::Numbers c) {
  return _mm512_fmadd_pd(a, b, c);
}
#endif

/// A truth a lane: all bits set or none.
template <int width, int registers>
struct Truth {
  typename Register<width>::Truths part[registers];
};

/// `registers` registers of `width` doubles each. Models base::Lane, with the bits that a double would get.
template <int width, int registers>
struct Pack {
  using Numbers = typename Register<width>::Numbers;
  using Bits = typename Register<width>::Bits;
  static constexpr int lanes = width * registers;

  Numbers part[registers];

  Pack() = default;
  explicit Pack(double value) {
    for (auto& numbers : part) numbers = value - Numbers{};  // not a sum: it would make 0 of -0
  }
};

template <int w, int r, class Operation>
inline Pack<w, r> each(const Pack<w, r>& a, const Pack<w, r>& b, Operation operation) {
  Pack<w, r> result;
#pragma GCC unroll 4
  for (int i = 0; i < r; ++i) result.part[i] = operation(a.part[i], b.part[i]);
  return result;
}
template <int w, int r, class Operation>
inline Truth<w, r> each_truth(const Pack<w, r>& a, const Pack<w, r>& b, Operation operation) {
  Truth<w, r> result;
#pragma GCC unroll 4
  for (int i = 0; i < r; ++i) result.part[i] = operation(a.part[i], b.part[i]);
  return result;
}
template <int w, int r, class Operation>
inline Truth<w, r> each_truth(const Truth<w, r>& a, const Truth<w, r>& b, Operation operation) {
  Truth<w, r> result;
#pragma GCC unroll 4
  for (int i = 0; i < r; ++i) result.part[i] = operation(a.part[i], b.part[i]);
  return result;
}

template <int w, int r>
inline Pack<w, r> operator+(const Pack<w, r>& a, const Pack<w, r>& b) {
  return each(a, b, [](auto x, auto y) { return x + y; });
}
template <int w, int r>
inline Pack<w, r> operator-(const Pack<w, r>& a, const Pack<w, r>& b) {
  return each(a, b, [](auto x, auto y) { return x - y; });
}
template <int w, int r>
inline Pack<w, r> operator*(const Pack<w, r>& a, const Pack<w, r>& b) {
  return each(a, b, [](auto x, auto y) { return x * y; });
}
template <int w, int r>
inline Pack<w, r> operator/(const Pack<w, r>& a, const Pack<w, r>& b) {
  return each(a, b, [](auto x, auto y) { return x / y; });
}
template <int w, int r>
inline Pack<w, r> operator-(const Pack<w, r>& a) {
  return each(a, a, [](auto x, auto) { return -x; });
}
template <int w, int r>
inline Truth<w, r> operator<(const Pack<w, r>& a, const Pack<w, r>& b) {
  return each_truth(a, b, [](auto x, auto y) { return x < y; });
}
template <int w, int r>
inline Truth<w, r> operator==(const Pack<w, r>& a, const Pack<w, r>& b) {
  return each_truth(a, b, [](auto x, auto y) { return x == y; });
}
template <int w, int r>
inline Truth<w, r> operator&&(const Truth<w, r>& a, const Truth<w, r>& b) {
  return each_truth(a, b, [](auto x, auto y) { return x & y; });
}
template <int w, int r>
inline Truth<w, r> operator||(const Truth<w, r>& a, const Truth<w, r>& b) {
  return each_truth(a, b, [](auto x, auto y) { return x | y; });
}
template <int w, int r>
inline Truth<w, r> operator!(const Truth<w, r>& a) {
  return each_truth(a, a, [](auto x, auto) { return ~x; });
}

template <int w, int r>
inline Pack<w, r> fused(const Pack<w, r>& a, const Pack<w, r>& b, const Pack<w, r>& c) {
  Pack<w, r> result;
#pragma GCC unroll 4
  for (int i = 0; i < r; ++i) result.part[i] = fused_register(a.part[i], b.part[i], c.part[i]);
  return result;
}
template <int w, int r>
inline Pack<w, r> select(const Truth<w, r>& condition, const Pack<w, r>& a, const Pack<w, r>& b) {
  Pack<w, r> result;
#pragma GCC unroll 4
  for (int i = 0; i < r; ++i) result.part[i] = condition.part[i] ? a.part[i] : b.part[i];
  return result;
}
template <int w, int r>
inline Pack<w, r> smaller(const Pack<w, r>& a, const Pack<w, r>& b) {
  return each(a, b, [](auto x, auto y) { return x < y ? x : y; });
}

/// See base::upper_word: an integer below 2^31, put into the lower bits of 2^52, is 2^52 and that integer.
template <int w, int r>
inline Pack<w, r> upper_word(const Pack<w, r>& y) {
  using Numbers = typename Register<w>::Numbers;
  using Bits = typename Register<w>::Bits;
  constexpr std::uint64_t bits_of_2_52 = 0x4330000000000000;
  return each(y, y, [](auto x, auto) { return (Numbers)(((Bits)x >> 32U) | bits_of_2_52) - 0x1p52; });
}
template <int w, int r>
inline Pack<w, r> from_upper_word(const Pack<w, r>& word) {
  using Numbers = typename Register<w>::Numbers;
  using Bits = typename Register<w>::Bits;
  return each(word, word, [](auto x, auto) { return (Numbers)((Bits)(x + 0x1p52) << 32U); });
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
};
template <>
struct Row<double> {
  static constexpr int lanes = 1;
  static double load(const double* numbers) { return *numbers; }
  static void store(double value, double* numbers) { *numbers = value; }
};

/// Bit i: the truth of lane i.
inline std::uint32_t bits_of(bool truth) { return truth ? 1U : 0U; }
template <int w, int r>
inline std::uint32_t bits_of(const Truth<w, r>& truth) {
  std::uint32_t bits = 0;
  for (int i = 0; i < r; ++i) {
#if defined(__AVX512DQ__)
    if constexpr (w == 8) {
      bits |= static_cast<std::uint32_t>(_mm512_movepi64_mask((__m512i)truth.part[i])) << (w * i);
      continue;
    }
#endif
#if defined(__AVX2__)
    if constexpr (w == 4) {
      bits |= static_cast<std::uint32_t>(_mm256_movemask_pd((__m256d)truth.part[i])) << (w * i);
      continue;
    }
#endif
    std::int64_t truths[w];
    __builtin_memcpy(truths, &truth.part[i], sizeof(truths));
    for (int k = 0; k < w; ++k) bits |= (truths[k] != 0 ? 1U : 0U) << (w * i + k);
  }
  return bits;
}

}  // namespace
}  // namespace rocking::lanes
