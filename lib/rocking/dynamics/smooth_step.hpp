#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "rocking/dynamics/automaton.hpp"
#include "rocking/dynamics/clock.hpp"

/// What of a motion its smooth steps need and change, as plain numbers in the frame of the block's side (S times each).
namespace rocking::dynamics {

struct SmoothState {
  double tilt;       ///< S theta [rad]
  double tilt_rate;  ///< S w
  double slip;       ///< S X
  double slip_rate;  ///< S V
};

/// The coming step.
struct SmoothStep {
  const Setting* setting;
  const Clock* clock;
  SmoothState state;
  double amplitude;         ///< of S alpha
  double static_friction;   ///< mu_s in force
  double kinetic_friction;  ///< mu_k in force
  double restitution;       ///< e of every impact; NaN where each has its own
  double impact_loss;       ///< of the tilt rate, as a share, in a sticking impact
  double least_rebound;     ///< a slower one may be the last of a chatter
  double slip_sign;         ///< S s
  Instant next_strobe;
  std::int64_t strobes_left;
  std::int64_t steps_since_strobe;
  Instant breakpoint;           ///< until which the equations hold
  Instant coefficients_change;  ///< the earliest breakpoint that is not the base motion's
  const Excitation* excitation;
};

inline constexpr std::size_t most_foreseen = 32;  ///< intervals of the friction grid, the present one among them

inline constexpr Instant never{.period = 0, .time = std::numeric_limits<double>::infinity()};

/// How a step ends in which something may happen.
struct SmoothEnd {
  double duration;                    ///< until the first event, or the end of the step
  SmoothState state;                  ///< then
  std::optional<SmoothState> strobe;  ///< at the strobe instant, if there is one before
};

/// What steps done elsewhere have come to.
struct SmoothProgress {
  SmoothState state;
  Instant now;
  std::uint64_t steps;
  std::int64_t steps_since_strobe;
  std::uint64_t breakpoints = 0;  ///< that were come to in those steps, the last at its end
  std::uint64_t foreseen = 0;     ///< of the intervals that began so
  bool at_breakpoint = false;     ///< the last of them is now, and what is in force is to be looked at
};

}  // namespace rocking::dynamics
