#pragma once

#include <cstddef>
#include <cstdint>

#include "rocking/dynamics/peaks.hpp"
#include "rocking/lanes/breakpoints.hpp"

namespace rocking::lanes {
namespace {

/// Computes the coming step of the lanes. A lane moves on if its step has no event but an impact of Rebounds, no
/// breakpoint that is not passed here, and at most one strobe instant, which is not the last. The other lanes stay, and
/// the lane state says what was found: which guards fire, when, and the state then. Their motions do the rest.
template <Kind kind, class Shaking, class Real>
class Advance : Breakpoints<kind, Shaking, Real> {
  using Base = Breakpoints<kind, Shaking, Real>;
  using Base::state_, Base::duration_, Base::end_, Base::isolations_, Base::load, Base::crossings_, Base::crosses_,
      Base::m_, Base::mark, Base::may_land, Base::occupied_, Base::on_grid, Base::passes_breakpoints, Base::period_,
      Base::period_length_, Base::presses_, Base::reach_, Base::rebound_, Base::slips, Base::store, Base::time_,
      Base::uncleared_, Base::undecided_, Base::waits_;
  using typename Base::Strobing, typename Base::Truth;

 public:
  using Base::Base;

  using Base::ask, Base::begin, Base::expand, Base::has_others, Base::look, Base::uncleared_count;
  using typename Base::Search;

  [[gnu::noinline]] void finish(const Search& search) {
    using base::select;
    this->find_crossings(search);
    const Real resolution = load(state_.resolution);
    const Real steps_since = load(state_.steps_since_strobe) + Real(1.0);
    const Strobing strobing = this->strobing(duration_ - resolution);
    Truth fits = !undecided_ && presses_ && this->is_finite(end_) && this->is_ordinary(resolution, steps_since) &&
                 strobing.is_simple;
    mark(state_.at_breakpoint, 0);
    if constexpr (Shaking::has_knots && Base::tests_friction) {
      const Truth unsure = this->may_slip_at_breakpoint();
      mark(state_.at_breakpoint, bits_of(unsure));
      fits = fits && !unsure;
    }
    if (bits_of(fits && strobing.strobes) != 0) {
      fits = fits && (this->store_strobe(strobing, resolution) || !strobing.strobes);
    }
    const Truth strobed = fits && strobing.strobes;
    mark(state_.strobed, bits_of(strobed));
    mark(state_.alone, bits_of(!fits));
    if (bits_of(uncleared_) != 0) {
      const Real before = load(state_.root_isolations);
      store(state_.root_isolations, select(fits, before + isolations_, before));
    }
    const Truth at_last_strobe = strobed && strobing.is_last;
    mark(state_.at_last_strobe, bits_of(at_last_strobe));
    note_peaks(fits && !waits_, at_last_strobe, this->time_of(strobing, resolution));
    fits = fits && !at_last_strobe;
    Truth lands = crossings_[0];
    if (may_land && bits_of(lands) != 0) lands = this->find_rebounds(fits);
    move(fits && !crosses_, lands, strobed, steps_since);
    if (!all_move_on_) store_end();
  }

 private:
  /// The steps of the lanes `computed` go to their ends, or to the last strobe instant.
  void note_peaks(const Truth& computed, const Truth& at_last_strobe, const Real& last_strobe) {
    using base::in_any, base::select;
    dynamics::StepFinish<Real> end{.length = duration_, .tilt = end_.tilt, .tilt_rate = end_.tilt_rate};
    if (bits_of(at_last_strobe) != 0) {
      end = {.length = select(at_last_strobe, last_strobe, duration_),
             .tilt = select(at_last_strobe, load(state_.strobe_tilt), end_.tilt),
             .tilt_rate = select(at_last_strobe, load(state_.strobe_tilt_rate), end_.tilt_rate)};
    }
    const dynamics::TiltPeaks<Real> before{.tilt = load(state_.peak_tilt), .tilt_rate = load(state_.peak_tilt_rate)};
    if (!in_any(dynamics::may_raise<Real>(m_, end, before))) return;
    const dynamics::TiltPeaks<Real> after = dynamics::peaks_after<Real>(m_, Base::order, end, before);
    store(state_.peak_tilt, select(computed, after.tilt, before.tilt));
    store(state_.peak_tilt_rate, select(computed, after.tilt_rate, before.tilt_rate));
  }

