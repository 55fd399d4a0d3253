#pragma once

#include <array>
#include <bit>

#include "rocking/lanes/sign_losses.hpp"
#include "rocking/lanes/step.hpp"

namespace rocking::lanes {
namespace {

/// Does the coming step of every lane. Where nothing happens in it (no guard loses its sign, no breakpoint but at the end of a
/// brief step, at most one strobe point, not the last) the lane is moved on. The other lanes are left where they were, with what
/// was found out: which guards lose their sign, when, and the state at the first such instant. What follows from it is left to
/// each lane's motion.
template <Kind kind, class Real>
class Advance : Step<kind, Real> {
  using Base = Step<kind, Real>;
  using Base::b_, Base::first_, Base::is_brief, Base::load, Base::store, Base::mark, Base::length_, Base::m_,
      Base::period_, Base::period_length_, Base::presses_, Base::reach_, Base::slips, Base::time_;
  using typename Base::Point, typename Base::Strobing;
  using Truth = TruthOf<Real>;

 public:
  using Base::Base;

  using Base::begin, Base::expand;

  /// Which guards may lose their sign in the step, and the state at its end if none does.
  [[gnu::noinline]] void look() {
    occupied_ = load(b_.occupied) == Real(1.0);
    doubts_ = guards_in_doubt();
    end_ = this->point(length_);
  }

  [[gnu::noinline]] void finish() {
    using base::select;
    find_losses();
    const Real resolution = load(b_.resolution);
    const Real steps_since = load(b_.steps_since_strobe) + Real(1.0);
    const Strobing strobing = this->strobing(duration_ - resolution);
    Truth fits = !unclear_ && presses_ && this->is_finite(end_) && this->is_ordinary(resolution, steps_since) &&
                 strobing.is_simple;
    if (bits_of(fits && strobing.strobes) != 0) {
      fits = fits && (this->store_strobe(strobing, resolution) || !strobing.strobes);
    }
    const Truth strobed = fits && strobing.strobes;
    mark(b_.strobed, bits_of(strobed));
    mark(b_.alone, bits_of(!fits));
    if (in_doubt_ != 0) {
      const Real before = load(b_.root_isolations);
      store(b_.root_isolations, select(fits, before + isolations_, before));
    }
    const Truth at_last_strobe = strobed && strobing.is_last;
    mark(b_.at_last_strobe, bits_of(at_last_strobe));
    fits = fits && !at_last_strobe;
    Truth lands = losses_[0];
    if (may_land && bits_of(lands) != 0) lands = find_rebounds(fits);
    move(fits && !lost_, lands, strobed, steps_since);
    if (!stays_quiet_) store_end();
  }

 private:
  static constexpr bool may_land = kind == Kind::rock;  ///< friction has a say in other impacts

  /// The search for roots takes as long for one lane as for all: a few lanes that ask for it had better wait for each other. Not
  /// on the friction grid, where hardly any step asks for it and they would wait long.
  static constexpr int fewest_in_doubt = is_brief ? 1 : (3 * Row<Real>::lanes + 7) / 8;

  void find_losses() {
    duration_ = length_;
    isolations_ = Real(0.0);
    unclear_ = lost_ = Real(0.0) < Real(0.0);
    Truth any = doubts_[0];
    for (const Truth& doubt : doubts_) any = any || doubt;
    in_doubt_ = bits_of(any);
    const bool has_others = (bits_of(occupied_) & ~in_doubt_) != 0;
    const bool waits = has_others && std::popcount(in_doubt_) < fewest_in_doubt;
    mark(b_.held, waits ? in_doubt_ : 0);
    if (waits) lost_ = any;
    losses_.fill(Real(0.0) < Real(0.0));
    if (in_doubt_ == 0 || waits) return;
    while (look_for_roots()) continue;
    end_ = this->point(duration_);
  }

  /// For each guard the lanes in which a cheap bound does not clear it.
  [[nodiscard]] std::array<Truth, Base::guards> guards_in_doubt() const {
    std::array<Truth, Base::guards> doubts;
    std::size_t i = 0;
    this->for_each_guard(
        [&](Guard, const auto& out_of_reach, auto count, const auto& starts_at_zero, auto coefficient) {
          Truth& doubt = doubts[i++];
          doubt = is_in_reach(out_of_reach);
          if (bits_of(doubt) == 0) return;
          doubt = doubt && !(Real(0.0) < this->bound(count, starts_at_zero, coefficient));
        });
    return doubts;
  }

