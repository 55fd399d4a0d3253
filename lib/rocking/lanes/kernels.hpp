#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/lanes/lane_state.hpp"

namespace rocking::lanes {

/// Which equations the lanes of one group need. `_briefly`: until a breakpoint that is so near that a lower order
/// suffices.
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

/// Computes the coming step of every lane, and further ones while nothing happens in any lane; see LaneState for what is
/// known after the last one. At least one lane must have a run.
using Kernel = void (*)(LaneState&);

/// What the lanes of one group have in common besides: the form of the block and the kind of the base motion
/// (dynamics::Excitation::index).
inline constexpr std::size_t families = 2 * dynamics::excitation_kinds;
[[nodiscard]] constexpr std::size_t family_of(dynamics::BlockForm form, std::size_t excitation) {
  return static_cast<std::size_t>(form) * dynamics::excitation_kinds + excitation;
}

/// The kernels of one width, compiled for one instruction set.
struct Kernels {
  std::string_view name;  ///< of the instruction set, as `rocking doctor` prints it
  int lanes;
  /// By family_of, then by Kind.
  using ByKind = std::array<std::array<Kernel, kind_count>, families>;
  ByKind advance;
  /// The same with tangent vectors (LaneState::tangents); null for a base motion that is not periodic, or
  /// vertical too: there each motion computes its steps.
  ByKind advance_with_tangents;
};

/// Processor time of a run in these lanes, in seconds.
using SecondsOfTrial = std::function<double(const Kernels&)>;

/// Kernels in the order of their width, but the last two exchanged if the narrower ones take less than
/// `narrow_advantage` of the time in the best of three trials: a processor may compute its widest registers in halves.
/// One lane of plain doubles is never tried.
[[nodiscard]] std::vector<Kernels> fastest_last(std::vector<Kernels> kernels, const SecondsOfTrial& seconds);
inline constexpr double narrow_advantage = 0.95;

/// The kernels that this machine can run: one lane of plain doubles first, the fastest last. Their results have the
/// same bits. The first call compares the widest two, which takes about half a millisecond.
[[nodiscard]] std::span<const Kernels> available_kernels();

}  // namespace rocking::lanes
