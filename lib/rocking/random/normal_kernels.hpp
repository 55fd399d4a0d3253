#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "rocking/random/philox.hpp"

namespace rocking::random {

/// Half 0 of several blocks, and half 1 of the same blocks, each contiguous for vector loads.
struct BlockBatch {
  static constexpr std::size_t step = 8;
  static constexpr std::size_t largest = 32;

  std::size_t size = largest;  ///< blocks used, a multiple of `step`
  alignas(64) std::array<std::uint64_t, largest> half_0;
  alignas(64) std::array<std::uint64_t, largest> half_1;
};

/// Functions that compute many random blocks, and normal draws from them, compiled for one instruction set.
struct NormalKernels {
  std::string_view name;  ///< of the instruction set

  /// Computes `batch.size` blocks for the counter `first` and those after it. Words 0 and 1 count as one 64-bit number,
  /// modulo 2^64. The blocks are the same as those computed one by one.
  void (*make_blocks)(const Words& first, std::uint64_t key, BlockBatch& batch);

  /// Writes the pairs of all blocks in order to `normals`, whose size is twice the number of blocks. The bits are the
  /// same as those of single blocks.
  void (*make_normals)(const BlockBatch& batch, std::span<double> normals);
};

/// The kernels that this machine can run; the fastest is last. All of them return the same bits.
[[nodiscard]] std::span<const NormalKernels> available_normal_kernels();

/// Kernels for one instruction set each: that of the rest of the program, and AVX-512 (empty if the compiler does not
/// support it). X_normal_kernels is defined in normal_kernels_X.cpp.
[[nodiscard]] std::span<const NormalKernels> plain_normal_kernels();
[[nodiscard]] std::span<const NormalKernels> avx512_normal_kernels();

}  // namespace rocking::random
