#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rocking/integrate/hybrid.hpp"
#include "rocking/lanes/lane_state.hpp"
#include "rocking/lanes/lane_values.hpp"

/// Copies between a lane of the lane state and the values that a motion exchanges with it.
namespace rocking::lanes {

/// The present piece of the base motion; of a base motion that has knots, also its place among them.
inline void load_piece(LaneState& block, std::size_t lane, const ComingStep& step) {
  step.excitation->visit([&]<class Shaking>(const Shaking& excitation) {
    if constexpr (Shaking::piece_numbers > 0) {
      const auto piece = excitation.piece(*step.clock);
      for (std::size_t i = 0; i < piece.size(); ++i) block.piece[i][lane] = piece[i];
    }
    if constexpr (Shaking::has_knots) {
      block.knot[lane] = excitation.knot(*step.clock);
      block.other_break_period[lane] = static_cast<double>(step.coefficients_change.period);
      block.other_break_time[lane] = step.coefficients_change.time;
    }
  });
}

/// The motion continues in the same lane after an event or a breakpoint.
inline void load_step(LaneState& block, std::size_t lane, const ComingStep& step) {
  const dynamics::Instant& now = step.clock->now();
  block.tilt[lane] = step.state.tilt;
  block.tilt_rate[lane] = step.state.tilt_rate;
  block.slip[lane] = step.state.slip;
  block.slip_rate[lane] = step.state.slip_rate;
  block.time[lane] = now.time;
  block.period[lane] = static_cast<double>(now.period);
  block.strobe_period[lane] = static_cast<double>(step.next_strobe.period);
  block.strobes_left[lane] = static_cast<double>(step.strobes_left);
  block.steps[lane] = 0.0;
  block.root_isolations[lane] = 0.0;
  block.peak_tilt[lane] = step.peaks.tilt;
  block.peak_tilt_rate[lane] = step.peaks.tilt_rate;
  block.steps_since_strobe[lane] = static_cast<double>(step.steps_since_strobe);
  block.break_period[lane] = static_cast<double>(step.breakpoint.period);
  block.break_time[lane] = step.breakpoint.time;
  block.breakpoints[lane] = 0.0;
  block.fresh[lane] = 0.0;
  load_piece(block, lane, step);
  block.amplitude[lane] = step.amplitude;
  block.static_friction[lane] = step.static_friction;
  block.kinetic_friction[lane] = step.kinetic_friction;
  block.slip_sign[lane] = step.slip_sign;
  block.restitution[lane] = step.restitution;
  block.impact_loss[lane] = step.impact_loss;
  block.least_rebound[lane] = step.least_rebound;
}

/// The known intervals of the friction grid; if there are none, the present one only.
inline void load_intervals(LaneState& block, std::size_t lane, const dynamics::KnownIntervals& coming,
                           double grid_start) {
  auto& intervals = block.intervals;
  const auto known = coming.wanted.empty() ? std::span(&block.kinetic_friction[lane], 1) : coming.wanted;
  std::ranges::copy(known, intervals.kinetic_friction[lane].begin());
  intervals.present[lane] = 0;
  intervals.known[lane] = static_cast<double>(known.size() - 1);
  intervals.per_period[lane] = static_cast<double>(coming.per_period);
  intervals.next_boundary[lane] = static_cast<double>(coming.next_boundary);
  intervals.grid_start[lane] = grid_start;
}

/// Puts a motion into a lane.
inline void load(LaneState& block, std::size_t lane, const ComingStep& step) {
  load_step(block, lane, step);
  const dynamics::Clock& clock = *step.clock;
  const auto constants = dynamics::equation_constants(*step.setting);
  block.occupied[lane] = 1.0;
  block.strobe_time[lane] = step.next_strobe.time;
  block.frequency[lane] = clock.frequency();
  block.period_length[lane] = clock.period_length();
  block.resolution[lane] = clock.resolution();
  block.largest[lane] = step.setting->tolerance * constants.shape_angle;
  dynamics::for_each_constant(block.constants, constants, [lane](LaneRow& row, double number) { row[lane] = number; });
}

/// The state at the strobe instant that a lane has passed.
[[nodiscard]] inline SideState strobe_point(const LaneState& block, std::size_t lane) {
  return {.tilt = block.strobe_tilt[lane],
          .tilt_rate = block.strobe_tilt_rate[lane],
          .slip = block.strobe_slip[lane],
          .slip_rate = block.strobe_slip_rate[lane]};
}

/// A whole number as an integer. The conversion to a signed integer is a single instruction.
[[nodiscard]] inline std::uint64_t count(double number) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
}

/// Where the steps that a lane has computed have come to.
[[nodiscard]] inline LaneProgress progress(const LaneState& block, std::size_t lane) {
  return {.state = {.tilt = block.tilt[lane],
                    .tilt_rate = block.tilt_rate[lane],
                    .slip = block.slip[lane],
                    .slip_rate = block.slip_rate[lane]},
          .now = {.period = static_cast<std::int64_t>(block.period[lane]), .time = block.time[lane]},
          .steps = count(block.steps[lane]),
          .steps_since_strobe = static_cast<std::int64_t>(block.steps_since_strobe[lane]),
          .peaks = {.tilt = block.peak_tilt[lane], .tilt_rate = block.peak_tilt_rate[lane]}};
}

/// End of the step that a lane has computed and not moved on.
[[nodiscard]] inline StepEnd end_of_step(const LaneState& block, std::size_t lane) {
  StepEnd end{.duration = block.duration[lane],
              .state = {.tilt = block.end_tilt[lane],
                        .tilt_rate = block.end_tilt_rate[lane],
                        .slip = block.end_slip[lane],
                        .slip_rate = block.end_slip_rate[lane]},
              .strobe = {}};
  if ((block.strobed >> lane & 1U) != 0) end.strobe = strobe_point(block, lane);
  return end;
}

/// The guards that fire at that end.
[[nodiscard]] inline integrate::FiredGuards fired(const LaneState& block, std::size_t lane) {
  std::uint32_t guards = 0;
  for (std::size_t guard = 0; guard < dynamics::guard_count; ++guard) {
    guards |= (block.fired[guard] >> lane & 1U) << guard;
  }
  return {guards};
}

}  // namespace rocking::lanes
