#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "rocking/random/philox.hpp"

namespace rocking::random {

/// Several blocks, half 0 of all and half 1 of all: as a vector unit reads them.
struct BlockBatch {
  static constexpr std::size_t step = 8;
  static constexpr std::size_t largest = 32;

  std::size_t size = largest;  ///< blocks in use, a multiple of `step`
  alignas(64) std::array<std::uint64_t, largest> half_0;
  alignas(64) std::array<std::uint64_t, largest> half_1;
};

/// Many random blocks, and many normals of them, at once: compiled for one instruction set.
struct NormalKernels {
  std::string_view name;  ///< of the instruction set

  /// Makes `batch.size` blocks, of `first` and of the counters after it, words 0 and 1 counting up as one number of 64
  /// bits (modulo 2^64). The same blocks as one by one.
  void (*make_blocks)(const Words& first, std::uint64_t key, BlockBatch& batch);

  /// Writes the pairs of all blocks, one after the other, to `normals`, twice as many as blocks. The same numbers as block by
  /// block, to the bit.
  void (*make_normals)(const BlockBatch& batch, std::span<double> normals);
};

/// Those that this machine can run, the best last. Their numbers have the same bits.
[[nodiscard]] std::span<const NormalKernels> available_normal_kernels();

/// The units that are compiled for an instruction set each: the one that the rest of the program is compiled for, and
/// AVX-512 (empty where the compiler had no such flags).
[[nodiscard]] std::span<const NormalKernels> plain_normal_kernels();
[[nodiscard]] std::span<const NormalKernels> avx512_normal_kernels();

}  // namespace rocking::random
