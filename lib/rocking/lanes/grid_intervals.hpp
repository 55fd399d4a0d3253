#pragma once

#include <bit>
#include <cstdint>

#include "rocking/lanes/moving_lanes.hpp"

namespace rocking::lanes {
namespace {

/// Kinetic friction of the present interval of the friction grid.
template <class Real>
[[nodiscard]] inline Real friction_of_interval(const LaneAccess<Real>& lanes) {
  using base::select, base::smaller;
  const auto& intervals = lanes.state.intervals;
  const Real wanted = Row<Real>::load_each(&intervals.kinetic_friction[lanes.first], &intervals.present[lanes.first]);
  return smaller(select(wanted < Real(0.0), Real(0.0), wanted), lanes.load(lanes.state.static_friction));
}

/// In the lanes that move on, whose brief step ends at a boundary of the friction grid: the next interval begins.
template <class Moving, class Real>
inline void pass_interval(const Moving& moving, const Real& period_length) {
  using base::select;
  const auto& lanes = moving.lanes;
  LaneState& state = lanes.state;
  lanes.store(state.intervals.known, lanes.load(state.intervals.known) - Real(1.0));
  static_assert(std::has_single_bit(static_cast<std::uint64_t>(dynamics::most_known_intervals)));
  std::int64_t* present = &state.intervals.present[lanes.first];
  for (int lane = 0; lane < Row<Real>::lanes; ++lane) {
    present[lane] = (present[lane] + 1) & (dynamics::most_known_intervals - 1);
  }
  const Real per_period = lanes.load(state.intervals.per_period);
  const Real next = lanes.load(state.intervals.next_boundary) + Real(1.0);
  const auto wraps = next == per_period;
  const Real boundary = select(wraps, Real(0.0), next);
  lanes.store(state.intervals.next_boundary, boundary);
  // As dynamics::grid_boundary.
  const Real time = lanes.load(state.intervals.grid_start) + boundary * period_length / per_period;
  moving.store(state.break_time, time, lanes.load(state.break_time));
  const Real period = lanes.load(state.break_period);
  moving.store(state.break_period, select(wraps, period + Real(1.0), period), period);
}

/// Lanes that have passed on to an interval that is not known.
template <class Real>
[[nodiscard]] inline std::uint32_t lanes_at_unknown_interval(const LaneAccess<Real>& lanes,
                                                             const TruthOf<Real>& passed) {
  return bits_of(passed && lanes.load(lanes.state.intervals.known) < Real(0.0));
}

}  // namespace
}  // namespace rocking::lanes
