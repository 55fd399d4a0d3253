#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "rocking/section/response_mode.hpp"

namespace rocking::section {

/// The rule that decided a verdict, or the reason why nothing was decided.
enum class Reason : std::uint8_t {
  never_moved,         ///< rest
  came_to_rest,        ///< rest, under a record: moved, and stood still at the end
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
  not_stationary,      ///< unresolved: clouds move between parts of the window, to the end
  changed_regime,      ///< unresolved: at least half of the window is one response, which did not hold to the end
  phase_jump,          ///< unresolved: the same, and then the same clouds in another order: another phase copy
  interrupted,  ///< unresolved: comes back after some n <= 12 periods mostly, but misses time and again (jumps, bursts)
  slow_memory,  ///< unresolved: deviations live so long that the window holds too few independent ones
  impacts_irregular,  ///< unresolved: the number of impacts is not the same in nearly all cycles
};

/// Spelled as the enumerator.
[[nodiscard]] std::string_view to_string(Reason reason);

/// What a response was found to be.
struct Verdict {
  ResponseMode mode;
  std::optional<Reason> reason;  ///< absent where the motion ended before the horizon: nothing had to be decided
  bool in_transient = false;     ///< had not settled by the end of the sampled periods: drifting, or of slow memory
  /// Factor by which the deciding quantity nearest to its threshold clears it: 1 at the edge of another verdict, larger is
  /// surer. 0 where unresolved; infinity is cut at `largest_margin`.
  double margin = 0.0;
  /// Share of the sampled periods that bear the name out, up to the last: below 1 the response became what it is called
  /// within them. 0 where unresolved.
  double held = 1.0;
};

inline constexpr double largest_margin = 1e6;

[[nodiscard]] constexpr Verdict unresolved(Reason reason, bool in_transient = false) {
  return {{}, reason, in_transient, 0.0, 0.0};
}

}  // namespace rocking::section
