#pragma once

#include <bit>
#include <cstdint>

#include "rocking/lanes/step.hpp"

namespace rocking::lanes {
namespace {

/// Of the lanes `no_event`, whose brief step ends at a boundary of the friction grid: the next interval begins, or the
/// motion must draw it if it is not known.
template <class Form, class Real = typename Form::Real>
inline void pass_interval(const LaneAccess<Real>& lanes, const Real& period_length,
                          const typename Form::Truth& no_event) {
  using base::select;
  LaneState& state = lanes.state;
  const Real known = lanes.load(state.intervals.known);
  lanes.mark(state.at_breakpoint, bits_of(no_event && known == Real(0.0)));
  lanes.store(state.intervals.known, known - Real(1.0));
  static_assert(std::has_single_bit(static_cast<std::uint64_t>(dynamics::most_known_intervals)));
  std::int64_t* present = &state.intervals.present[lanes.first];
  for (int lane = 0; lane < Row<Real>::lanes; ++lane) {
    present[lane] = (present[lane] + 1) & (dynamics::most_known_intervals - 1);
  }
  const Real per_period = lanes.load(state.intervals.per_period);
  const Real next = lanes.load(state.intervals.next_boundary) + Real(1.0);
  const auto wraps = next == per_period;
  const Real boundary = select(wraps, Real(0.0), next);
  const Real period = lanes.load(state.break_period);
  lanes.store(state.intervals.next_boundary, boundary);
  // As dynamics::grid_boundary.
  const Real time = lanes.load(state.intervals.grid_start) + boundary * period_length / per_period;
  lanes.store(state.break_time, select(no_event, time, lanes.load(state.break_time)));
  lanes.store(state.break_period, select(no_event && wraps, period + Real(1.0), period));
}

}  // namespace
}  // namespace rocking::lanes
