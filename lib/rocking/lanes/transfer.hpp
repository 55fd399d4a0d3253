#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "rocking/dynamics/smooth_step.hpp"
#include "rocking/integrate/hybrid.hpp"
#include "rocking/lanes/block.hpp"

/// Between the lanes of a block and the motions that are in them.
namespace rocking::lanes {

/// Of a base motion that has knots.
inline void load_piece(Block& block, std::size_t lane, const dynamics::SmoothStep& step) {
  step.excitation->visit([&]<class Shaking>(const Shaking& excitation) {
    if constexpr (Shaking::has_knots) {
      const auto piece = excitation.piece(*step.clock);
      for (std::size_t i = 0; i < piece.size(); ++i) block.piece[i][lane] = piece[i];
      block.knot[lane] = excitation.knot(*step.clock);
    }
  });
  block.other_break_period[lane] = static_cast<double>(step.coefficients_change.period);
  block.other_break_time[lane] = step.coefficients_change.time;
}

/// Goes on in a lane after an event or a breakpoint.
inline void load_step(Block& block, std::size_t lane, const dynamics::SmoothStep& step) {
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
  block.steps_since_strobe[lane] = static_cast<double>(step.steps_since_strobe);
  block.break_period[lane] = static_cast<double>(step.breakpoint.period);
  block.break_time[lane] = step.breakpoint.time;
  block.breakpoints[lane] = 0.0;
  block.fresh[lane] = 0.0;
  if (step.excitation->has_knots()) load_piece(block, lane, step);
  block.amplitude[lane] = step.amplitude;
  block.static_friction[lane] = step.static_friction;
  block.kinetic_friction[lane] = step.kinetic_friction;
  block.slip_sign[lane] = step.slip_sign;
  block.restitution[lane] = step.restitution;
  block.impact_loss[lane] = step.impact_loss;
  block.least_rebound[lane] = step.least_rebound;
}

/// What is known of the intervals of the friction grid.
inline void load_intervals(Block& block, std::size_t lane, const dynamics::FrictionForesight& coming,
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

/// Puts the coming step of a motion into a lane in which another was.
inline void load(Block& block, std::size_t lane, const dynamics::SmoothStep& step) {
  load_step(block, lane, step);
  const dynamics::Clock& clock = *step.clock;
  const dynamics::Geometry& geometry = step.setting->block;
  block.occupied[lane] = 1.0;
  block.strobe_time[lane] = step.next_strobe.time;
  block.frequency[lane] = clock.frequency();
  block.period_length[lane] = clock.period_length();
  block.resolution[lane] = clock.resolution();
  block.shape_angle[lane] = geometry.shape_angle;
  block.sine[lane] = geometry.sine;
  block.cosine[lane] = geometry.cosine;
  block.largest[lane] = step.setting->tolerance * geometry.shape_angle;
  block.inertia[lane] = step.setting->inertia;
}

/// The state at the strobe instant that was passed in a lane.
[[nodiscard]] inline dynamics::SmoothState strobe_point(const Block& block, std::size_t lane) {
  return {.tilt = block.strobe_tilt[lane],
          .tilt_rate = block.strobe_tilt_rate[lane],
          .slip = block.strobe_slip[lane],
          .slip_rate = block.strobe_slip_rate[lane]};
}

/// A whole number; by way of a signed one, which a processor converts in one instruction.
[[nodiscard]] inline std::uint64_t count(double number) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
}

/// How far the steps done in a lane have come.
[[nodiscard]] inline dynamics::SmoothProgress progress(const Block& block, std::size_t lane) {
  return {.state = {.tilt = block.tilt[lane],
                    .tilt_rate = block.tilt_rate[lane],
                    .slip = block.slip[lane],
                    .slip_rate = block.slip_rate[lane]},
          .now = {.period = static_cast<std::int64_t>(block.period[lane]), .time = block.time[lane]},
          .steps = count(block.steps[lane]),
          .steps_since_strobe = static_cast<std::int64_t>(block.steps_since_strobe[lane])};
}

/// How the step ends that has been looked at in a lane.
[[nodiscard]] inline dynamics::SmoothEnd end_of_step(const Block& block, std::size_t lane) {
  dynamics::SmoothEnd end{.duration = block.duration[lane],
                          .state = {.tilt = block.end_tilt[lane],
                                    .tilt_rate = block.end_tilt_rate[lane],
                                    .slip = block.end_slip[lane],
                                    .slip_rate = block.end_slip_rate[lane]},
                          .strobe = {}};
  if ((block.strobed >> lane & 1U) != 0) end.strobe = strobe_point(block, lane);
  return end;
}

/// The guards that fire then.
[[nodiscard]] inline integrate::FiredGuards fired(const Block& block, std::size_t lane) {
  std::uint32_t guards = 0;
  for (std::size_t guard = 0; guard < dynamics::guard_count; ++guard) {
    guards |= (block.fired[guard] >> lane & 1U) << guard;
  }
  return {guards};
}

}  // namespace rocking::lanes
