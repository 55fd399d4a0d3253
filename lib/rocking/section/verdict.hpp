#pragma once

#include <cstdint>
#include <string_view>

#include "rocking/section/response_mode.hpp"

namespace rocking::section {

/// The rule that decided a verdict, or the reason why nothing was decided.
enum class Reason : std::uint8_t {
  never_moved,         ///< rest
  points_coincide,     ///< periodic: the strobe points repeat to within the resolution
  points_converge,     ///< periodic: they come together geometrically, and little is left to come
  tight_clouds,        ///< periodic: clouds in cyclic order, tiny beside the motion
  contracting_clouds,  ///< periodic: wide clouds in cyclic order, and a negative exponent
  positive_exponent,   ///< chaotic
  too_few_points,      ///< unresolved: the horizon is too short for any of this
  still_converging,    ///< unresolved: towards a periodic response, with too far to go
  not_periodic,        ///< unresolved: no n repeats, and the exponent is negative (long or slowly drifting orbits)
  exponent_unclear,    ///< unresolved: within its error of zero, or not to be had
  clouds_overlap,      ///< unresolved: split by phase beyond chance, yet not apart
  period_too_long,     ///< unresolved: lines whose common period is longer than `longest_period`
  out_of_order,        ///< unresolved: too many points far from the cloud whose turn it was
  not_stationary,      ///< unresolved: clouds move between parts of the window (drift, change of regime, phase jump)
  slow_memory,         ///< unresolved: deviations live so long that the window holds too few independent ones
  impacts_irregular,   ///< unresolved: the number of impacts is not the same in nearly all cycles
};

/// Spelled as the enumerator.
[[nodiscard]] std::string_view to_string(Reason reason);

/// What a response was found to be.
struct Verdict {
  ResponseMode mode;
  Reason reason = Reason::too_few_points;
  bool in_transient = false;  ///< had not settled by the end of the sampled periods: drifting, or of slow memory
  /// Factor by which the deciding quantity nearest to its threshold clears it: 1 at the edge of another verdict, larger is
  /// surer. 0 where unresolved; infinity is cut at `largest_margin`.
  double margin = 0.0;
};

inline constexpr double largest_margin = 1e6;

[[nodiscard]] constexpr Verdict unresolved(Reason reason, bool in_transient = false) {
  return {{}, reason, in_transient, 0.0};
}

}  // namespace rocking::section
