#pragma once

#include <span>

#include "rocking/lanes/kernels.hpp"

/// Kernels of one instruction set each: X_kernels is defined in kernels_X.cpp, empty if the compiler does not support
/// X.
namespace rocking::lanes {

[[nodiscard]] std::span<const Kernels> one_lane_kernels();
[[nodiscard]] std::span<const Kernels> neon_kernels();
[[nodiscard]] std::span<const Kernels> avx2_kernels();
[[nodiscard]] std::span<const Kernels> avx512_kernels();

}  // namespace rocking::lanes