  [[nodiscard]] Truth is_in_reach(const InReach&) const { return occupied_; }
  [[nodiscard]] Truth is_in_reach(const Truth& out_of_reach) const { return occupied_ && !out_of_reach; }

  /// In each lane with a guard in doubt, looks for the root of the first such, which is in doubt no longer. False if there is
  /// none.
  [[nodiscard]] bool look_for_roots() {
    using base::select;
    constexpr std::size_t count = Base::order + 2;
    static_assert(count % 2 == 0);
    Real c[count];
    for (Real& coefficient : c) coefficient = Real(0.0);
    std::array<Truth, Base::guards> looked_at;
    Truth taken = Real(0.0) < Real(0.0);
    std::size_t i = 0;
    this->for_each_guard([&](Guard, const auto&, auto own_count, const auto& starts_at_zero, auto coefficient) {
      looked_at[i] = doubts_[i] && !taken;
      doubts_[i] = doubts_[i] && taken;
      taken = taken || looked_at[i];
      copy(looked_at[i], own_count, starts_at_zero, coefficient, c);
      ++i;
    });
    if (bits_of(taken) == 0) return false;
    const Real square = length_ * length_;
    Real even(1.0);
    Real odd = length_;
#pragma GCC unroll 20
    for (std::size_t k = 0; k < count; k += 2) {  // as integrate::scale_to_unit says it
      c[k] = c[k] * even;
      c[k + 1] = c[k + 1] * odd;
      even = even * square;
      odd = odd * square;
    }
    isolations_ = isolations_ + select(taken, Real(1.0), Real(0.0));
    SignLosses<Real> found;
    first_sign_losses<count>(c, taken, found);
    unclear_ = unclear_ || found.unclear;
    lost_ = lost_ || found.lost;
    const Real instant = found.instant * length_;
    duration_ = select(found.lost && instant < duration_, instant, duration_);
    for (i = 0; i < Base::guards; ++i) {
      const Truth lost = found.lost && looked_at[i];
      instants_[i] = select(lost, instant, instants_[i]);
      losses_[i] = losses_[i] || lost;
    }
    return true;
  }

  /// A guard's coefficients, without the first where that is known to be 0, to c in the lanes where it is looked at.
  template <std::size_t count, class Zero, class Coefficient>
  static void copy(const Truth& looked_at, Count<count>, const Zero& starts_at_zero, Coefficient coefficient, Real* c) {
    using base::select;
    if (bits_of(looked_at) == 0) return;
    if constexpr (std::is_same_v<Zero, NeverZero>) {
#pragma GCC unroll 20
      for (std::size_t k = 0; k < count; ++k) c[k] = select(looked_at, coefficient(k), c[k]);
    } else {
      const Truth shifted = looked_at && starts_at_zero;
      const Truth whole = looked_at && !starts_at_zero;
#pragma GCC unroll 20
      for (std::size_t k = 0; k + 1 < count; ++k) {
        c[k] = select(whole, coefficient(k), select(shifted, coefficient(k + 1), c[k]));
      }
      c[count - 1] = select(whole, coefficient(count - 1), c[count - 1]);
    }
  }

  /// The lanes in which a block comes down at the end of the step and may rock on over the other edge at once: an impact is all
  /// that happens, and no chatter ends with it. As dynamics::Automaton::land says it.
  Truth find_rebounds(const Truth& fits) {
    rebound_ = load(b_.impact_loss) * end_.tilt_rate - end_.tilt_rate;
    Truth lands = fits && losses_[0] && time_ < time_ + duration_ && end_.tilt_rate < Real(0.0) &&
                  load(b_.least_rebound) < rebound_;
    for (std::size_t i = 1; i < Base::guards; ++i) lands = lands && !losses_[i];
    return lands;
  }

