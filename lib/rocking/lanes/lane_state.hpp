#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rocking/dynamics/coefficients.hpp"
#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/dynamics/guards.hpp"
#include "rocking/dynamics/setting.hpp"
#include "rocking/lanes/lane_row.hpp"

namespace rocking::lanes {

struct TangentRows;

/// What a kernel reads and writes: realisations side by side, each with its own time, step and events. A plain table,
/// the same for every instruction set. All in the frame of each block's side, as the series are
/// (dynamics/motion_series.hpp).
struct alignas(64) LaneState {
  // The state. The kernel moves it on in the lanes without an event.
  LaneRow tilt;           ///< S theta [rad]
  LaneRow tilt_rate;      ///< S w
  LaneRow slip;           ///< S X
  LaneRow slip_rate;      ///< S V
  LaneRow time;           ///< since the current excitation period began
  LaneRow period;         ///< count of excitation periods
  LaneRow strobe_period;  ///< of the next strobe point
  LaneRow strobes_left;   ///< until the run ends
  LaneRow steps;          ///< computed in this lane
  LaneRow steps_since_strobe;
  LaneRow peak_tilt;        ///< largest S theta so far
  LaneRow peak_tilt_rate;   ///< largest abs(w) so far
  LaneRow root_isolations;  ///< in those steps, and in the last one if the motion completes it

  // What is constant without an event.
  LaneRow occupied;       ///< 1 in the lanes that have a run, else 0
  LaneRow strobe_time;    ///< within its period
  LaneRow break_period;   ///< of the next breakpoint
  LaneRow break_time;     ///< within its period; infinite if there is none
  LaneRow amplitude;      ///< of S alpha
  LaneRow frequency;      ///< Omega_h
  LaneRow period_length;  ///< 2 pi/Omega_h
  LaneRow resolution;     ///< instants closer than this are one
  dynamics::EquationConstants<LaneRow, dynamics::BlockForm::general> constants;
  LaneRow largest;           ///< largest last term of a series: tolerance times psi of the nearer edge
  LaneRow static_friction;   ///< mu_s
  LaneRow kinetic_friction;  ///< mu_k
  LaneRow restitution;       ///< e; NaN if it fluctuates: then no impact is computed here
  LaneRow impact_loss;       ///< of the tilt rate, as a share, in a sticking impact
  LaneRow least_rebound;     ///< tilt rate after an impact above which it is computed here
  LaneRow slip_sign;         ///< S s

  // The base motion's numbers until its next breakpoint. If it has knots, the steps pass on from one piece to the next;
  // if not, the motion loads the next piece.
  std::array<LaneRow, dynamics::most_piece_numbers> piece;
  std::array<const dynamics::Knot*, most_lanes> knot;  ///< at which the piece begins, if the base motion has knots
  LaneRow other_break_period;                          ///< of the next breakpoint that is not the base motion's
  LaneRow other_break_time;
  LaneRow breakpoints;  ///< passed in this lane
  LaneRow fresh;        ///< 1 where the coming step begins at a breakpoint that was passed here

  // The intervals of the friction grid, for brief steps with slip, each of which ends with an interval.
  struct Intervals {
    /// mu_k of each interval before the clamp to [0, mu_s]; `kinetic_friction` above is not used then.
    std::array<std::array<double, static_cast<std::size_t>(dynamics::most_known_intervals)>, most_lanes>
        kinetic_friction;
    std::array<std::int64_t, most_lanes> present;  ///< index there of the interval of the coming step
    LaneRow known;                                 ///< how many of the next intervals are known
    LaneRow per_period;
    LaneRow next_boundary;  ///< number, within its period, of the boundary at the end of the present interval
    LaneRow grid_start;     ///< time of boundary number 0 within a period
  } intervals;

  TangentRows* tangents;  ///< of these lanes; only for kernels that advance them

  // What the last step found.
  std::uint32_t no_event;       ///< lanes without an event but an impact: they were moved on
  std::uint32_t landed;         ///< of them, those that ended the step with an impact and rock about the other edge
  std::uint32_t held;           ///< lanes that wait, so that zero crossings are searched for in several lanes at once
  std::uint32_t at_breakpoint;  ///< lanes at a breakpoint at which their motion must continue
  std::uint32_t strobed;        ///< lanes that passed a strobe point
  LaneRow strobe_tilt;          ///< the state then
  LaneRow strobe_tilt_rate;
  LaneRow strobe_slip;
  LaneRow strobe_slip_rate;

  // In the lanes that were not moved on, because an event occurs in the step:
  std::uint32_t at_last_strobe;  ///< lanes in which the last strobe instant comes before any event
  std::uint32_t alone;           ///< lanes whose step the motion must compute alone
  LaneRow duration;              ///< until the first event, or the end of the step
  LaneRow end_tilt;              ///< the state then
  LaneRow end_tilt_rate;
  LaneRow end_slip;
  LaneRow end_slip_rate;
  LaneRow fired;  ///< sum of 2^guard over the guards (dynamics::Guard) that are among the first events
};

}  // namespace rocking::lanes
