#pragma once

#include <cstdint>

#include "rocking/base/natural_logarithm.hpp"

/// How 64 random bits become a number between 0 and 1. The three differ in which ends they can reach; each result is
/// exact in double precision, so no rounding ever moves one to an end that it must not reach.
namespace rocking::random {

/// k 2^-53, k = 0 ... 2^53 - 1, from the upper 53 bits: 0 included, 1 not.
[[nodiscard]] constexpr double uniform_from_zero(std::uint64_t bits) {
  return static_cast<double>(bits >> 11U) * 0x1p-53;
}

/// (k + 1) 2^-53, k = 0 ... 2^53 - 1, from the upper 53 bits: 1 included, 0 not, so that it has a logarithm.
[[nodiscard]] constexpr double uniform_to_one(std::uint64_t bits) {
  return base::exact_number((bits >> 11U) + 1) * 0x1p-53;
}

/// (2k + 1) 2^-53, k = 0 ... 2^52 - 1, from the upper 52 bits: neither end, symmetric about 1/2.
[[nodiscard]] constexpr double uniform_inside(std::uint64_t bits) {
  return static_cast<double>(((bits >> 12U) << 1U) | 1U) * 0x1p-53;
}

}  // namespace rocking::random
