#pragma once

#include <span>

#include "rocking/lanes/kernels.hpp"

/// The units that are compiled for an instruction set each; empty where the compiler had no such flags.
namespace rocking::lanes {

[[nodiscard]] std::span<const Kernels> one_lane_kernels();
[[nodiscard]] std::span<const Kernels> neon_kernels();
[[nodiscard]] std::span<const Kernels> avx2_kernels();
[[nodiscard]] std::span<const Kernels> avx512_kernels();

}  // namespace rocking::lanes
