#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "rocking/section/response_mode.hpp"

namespace rocking::section {

/// State at a strobe instant, after the events of that instant: a Poincare point and the slip rate.
struct StrobePoint {
  double tilt = 0.0;       ///< Theta [-]
  double tilt_rate = 0.0;  ///< Theta' [-]
  double slip_rate = 0.0;  ///< V [-]
};

/// Largest difference in Theta, Theta' or V.
[[nodiscard]] inline double distance(const StrobePoint& a, const StrobePoint& b) {
  return std::max(
      {std::abs(a.tilt - b.tilt), std::abs(a.tilt_rate - b.tilt_rate), std::abs(a.slip_rate - b.slip_rate)});
}

/// One excitation period and the strobe point at its end.
struct Period {
  StrobePoint point;
  std::uint16_t impacts = 0;  ///< impacts that changed the edge; a chatter counts once
  bool moved = false;         ///< false: in full contact without sliding throughout the period
};

/// The largest n of a periodic response (m, n). Longer periods are not tested.
inline constexpr int longest_period = 12;

/// The rule that decided a classification, or the reason why the response is unresolved.
enum class Reason : std::uint8_t {
  never_moved,         ///< rest
  came_to_rest,        ///< rest or slide, under a recorded excitation: moved, and is at rest at the end
  points_coincide,     ///< periodic: the strobe points repeat to within the resolution
  stable_orbit,        ///< periodic: the points tend to a stable orbit that Newton's method found
  tight_clouds,        ///< periodic: clouds visited in cyclic order, very small compared with the motion
  contracting_clouds,  ///< periodic: large clouds visited in cyclic order, and a negative exponent
  clouds_about_orbit,  ///< periodic: clouds about a stable orbit of the motion without noise, and a negative exponent
  closed_curves,       ///< quasi-periodic: on closed curves in the order of a rotation, and an exponent of zero
  positive_exponent,   ///< chaotic
  too_few_points,      ///< unresolved: the horizon is too short for any rule
  still_converging,    ///< unresolved: converges towards a periodic response, but too much drift remains
  not_periodic,  ///< unresolved: repeats for no tested n, and the exponent is negative (long or slowly drifting orbits)
  exponent_unclear,  ///< unresolved: the exponent differs from zero by less than its error, or could not be computed
  clouds_overlap,    ///< unresolved: the points differ by phase more than by chance, but the clouds overlap
  period_too_long,   ///< unresolved: spectral lines or a stable orbit of a period longer than `longest_period`
  out_of_order,      ///< unresolved: too many points are far from the cloud that should come next
  not_stationary,    ///< unresolved: the clouds move between parts of the window, to its end
  changed_regime,    ///< unresolved: one response for at least half of the window, which changed before the end
  phase_jump,        ///< unresolved: as changed_regime, but with the same clouds in another order (another phase copy)
  interrupted,       ///< unresolved: mostly returns after some n <= 12 periods, but repeatedly fails to (jumps, bursts)
  slow_memory,       ///< unresolved: deviations decay so slowly that the window has too few independent ones
  impacts_irregular,  ///< unresolved: too many cycles differ in their number of impacts
};

/// The names of the reasons, in the order of their declaration.
inline constexpr auto reason_names = std::to_array<std::string_view>(
    {"never_moved",        "came_to_rest",       "points_coincide",  "stable_orbit",      "tight_clouds",
     "contracting_clouds", "clouds_about_orbit", "closed_curves",    "positive_exponent", "too_few_points",
     "still_converging",   "not_periodic",       "exponent_unclear", "clouds_overlap",    "period_too_long",
     "out_of_order",       "not_stationary",     "changed_regime",   "phase_jump",        "interrupted",
     "slow_memory",        "impacts_irregular"});
static_assert(reason_names.size() == static_cast<std::size_t>(Reason::impacts_irregular) + 1);

[[nodiscard]] constexpr std::string_view to_string(Reason reason) {
  return reason_names[static_cast<std::size_t>(reason)];
}

/// What a label (m,n) is backed by: a stable orbit that Newton's method found, points that repeat, or clouds in order.
enum class Backing : std::uint8_t { orbit, points, clouds };

inline constexpr std::array<std::string_view, 3> backing_names{"orbit", "points", "clouds"};
[[nodiscard]] constexpr std::string_view to_string(Backing backing) {
  return backing_names[static_cast<std::size_t>(backing)];
}

/// Absent of a rule that gives no (m,n).
[[nodiscard]] constexpr std::optional<Backing> backing_of(Reason reason) {
  switch (reason) {
    case Reason::stable_orbit:
    case Reason::clouds_about_orbit: return Backing::orbit;
    case Reason::points_coincide: return Backing::points;
    case Reason::tight_clouds:
    case Reason::contracting_clouds: return Backing::clouds;
    case Reason::never_moved:
    case Reason::came_to_rest:
    case Reason::closed_curves:
    case Reason::positive_exponent:
    case Reason::too_few_points:
    case Reason::still_converging:
    case Reason::not_periodic:
    case Reason::exponent_unclear:
    case Reason::clouds_overlap:
    case Reason::period_too_long:
    case Reason::out_of_order:
    case Reason::not_stationary:
    case Reason::changed_regime:
    case Reason::phase_jump:
    case Reason::interrupted:
    case Reason::slow_memory:
    case Reason::impacts_irregular: break;
  }
  return std::nullopt;
}

/// The reason with this name; absent where there is none.
[[nodiscard]] std::optional<Reason> reason_named(std::string_view name);

/// Result of the classification of a response.
struct Classification {
  ResponseMode mode;
  std::optional<Reason> reason;  ///< absent if the motion ended before the horizon, so that no rule was needed
  bool in_transient = false;     ///< had not settled by the end of the sampled periods: drifting, or with long memory
  /// Smallest factor by which the quantities that decided exceed their thresholds. 1 is the limit to another
  /// classification; larger values are more certain. 0 if unresolved, at most `largest_margin`.
  double margin = 0.0;
  /// Share of the sampled periods, up to the last one, that support the classification. Below 1 the response settled
  /// within the window. 0 if unresolved.
  double held = 1.0;
};

inline constexpr double largest_margin = 1e6;

[[nodiscard]] constexpr Classification unresolved(Reason reason, bool in_transient = false) {
  return {{}, reason, in_transient, 0.0, 0.0};
}

}  // namespace rocking::section
