#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/dynamics/peaks.hpp"
#include "rocking/dynamics/setting.hpp"

/// What lanes and motions exchange, in the frame of the block's side S.
namespace rocking::lanes {

struct SideState {
  double tilt;       ///< S theta [rad]
  double tilt_rate;  ///< S w
  double slip;       ///< S X
  double slip_rate;  ///< S V
};

inline constexpr dynamics::Instant never{.period = 0, .time = std::numeric_limits<double>::infinity()};

/// What a lane needs to compute a motion's coming step.
struct ComingStep {
  const dynamics::Setting* setting;
  const dynamics::Clock* clock;
  SideState state;
  double side;              ///< S
  double amplitude;         ///< of S alpha
  double static_friction;   ///< mu_s in force
  double kinetic_friction;  ///< mu_k in force
  double restitution;       ///< e of every impact; NaN if it fluctuates
  double impact_loss;       ///< of the tilt rate of a rectangle, as a share, in a sticking impact
  double least_rebound;     ///< tilt rate below which an impact may end a chatter
  double slip_sign;         ///< S s
  dynamics::Instant next_strobe;
  std::int64_t strobes_left;
  std::int64_t steps_since_strobe;
  dynamics::Instant breakpoint;           ///< the equations hold until then
  dynamics::Instant coefficients_change;  ///< the earliest breakpoint that is not the base motion's
  const dynamics::Excitation* excitation;
  dynamics::TiltPeaks<double> peaks;  ///< so far
};

/// End of a step in which an event may occur.
struct StepEnd {
  double duration;                  ///< until the first event, or the end of the step
  SideState state;                  ///< then
  std::optional<SideState> strobe;  ///< at the strobe instant, if there is one before
};

/// Where the steps without events that a lane has computed have come to.
struct LaneProgress {
  SideState state;
  dynamics::Instant now;
  std::uint64_t steps;
  std::int64_t steps_since_strobe;
  dynamics::TiltPeaks<double> peaks;
  std::uint64_t breakpoints = 0;  ///< passed in those steps, the last one at their end
  std::uint64_t intervals = 0;    ///< of the friction grid that began at those breakpoints and were known beforehand
  bool at_breakpoint = false;     ///< the last breakpoint is now, and the motion must check its contact
};

}  // namespace rocking::lanes
