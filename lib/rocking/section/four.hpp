#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

#ifdef __AVX2__
#include <immintrin.h>
#endif

#if defined(__GNUC__) && !defined(__clang__)
// How four numbers are passed depends on the instruction set; all units of a library are compiled for the same one.
#pragma GCC diagnostic ignored "-Wpsabi"
#endif

namespace rocking::section {

/// Four numbers in a register, if the machine has such registers; the bits are those of single numbers.
using Four = double __attribute__((vector_size(4 * sizeof(double))));

inline constexpr std::size_t four = 4;

inline constexpr Four all_ones{1.0, 1.0, 1.0, 1.0};

/// Four numbers that are next to each other.
[[nodiscard]] inline Four four_from(const double* numbers) {
  Four a;
  std::memcpy(&a, numbers, sizeof a);
  return a;
}

[[nodiscard]] inline double sum_of(const Four& a) { return (a[0] + a[1]) + (a[2] + a[3]); }

/// a b + c, rounded once or twice, as the machine does it faster: for bounds, whose bits do not matter.
[[nodiscard]] inline Four roughly_fused(const Four& a, const Four& b, const Four& c) {
#ifdef __FMA__
  return _mm256_fmadd_pd(a, b, c);
#else
  return a * b + c;
#endif
}

[[nodiscard]] inline Four square_root(const Four& a) {
#ifdef __AVX2__
  return _mm256_sqrt_pd(a);
#else
  return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

}  // namespace rocking::section
