#pragma once

#include <cstdint>

#include "rocking/base/natural_logarithm.hpp"

/// Conversions of 64 random bits to a number between 0 and 1. The three differ in whether 0 and 1 can occur. Every
/// result is exact in double precision, so that no rounding produces an excluded end.
namespace rocking::random {

/// k 2^-53, k = 0 ... 2^53 - 1, from the upper 53 bits: can be 0, cannot be 1.
[[nodiscard]] constexpr double uniform_from_zero(std::uint64_t bits) {
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// (k + 1) 2^-53, k = 0 ... 2^53 - 1, from the upper 53 bits: can be 1, cannot be 0, so that its logarithm is finite.
[[nodiscard]] constexpr double uniform_to_one(std::uint64_t bits) {
  return base::exact_number((bits >> 11U) + 1) * 0x1p-53;
}

/// (2k + 1) 2^-53, k = 0 ... 2^52 - 1, from the upper 52 bits: neither 0 nor 1, symmetric about 1/2.
[[nodiscard]] constexpr double uniform_inside(std::uint64_t bits) {
  return static_cast<double>(((bits >> 12U) << 1U) | 1U) * 0x1p-53;
}

}  // namespace rocking::random
