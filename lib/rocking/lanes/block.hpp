#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/dynamics/guards.hpp"
#include "rocking/dynamics/smooth_step.hpp"

namespace rocking::lanes {

inline constexpr int most_lanes = 16;

/// A number a lane.
using LaneRow = std::array<double, most_lanes>;

/// Realisations side by side, each with its own time, step and events: what a kernel reads and writes. A plain table, the
/// same for every instruction set. All in the frame of each block's side, as the series are (dynamics/motion_series.hpp).
struct alignas(64) Block {
  // The state, moved on by the kernel in the lanes where nothing happens.
  LaneRow tilt;           ///< S theta [rad]
  LaneRow tilt_rate;      ///< S w
  LaneRow slip;           ///< S X
  LaneRow slip_rate;      ///< S V
  LaneRow time;           ///< since the current excitation period began
  LaneRow period;         ///< count of excitation periods
  LaneRow strobe_period;  ///< of the next strobe point
  LaneRow strobes_left;   ///< before the run stands at its last one
  LaneRow steps;          ///< done in this lane
  LaneRow steps_since_strobe;
  LaneRow root_isolations;  ///< in those steps, and in the last if it is left to the motion

  // What stays as it is while nothing happens.
  LaneRow occupied;          ///< 1 in the lanes that are, else 0
  LaneRow strobe_time;       ///< within its period
  LaneRow break_period;      ///< of the instant until which the equations hold
  LaneRow break_time;        ///< within that; infinite if there is none
  LaneRow amplitude;         ///< S times that of the base acceleration over g
  LaneRow frequency;         ///< Omega_h
  LaneRow period_length;     ///< 2 pi/Omega_h
  LaneRow resolution;        ///< instants closer than this are one
  LaneRow shape_angle;       ///< psi
  LaneRow sine;              ///< of psi
  LaneRow cosine;            ///< of psi
  LaneRow largest;           ///< of the last terms of a series: tolerance times psi
  LaneRow static_friction;   ///< mu_s
  LaneRow inertia;           ///< J
  LaneRow kinetic_friction;  ///< mu_k
  LaneRow restitution;       ///< e; NaN where no impact is done here
  LaneRow impact_loss;       ///< of the tilt rate, as a share, in a sticking impact
  LaneRow least_rebound;     ///< after an impact that is done here
  LaneRow slip_sign;         ///< S s

  // The base motion's numbers until its next breakpoint; where it has knots, the steps pass on from one to the next.
  std::array<LaneRow, dynamics::most_piece_numbers> piece;
  std::array<const dynamics::Knot*, most_lanes> knot;  ///< at which the piece begins
  LaneRow other_break_period;                          ///< of the next breakpoint that is not the base motion's
  LaneRow other_break_time;
  LaneRow breakpoints;  ///< passed in this lane
  LaneRow fresh;        ///< 1 where the coming step begins at a breakpoint that was passed here

  // The intervals of the friction grid, in the block of brief steps, each of which ends with one. A lane's are in a row.
  struct Intervals {
    /// mu_k before it is held between 0 and mu_s: that above has no say.
    std::array<std::array<double, dynamics::most_foreseen>, most_lanes> kinetic_friction;
    std::array<std::int64_t, most_lanes> present;  ///< where in there the interval is in which the coming step is
    LaneRow known;                                 ///< of the next ones so many
    LaneRow per_period;
    LaneRow next_boundary;  ///< where the present one ends: its number within its period
    LaneRow grid_start;     ///< where a period's boundary number 0 is
  } intervals;

  // What the last step was like.
  std::uint32_t quiet;   ///< lanes in which nothing happened: they were moved on
  std::uint32_t landed;  ///< of them, those that landed at the end of the step and rock on the other edge
  std::uint32_t held;    ///< lanes that wait for others, so that roots are looked for in several at once
  std::uint32_t
      at_breakpoint;      ///< lanes that stand at a breakpoint after which their motion must look at what is in force
  std::uint32_t strobed;  ///< lanes that passed a strobe point
  LaneRow strobe_tilt;    ///< the state then
  LaneRow strobe_tilt_rate;
  LaneRow strobe_slip;
  LaneRow strobe_slip_rate;

  // And in the lanes that were left where they were, since something happens in the step:
  std::uint32_t at_last_strobe;  ///< lanes that came to the last strobe point before anything else
  std::uint32_t alone;           ///< lanes whose step is no ordinary one after all
  LaneRow duration;              ///< until the first event, or the end of the step
  LaneRow end_tilt;              ///< the state then
  LaneRow end_tilt_rate;
  LaneRow end_slip;
  LaneRow end_slip_rate;
  std::array<std::uint32_t, dynamics::guard_count>
      fired;  ///< by dynamics::Guard: lanes where it is among the first events
};

}  // namespace rocking::lanes