  /// Moves on the lanes that are `calm` or land, but for those that come to where the equations or the period end.
  void move(const Truth& calm, const Truth& lands, const Truth& strobed, const Real& steps_since) {
    using base::select;
    // A brief step that is quiet ends at its breakpoint.
    const Real later = is_brief ? load(b_.break_time) : time_ + duration_;
    const Real from = is_brief ? load(b_.break_period) : period_;
    const Truth wraps = !(later < period_length_);
    const Real time = select(wraps, later - period_length_, later);
    Truth quiet = (may_land ? calm || lands : calm) && time < period_length_;
    if constexpr (!is_brief) quiet = quiet && duration_ < reach_ - load(b_.resolution);
    mark(b_.quiet, bits_of(quiet));
    const Truth landed = quiet && lands;
    mark(b_.landed, bits_of(landed));
    stays_quiet_ = bits_of(occupied_ && !quiet) == 0;
    count_strobe(quiet && strobed);
    const auto pass = [this, &quiet](LaneRow& row, const Real& after, const Real& before) {
      store(row, select(quiet, after, before));
    };
    const Truth strobed_here = quiet && strobed;
    pass(b_.steps_since_strobe, select(strobed_here, Real(0.0), steps_since), load(b_.steps_since_strobe));
    pass(b_.steps, load(b_.steps) + Real(1.0), load(b_.steps));
    if (may_land && bits_of(landed) != 0) {
      pass(b_.tilt, select(landed, Real(0.0), end_.tilt), m_.tilt[0]);
      pass(b_.tilt_rate, select(landed, rebound_, end_.tilt_rate), m_.tilt_rate[0]);
      const Real amplitude = load(b_.amplitude);
      store(b_.amplitude, select(landed, -amplitude, amplitude));
    } else {
      pass(b_.tilt, end_.tilt, m_.tilt[0]);
      pass(b_.tilt_rate, end_.tilt_rate, m_.tilt_rate[0]);
    }
    if constexpr (slips) {
      pass(b_.slip, end_.slip, m_.slip[0]);
      pass(b_.slip_rate, end_.slip_rate, m_.slip_rate[0]);
    }
    pass(b_.time, time, time_);
    pass(b_.period, select(wraps, from + Real(1.0), from), period_);
    mark(b_.at_a_loss, 0);
    if constexpr (is_brief) pass_interval(quiet);
  }

  /// The breakpoint at the end of a brief step is a boundary of the friction grid, if it is known what comes after it.
  void pass_interval(const Truth& quiet) {
    using base::select;
    const Real known = load(b_.intervals.known);
    mark(b_.at_a_loss, bits_of(quiet && known == Real(0.0)));
    store(b_.intervals.known, known - Real(1.0));
    const Real per_period = load(b_.intervals.per_period);
    const Real next = load(b_.intervals.next_boundary) + Real(1.0);
    const Truth wraps = next == per_period;
    const Real boundary = select(wraps, Real(0.0), next);
    const Real period = load(b_.break_period);
    store(b_.intervals.next_boundary, boundary);
    // dynamics::grid_boundary
    store(b_.break_time,
          select(quiet, load(b_.intervals.grid_start) + boundary * period_length_ / per_period, load(b_.break_time)));
    store(b_.break_period, select(quiet && wraps, period + Real(1.0), period));
  }

  void count_strobe(const Truth& strobed) {
    using base::select;
    if (bits_of(strobed) == 0) return;
    const Real one(1.0);
    store(b_.strobe_period, select(strobed, load(b_.strobe_period) + one, load(b_.strobe_period)));
    store(b_.strobes_left, select(strobed, load(b_.strobes_left) - one, load(b_.strobes_left)));
  }

  void store_end() {
    store(b_.duration, duration_);
    store(b_.end_tilt, end_.tilt);
    store(b_.end_tilt_rate, end_.tilt_rate);
    if constexpr (slips) {
      store(b_.end_slip, end_.slip);
      store(b_.end_slip_rate, end_.slip_rate);
    }
    for (std::uint32_t& fired : b_.fired) mark(fired, 0);
    std::size_t i = 0;
    this->for_each_guard([&](Guard guard, const auto&, auto, const auto&, auto) {  // as integrate::earliest says it
      const Truth is_first = losses_[i] && !(duration_ + load(b_.resolution) < instants_[i]);
      mark(b_.fired[static_cast<std::size_t>(guard)], bits_of(is_first));
      ++i;
    });
  }

  Truth occupied_;
  std::array<Truth, Base::guards> doubts_;  ///< for each guard the lanes in which a cheap bound does not clear it
  std::uint32_t in_doubt_;                  ///< lanes with a guard that a cheap bound does not clear
  Real isolations_;                         ///< of roots of such guards
  Real duration_;
  Truth lost_;                               ///< lanes with a guard that loses its sign
  std::array<Truth, Base::guards> losses_;   ///< of each guard
  std::array<Real, Base::guards> instants_;  ///< when
  Real rebound_;                             ///< tilt rate after an impact, in the frame of the other side
  bool stays_quiet_;                         ///< nothing happens in any lane
  Point end_;                                ///< of the step, or where a guard first loses its sign
  Truth unclear_;                            ///< lanes with a guard of which that is not found out here
};

}  // namespace
}  // namespace rocking::lanes
