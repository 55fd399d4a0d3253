#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/lanes/block.hpp"

namespace rocking::lanes {

/// What lanes of one block have in common besides the kind of their base motion: which equations they need. `_briefly`: these
/// hold for a small part of a period only, and fewer terms do.
enum class Kind : std::uint8_t {
  rock,                ///< sliding is not possible
  rock_with_friction,  ///< sticking may fail
  rock_slide,
  rock_briefly,
  rock_with_friction_briefly,
  rock_slide_briefly,
};
inline constexpr std::size_t kind_count = 6;

[[nodiscard]] constexpr bool is_brief(Kind kind) { return kind >= Kind::rock_briefly; }
[[nodiscard]] constexpr bool slips(Kind kind) { return kind == Kind::rock_slide || kind == Kind::rock_slide_briefly; }
[[nodiscard]] constexpr bool tests_friction(Kind kind) {
  return kind == Kind::rock_with_friction || kind == Kind::rock_with_friction_briefly;
}
[[nodiscard]] constexpr int order_of(Kind kind) {
  return is_brief(kind) ? dynamics::brief_order : dynamics::full_order;
}

/// The coming step of every lane of a block; see Block for what is known after it.
using Kernel = void (*)(Block&);

/// The kernels of one width, compiled for one instruction set.
struct Kernels {
  std::string_view name;  ///< of the instruction set, as `rocking doctor` prints it
  int lanes;
  /// By kind of the base motion (dynamics::Excitation::index), then by Kind.
  std::array<std::array<Kernel, kind_count>, dynamics::excitation_kinds> advance;
};

/// Those that this machine can run, the one lane of plain doubles first, the best last. Their results have the same bits.
[[nodiscard]] std::span<const Kernels> available_kernels();

}  // namespace rocking::lanes