  /// Moves on the lanes without a crossing and those that land, unless they reach the end of what holds for them: a
  /// breakpoint that is not passed here, or the end of the period.
  void move(const Truth& without_crossing, const Truth& lands, const Truth& strobed, const Real& steps_since) {
    using base::magnitude, base::select;
    Truth ends_at_break = !(duration_ < reach_ - load(state_.resolution));
    if constexpr (on_grid) ends_at_break = without_crossing;
    Real later = time_ + duration_;
    Real from = period_;
    if constexpr (passes_breakpoints) {
      later = select(ends_at_break, load(state_.break_time), later);
      from = select(ends_at_break, load(state_.break_period), from);
    }
    const Truth wraps = !(later < period_length_);
    const Real time = select(wraps, later - period_length_, later);
    Truth no_event = (may_land ? without_crossing || lands : without_crossing) && time < period_length_;
    if constexpr (!passes_breakpoints) no_event = no_event && !ends_at_break;
    mark(state_.no_event, bits_of(no_event));
    const Truth landed = no_event && lands;
    mark(state_.landed, bits_of(landed));
    all_move_on_ = bits_of(occupied_ && !no_event) == 0;
    count_strobe(no_event && strobed);
    const auto pass = [this, &no_event](LaneRow& row, const Real& after, const Real& before) {
      store(row, select(no_event, after, before));
    };
    const Truth strobed_here = no_event && strobed;
    pass(state_.steps_since_strobe, select(strobed_here, Real(0.0), steps_since), load(state_.steps_since_strobe));
    pass(state_.steps, load(state_.steps) + Real(1.0), load(state_.steps));
    if (may_land && bits_of(landed) != 0) {
      pass(state_.tilt, select(landed, Real(0.0), end_.tilt), m_.tilt[0]);
      pass(state_.tilt_rate, select(landed, rebound_, end_.tilt_rate), m_.tilt_rate[0]);
      const Real amplitude = load(state_.amplitude);
      store(state_.amplitude, select(landed, -amplitude, amplitude));
      const Real peak = load(state_.peak_tilt_rate);
      store(state_.peak_tilt_rate, select(landed, dynamics::peaks::larger(peak, magnitude(rebound_)), peak));
    } else {
      pass(state_.tilt, end_.tilt, m_.tilt[0]);
      pass(state_.tilt_rate, end_.tilt_rate, m_.tilt_rate[0]);
    }
    if constexpr (slips) {
      pass(state_.slip, end_.slip, m_.slip[0]);
      pass(state_.slip_rate, end_.slip_rate, m_.slip_rate[0]);
    }
    pass(state_.time, time, time_);
    pass(state_.period, select(wraps, from + Real(1.0), from), period_);
    if constexpr (on_grid) this->pass_interval(no_event);
    if constexpr (Shaking::has_knots) {
      this->pass_knots(bits_of(occupied_ && no_event), bits_of(no_event && ends_at_break));
    }
  }

  void count_strobe(const Truth& strobed) {
    using base::select;
    if (bits_of(strobed) == 0) return;
    const Real one(1.0);
    store(state_.strobe_period, select(strobed, load(state_.strobe_period) + one, load(state_.strobe_period)));
    store(state_.strobes_left, select(strobed, load(state_.strobes_left) - one, load(state_.strobes_left)));
  }

  void store_end() {
    store(state_.duration, duration_);
    store(state_.end_tilt, end_.tilt);
    store(state_.end_tilt_rate, end_.tilt_rate);
    if constexpr (slips) {
      store(state_.end_slip, end_.slip);
      store(state_.end_slip_rate, end_.slip_rate);
    }
    for (std::uint32_t& fired : state_.fired) mark(fired, 0);
    std::size_t i = 0;
    this->for_each_guard([&](const auto& row, auto) {
      mark(state_.fired[static_cast<std::size_t>(row.guard)], bits_of(this->is_first(i++)));
    });
  }

  bool all_move_on_;  ///< no occupied lane has an event
};

}  // namespace
}  // namespace rocking::lanes
