#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "rocking/dynamics/motion_series.hpp"
#include "rocking/lanes/block.hpp"

namespace rocking::lanes {

/// What lanes of one block have in common: which equations they need.
enum class Kind : std::uint8_t {
  rock,                ///< sliding is not possible
  rock_with_friction,  ///< sticking may fail
  rock_slide,
  rock_slide_briefly,  ///< the equations hold for a small part of a period only: fewer terms do
};
inline constexpr std::size_t kind_count = 4;

[[nodiscard]] constexpr int order_of(Kind kind) {
  return kind == Kind::rock_slide_briefly ? dynamics::brief_order : dynamics::full_order;
}

/// The coming step of every lane of a block; see Block for what is known after it.
using Kernel = void (*)(Block&);

/// The kernels of one width, compiled for one instruction set.
struct Kernels {
  std::string_view name;  ///< of the instruction set, as `rocking doctor` prints it
  int lanes;
  std::array<Kernel, kind_count> advance;  ///< by Kind
};

/// Those that this machine can run, the one lane of plain doubles first, the best last. Their results have the same bits.
[[nodiscard]] std::span<const Kernels> available_kernels();

}  // namespace rocking::lanes
