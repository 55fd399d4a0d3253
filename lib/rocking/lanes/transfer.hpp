#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rocking/integrate/hybrid.hpp"
#include "rocking/lanes/lane_state.hpp"
#include "rocking/lanes/lane_values.hpp"

/// Copies between a lane of the lane state and the values that a motion exchanges with it.
namespace rocking::lanes {

/// The present piece of the base motion; of a base motion that has knots, also its place among them.
inline void load_piece(LaneState& state, std::size_t lane, const ComingStep& step) {
  step.excitation->visit([&]<class Shaking>(const Shaking& excitation) {
    if constexpr (Shaking::piece_numbers > 0) {
      const auto piece = excitation.piece(*step.clock);
      for (std::size_t i = 0; i < piece.size(); ++i) state.piece[i][lane] = piece[i];
    }
    if constexpr (Shaking::has_knots) {
      state.knot[lane] = excitation.knot(*step.clock);
      state.other_break_period[lane] = static_cast<double>(step.coefficients_change.period);
      state.other_break_time[lane] = step.coefficients_change.time;
    }
  });
}

/// Of a block on this side.
inline void load_constants(LaneState& state, std::size_t lane, const dynamics::Setting& setting, double side) {
  dynamics::with_constants(setting, side, [&](const auto& constants) {
    dynamics::for_each_constant(state.constants, constants,
                                [lane](LaneRow& row, double number) { row[lane] = number; });
  });
}

/// The motion continues in the same lane after an event or a breakpoint.
inline void load_step(LaneState& state, std::size_t lane, const ComingStep& step) {
  const dynamics::Instant& now = step.clock->now();
  if (!step.setting->block.is_rectangle()) [[unlikely]]
    load_constants(state, lane, *step.setting, step.side);
  state.tilt[lane] = step.state.tilt;
  state.tilt_rate[lane] = step.state.tilt_rate;
  state.slip[lane] = step.state.slip;
  state.slip_rate[lane] = step.state.slip_rate;
  state.time[lane] = now.time;
  state.period[lane] = static_cast<double>(now.period);
  state.strobe_period[lane] = static_cast<double>(step.next_strobe.period);
  state.strobes_left[lane] = static_cast<double>(step.strobes_left);
  state.steps[lane] = 0.0;
  state.root_isolations[lane] = 0.0;
  state.peak_tilt[lane] = step.peaks.tilt;
  state.peak_tilt_rate[lane] = step.peaks.tilt_rate;
  state.steps_since_strobe[lane] = static_cast<double>(step.steps_since_strobe);
  state.break_period[lane] = static_cast<double>(step.breakpoint.period);
  state.break_time[lane] = step.breakpoint.time;
  state.breakpoints[lane] = 0.0;
  state.fresh[lane] = 0.0;
  load_piece(state, lane, step);
  state.amplitude[lane] = step.amplitude;
  state.static_friction[lane] = step.static_friction;
  state.kinetic_friction[lane] = step.kinetic_friction;
  state.slip_sign[lane] = step.slip_sign;
  state.restitution[lane] = step.restitution;
  state.impact_loss[lane] = step.impact_loss;
  state.least_rebound[lane] = step.least_rebound;
}

/// The known intervals of the friction grid; if there are none, the present one only.
inline void load_intervals(LaneState& state, std::size_t lane, const dynamics::KnownIntervals& coming,
                           double grid_start) {
  auto& intervals = state.intervals;
  const auto known = coming.wanted.empty() ? std::span(&state.kinetic_friction[lane], 1) : coming.wanted;
  std::ranges::copy(known, intervals.kinetic_friction[lane].begin());
  intervals.present[lane] = 0;
  intervals.known[lane] = static_cast<double>(known.size() - 1);
  intervals.per_period[lane] = static_cast<double>(coming.per_period);
  intervals.next_boundary[lane] = static_cast<double>(coming.next_boundary);
  intervals.grid_start[lane] = grid_start;
}

/// Puts a motion into a lane.
inline void load(LaneState& state, std::size_t lane, const ComingStep& step) {
  load_step(state, lane, step);
  const dynamics::Clock& clock = *step.clock;
  state.occupied[lane] = 1.0;
  state.strobe_time[lane] = step.next_strobe.time;
  state.frequency[lane] = clock.frequency();
  state.period_length[lane] = clock.period_length();
  state.resolution[lane] = clock.resolution();
  state.largest[lane] = step.setting->tolerance * step.setting->block.shape_angle;
  load_constants(state, lane, *step.setting, step.side);
}

/// The state at the strobe instant that a lane has passed.
[[nodiscard]] inline SideState strobe_point(const LaneState& state, std::size_t lane) {
  return {.tilt = state.strobe_tilt[lane],
          .tilt_rate = state.strobe_tilt_rate[lane],
          .slip = state.strobe_slip[lane],
          .slip_rate = state.strobe_slip_rate[lane]};
}

/// A whole number as an integer. The conversion to a signed integer is a single instruction.
[[nodiscard]] inline std::uint64_t count(double number) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
}

/// Where the steps that a lane has computed have come to.
[[nodiscard]] inline LaneProgress progress(const LaneState& state, std::size_t lane) {
  return {.state = {.tilt = state.tilt[lane],
                    .tilt_rate = state.tilt_rate[lane],
                    .slip = state.slip[lane],
                    .slip_rate = state.slip_rate[lane]},
          .now = {.period = static_cast<std::int64_t>(state.period[lane]), .time = state.time[lane]},
          .steps = count(state.steps[lane]),
          .steps_since_strobe = static_cast<std::int64_t>(state.steps_since_strobe[lane]),
          .peaks = {.tilt = state.peak_tilt[lane], .tilt_rate = state.peak_tilt_rate[lane]}};
}

/// End of the step that a lane has computed and not moved on.
[[nodiscard]] inline StepEnd end_of_step(const LaneState& state, std::size_t lane) {
  StepEnd end{.duration = state.duration[lane],
              .state = {.tilt = state.end_tilt[lane],
                        .tilt_rate = state.end_tilt_rate[lane],
                        .slip = state.end_slip[lane],
                        .slip_rate = state.end_slip_rate[lane]},
              .strobe = {}};
  if ((state.strobed >> lane & 1U) != 0) end.strobe = strobe_point(state, lane);
  return end;
}

/// The guards that fire at that end.
[[nodiscard]] inline integrate::FiredGuards fired(const LaneState& state, std::size_t lane) {
  return {count(state.fired[lane])};
}

}  // namespace rocking::lanes
