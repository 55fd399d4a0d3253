#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "rocking/lanes/rebounds.hpp"

namespace rocking::lanes {
namespace {

/// What the lanes do at breakpoints: a new piece of the base motion, or a new interval of the friction grid, begins.
template <Kind kind, class Shaking, class Real>
class Breakpoints : public Rebounds<kind, Shaking, Real> {
  using Base = Rebounds<kind, Shaking, Real>;

 protected:
  using Base::state_, Base::first_, Base::load, Base::m_, Base::mark, Base::occupied_, Base::period_length_,
      Base::presses_, Base::store;
  using typename Base::Truth;

 public:
  using Base::Base;

 protected:
  /// Lanes whose step begins at a breakpoint that was passed here and where sticking may fail: their motions must check
  /// it. The expressions are those of dynamics::ContactRules::friction_holds.
  [[nodiscard]] Truth may_slip_at_breakpoint() const {
    using base::magnitude;
    const Real mu_s = load(state_.static_friction);
    const Real most = mu_s * m_.normal[0];
    const Real friction = Real(4.0 / 3.0) * m_.base[0] - m_.rate_cosine[1];
    const Truth holds = presses_ && base::at_most(magnitude(friction), most);
    return occupied_ && load(state_.fresh) == Real(1.0) && !holds;
  }

  /// Of the lanes that have `moved` on, those that `arrived` at a breakpoint continue with the piece that begins there.
  /// Where a breakpoint that is not the base motion's is reached too, the motion continues alone.
  void pass_knots(std::uint32_t moved, std::uint32_t arrived) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(Row<Real>::lanes); ++i) {
      const std::size_t lane = first_ + i;
      if ((moved >> i & 1U) == 0) continue;
      const bool at_break = (arrived >> i & 1U) != 0;
      state_.fresh[lane] = at_break ? 1.0 : 0.0;
      if (at_break) pass_knot(lane);
    }
  }

  /// Of the lanes without an event, whose brief step ends at a boundary of the friction grid: the next interval begins,
  /// or the motion must draw it if it is not known.
  void pass_interval(const Truth& no_event) {
    using base::select;
    const Real known = load(state_.intervals.known);
    mark(state_.at_breakpoint, bits_of(no_event && known == Real(0.0)));
    store(state_.intervals.known, known - Real(1.0));
    static_assert(std::has_single_bit(static_cast<std::uint64_t>(dynamics::most_known_intervals)));
    std::int64_t* present = &state_.intervals.present[first_];
    for (int lane = 0; lane < Row<Real>::lanes; ++lane) {
      present[lane] = (present[lane] + 1) & (dynamics::most_known_intervals - 1);
    }
    const Real per_period = load(state_.intervals.per_period);
    const Real next = load(state_.intervals.next_boundary) + Real(1.0);
    const Truth wraps = next == per_period;
    const Real boundary = select(wraps, Real(0.0), next);
    const Real period = load(state_.break_period);
    store(state_.intervals.next_boundary, boundary);
    // As dynamics::grid_boundary.
    store(state_.break_time,
          select(no_event, load(state_.intervals.grid_start) + boundary * period_length_ / per_period,
                 load(state_.break_time)));
    store(state_.break_period, select(no_event && wraps, period + Real(1.0), period));
  }

 private:
  void pass_knot(std::size_t lane) {
    state_.breakpoints[lane] += 1.0;
    const dynamics::Moment<double> now{.period = state_.period[lane],
                                       .time = state_.time[lane],
                                       .period_length = state_.period_length[lane],
                                       .frequency = state_.frequency[lane]};
    const dynamics::Knot* knot = Shaking::template follow<Real>(state_.knot[lane], now, state_.resolution[lane]);
    state_.knot[lane] = knot;
    const auto piece = Shaking::template piece_from<Real>(knot, state_.piece[Shaking::piece_numbers - 1][lane]);
    for (std::size_t i = 0; i < Shaking::piece_numbers; ++i) state_.piece[i][lane] = piece[i];
    const double other_period = state_.other_break_period[lane];
    const double other_time = state_.other_break_time[lane];
    const double until_other = now.until(other_period, other_time);
    if (until_other <= state_.resolution[lane]) state_.at_breakpoint |= 1U << lane;
    const auto knot_period = static_cast<double>(knot[1].instant.period);
    const bool other_first = until_other < now.until(knot_period, knot[1].instant.time);
    state_.break_period[lane] = other_first ? other_period : knot_period;
    state_.break_time[lane] = other_first ? other_time : knot[1].instant.time;
  }
};

}  // namespace
}  // namespace rocking::lanes
