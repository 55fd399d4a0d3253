#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rocking::random {

/// A counter, or what the generator makes of it: four words, the first one the lowest.
using Words = std::array<std::uint32_t, 4>;

/// Philox4x32-10: a bijection of the counters for each key, whose images pass every known test of randomness.
///
/// The low half of `key` is the first key word. Integers only, hence the same on every machine.
/// Source: Salmon, Moraes, Dror & Shaw (2011), Parallel random numbers: as easy as 1, 2, 3, SC'11.
[[nodiscard]] Words philox(const Words& counter, std::uint64_t key);

/// The 64 bits of one half of a block: words 0 and 1 (half 0) or 2 and 3 (half 1), the first one low.
[[nodiscard]] constexpr std::uint64_t half_of(const Words& block, std::size_t half) {
  return block[2 * half] | (std::uint64_t{block[2 * half + 1]} << 32U);
}

}  // namespace rocking::random
