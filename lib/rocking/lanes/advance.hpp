#pragma once

#include <cstddef>
#include <cstdint>

#include "rocking/lanes/quiet_step.hpp"

namespace rocking::lanes {
namespace {

/// Computes the coming step of the lanes from `first` on, stage by stage. A lane moves on if its step has no event but
/// an impact of Rebounds, no breakpoint that is not passed here, and at most one strobe instant, which is not the last.
/// The other lanes stay, and the lane state says what was found: which guards fire, when, and the state then. Their
/// motions do the rest.
template <class Form>
class Advance {
  using Real = typename Form::Real;
  using Truth = typename Form::Truth;

 public:
  Advance(LaneState& state, std::size_t first) : lanes_{state, first} {}

  void begin() { begin_step(lanes_, step_); }
  void expand() { expand_step(lanes_, step_); }
  void look() { find_uncleared(lanes_, step_, guards_); }
  /// Moves the lanes on if nothing happens in any of them.
  void pass() {
    if constexpr (!Form::Shaking::has_knots) quiet_end_ = pass_quiet_step(lanes_, step_, guards_);
  }
  /// The lanes have moved on and can make a further step at once.
  [[nodiscard]] bool can_go_on() const { return quiet_end_ == QuietStepEnd::to_next_step; }
  [[nodiscard]] const UnclearedGuards<Form>& uncleared() const { return guards_; }
  void ask(SearchOf<Form>& search) { lanes::ask(lanes_, step_, guards_, search, places_); }

  /// Says in the lane state what has become of the lanes.
  void finish(const SearchOf<Form>& search) {
    if (quiet_end_ == QuietStepEnd::none) {
      finish_step(search);
    } else {
      mark_passed();
    }
  }

 private:
  [[gnu::noinline]] void finish_step(const SearchOf<Form>& search) {
    LaneState& state = lanes_.state;
    Ending<Form> end;
    find_crossings<Form>(step_.length, guards_, search, places_, end.crossings);
    lanes_.mark(state.held, bits_of(end.crossings.waits));
    end.point = point<Form>(step_.m, end.crossings.duration);
    const Real resolution = lanes_.load(state.resolution);
    end.steps_since_strobe = lanes_.load(state.steps_since_strobe) + Real(1.0);
    end.strobing = strobing_before(lanes_, step_, end.crossings.duration - resolution);
    Truth fits = find_fitting(end);
    count_isolations(end.crossings, fits);
    const Truth strobed = fits && end.strobing.strobes;
    const Truth at_last_strobe = strobed && end.strobing.is_last;
    lanes_.mark(state.strobed, bits_of(strobed));
    lanes_.mark(state.alone, bits_of(!fits));
    lanes_.mark(state.at_last_strobe, bits_of(at_last_strobe));
    note_peaks(lanes_, step_, finish_of(lanes_, end, at_last_strobe), fits && !end.crossings.waits);
    fits = fits && !at_last_strobe;
    Rebounds<Form> rebounds{.lands = end.crossings.of[0], .tilt_rate = Real(0.0)};
    if (Form::may_land && bits_of(rebounds.lands) != 0) {
      rebounds = find_rebounds(lanes_, step_, end.crossings, end.point.tilt_rate, fits);
    }
    const Movable<Form> movable{fits && !end.crossings.crosses, rebounds, strobed};
    Truth moved;
    if constexpr (Form::has_tangents) {
      moved = move_with_tangents(end, movable);
    } else {
      moved = move_on(lanes_, step_, end, movable);
    }
    if (bits_of(guards_.occupied && !moved) != 0) store_end(lanes_, step_, end);
  }

  void mark_passed() const {
    LaneState& state = lanes_.state;
    lanes_.mark(state.no_event, bits_of(guards_.occupied));
    const bool has_unknown = quiet_end_ == QuietStepEnd::to_unknown_interval;
    lanes_.mark(state.at_breakpoint, has_unknown ? lanes_at_unknown_interval(lanes_, guards_.occupied) : 0);
    for (std::uint32_t* none : {&state.landed, &state.held, &state.strobed}) lanes_.mark(*none, 0);
  }

  /// The vectors are computed first, because the kinetic friction of the step is then still known.
  Truth move_with_tangents(const Ending<Form>& end, const Movable<Form>& movable) const {
    const TangentStep<Form> tangents(lanes_, step_);
    const Real duration = end.crossings.duration;
    TangentRows& rows = *lanes_.state.tangents;
    if (bits_of(movable.strobed) != 0) {
      store_vectors(lanes_, rows.at_strobe, tangents.at(end.strobing.time(lanes_.load(lanes_.state.resolution))));
    }
    const auto after = tangents.at(duration);
    const Truth moved = move_on(lanes_, step_, end, movable);
    move_vectors(MovingLanes<Real>{lanes_, moved}, tangents, after);
    if (bits_of(guards_.occupied && !moved) != 0) {
      store_vectors(lanes_, rows.at_end, after);
      store_end_of_base(lanes_, step_, duration);
    }
    return moved;
  }

  /// Lanes whose step the motion alone would compute in the same way, and at whose end it needs nothing else. Stores the
  /// state at their strobe instants.
  [[nodiscard]] Truth find_fitting(const Ending<Form>& end) const {
    LaneState& state = lanes_.state;
    const Real resolution = lanes_.load(state.resolution);
    Truth fits = !end.crossings.undecided && step_.presses && is_finite<Form>(end.point) &&
                 is_ordinary(step_, resolution, end.steps_since_strobe) && end.strobing.is_simple;
    lanes_.mark(state.at_breakpoint, 0);
    if constexpr (Form::Shaking::has_knots && Form::tests_friction) {
      const Truth unsure = may_slip_at_breakpoint(lanes_, step_);
      lanes_.mark(state.at_breakpoint, bits_of(unsure));
      fits = fits && !unsure;
    }
    if (bits_of(fits && end.strobing.strobes) != 0) {
      fits = fits && (store_strobe(lanes_, step_, end.strobing.time(resolution)) || !end.strobing.strobes);
    }
    return fits;
  }

  void count_isolations(const Crossings<Form>& crossings, const Truth& fits) const {
    using base::select;
    if (bits_of(guards_.any) == 0) return;
    const Real before = lanes_.load(lanes_.state.root_isolations);
    lanes_.store(lanes_.state.root_isolations, select(fits, before + crossings.isolations, before));
  }

  LaneAccess<Real> lanes_;
  Step<Form> step_;
  UnclearedGuards<Form> guards_;
  SearchPlaces<Form> places_;
  QuietStepEnd quiet_end_ = QuietStepEnd::none;
};

}  // namespace
}  // namespace rocking::lanes
