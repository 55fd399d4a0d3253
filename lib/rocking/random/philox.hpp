#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace rocking::random {

/// A counter or the output of the generator for it: four words, the lowest first.
using Words = std::array<std::uint32_t, 4>;

/// Philox4x32-10: for each key a bijection of the counters. It passes all tests of TestU01 (BigCrush; see the source).
///
/// The lower half of `key` is the first key word. Integer arithmetic only, hence the same words on every machine.
/// Source: Salmon, Moraes, Dror & Shaw (2011), Parallel random numbers: as easy as 1, 2, 3, SC'11.
[[nodiscard]] Words philox(const Words& counter, std::uint64_t key);

/// The 64 bits of one half of a block: words 0 and 1 (half 0) or 2 and 3 (half 1), the lower word first.
[[nodiscard]] constexpr std::uint64_t half_of(const Words& block, std::size_t half) {
  return block[2 * half] | (std::uint64_t{block[2 * half + 1]} << 32U);
}

}  // namespace rocking::random
