#pragma once

#include <cstddef>
#include <cstdint>

#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/sticking_impulse.hpp"
#include "rocking/lanes/losses.hpp"

namespace rocking::lanes {
namespace {

/// Does the coming step of every lane. Where nothing happens in it (no guard loses its sign, no breakpoint but at the end of a
/// brief step, at most one strobe point, not the last), or only an impact that sticks, the lane is moved on. The
/// other lanes are left where they were, with what was found out: which guards fire, when, and the state then. What follows from
/// it is left to each lane's motion.
template <Kind kind, class Shaking, class Real>
class Advance : Losses<kind, Shaking, Real> {
  using Base = Losses<kind, Shaking, Real>;
  using Base::b_, Base::duration_, Base::end_, Base::in_doubt_, Base::is_brief, Base::on_grid, Base::passes_breakpoints,
      Base::isolations_, Base::load, Base::losses_, Base::lost_, Base::m_, Base::mark, Base::occupied_, Base::period_,
      Base::period_length_, Base::presses_, Base::reach_, Base::slips, Base::store, Base::time_, Base::unclear_;
  using typename Base::Strobing, typename Base::Truth;

 public:
  using Base::Base;

  using Base::ask, Base::begin, Base::doubtful, Base::expand, Base::has_others, Base::look;
  using typename Base::Search;

  [[gnu::noinline]] void finish(const Search& search) {
    using base::select;
    this->find_losses(search);
    const Real resolution = load(b_.resolution);
    const Real steps_since = load(b_.steps_since_strobe) + Real(1.0);
    const Strobing strobing = this->strobing(duration_ - resolution);
    Truth fits = !unclear_ && presses_ && this->is_finite(end_) && this->is_ordinary(resolution, steps_since) &&
                 strobing.is_simple;
    mark(b_.at_breakpoint, 0);
    if constexpr (Shaking::has_knots && lanes::tests_friction(kind)) {
      const Truth unsure = slips_at_breakpoint();
      mark(b_.at_breakpoint, bits_of(unsure));
      fits = fits && !unsure;
    }
    if (bits_of(fits && strobing.strobes) != 0) {
      fits = fits && (this->store_strobe(strobing, resolution) || !strobing.strobes);
    }
    const Truth strobed = fits && strobing.strobes;
    mark(b_.strobed, bits_of(strobed));
    mark(b_.alone, bits_of(!fits));
    if (bits_of(in_doubt_) != 0) {
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
  static constexpr bool may_land = !slips && Shaking::bounds_acceleration && !Shaking::has_vertical;

  /// The lanes whose step begins at a breakpoint that was passed here, and that may not stick there: whether they do is the motion's
  /// to say. To the bit as dynamics::Automaton::friction_holds.
  [[nodiscard]] Truth slips_at_breakpoint() const {
    const Real mu_s = load(b_.static_friction);
    const Real most = mu_s * m_.normal[0];
    const Real friction = Real(4.0 / 3.0) * m_.base[0] - m_.rate_cosine[1];
    const Truth holds = presses_ && base::at_most(base::magnitude(friction), most);
    return occupied_ && load(b_.fresh) == Real(1.0) && !holds;
  }

  /// The lanes in which a block comes down at the end of the step and may rock on over the other edge at once: an impact that
  /// sticks is all that happens, and no chatter ends with it. As dynamics::Automaton::land says it.
  Truth find_rebounds(const Truth& fits) {
    rebound_ = -dynamics::sticking_rate<Real>({end_.tilt_rate, Real(0.0)}, load(b_.impact_loss), load(b_.cosine));
    Truth lands = fits && this->is_first(0) && time_ < time_ + duration_ && end_.tilt_rate < Real(0.0) &&
                  load(b_.least_rebound) < rebound_;
    for (std::size_t i = 1; i < Base::guards; ++i) lands = lands && !this->is_first(i);
    if constexpr (lanes::tests_friction(kind)) lands = lands && sticks();
    return lands;
  }

  /// Whether friction holds the block in such an impact and after it; false where it is close. There the motion decides, so that
  /// the last bit of what is computed here has no say.
  [[nodiscard]] Truth sticks() const {
    using base::fused;
    const Real closest = Real(0.99) * load(b_.static_friction);
    const base::SinCos<Real> edge{load(b_.sine), load(b_.cosine)};
    const auto impulse = dynamics::sticking_impulse<Real>(
        {end_.tilt_rate, Real(0.0)},
        {.restitution = load(b_.restitution), .loss = load(b_.impact_loss), .sine = edge.sine, .cosine = edge.cosine});
    Real base = m_.base[Base::order];
#pragma GCC unroll 20
    for (std::size_t k = Base::order; k > 0; --k) base = fused(base, duration_, m_.base[k - 1]);
    // In the frame of the other side.
    const auto forces =
        dynamics::forces_without_slip<Real>({.edge = edge, .omega = rebound_, .beta = -base, .weight = Real(1.0)});
    return base::at_most(base::magnitude(impulse.horizontal), closest * impulse.vertical) &&
           Real(0.0) < forces.normal && dynamics::friction_is_enough(forces, closest);
  }

  /// Moves on the lanes that are `calm` or land, but for those that come to where the equations or the period end.
  void move(const Truth& calm, const Truth& lands, const Truth& strobed, const Real& steps_since) {
    using base::select;
    Truth ends_at_break = !(duration_ < reach_ - load(b_.resolution));
    if constexpr (on_grid) ends_at_break = calm;
    Real later = time_ + duration_;
    Real from = period_;
    if constexpr (passes_breakpoints) {
      later = select(ends_at_break, load(b_.break_time), later);
      from = select(ends_at_break, load(b_.break_period), from);
    }
    const Truth wraps = !(later < period_length_);
    const Real time = select(wraps, later - period_length_, later);
    Truth quiet = (may_land ? calm || lands : calm) && time < period_length_;
    if constexpr (!passes_breakpoints) quiet = quiet && !ends_at_break;
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
    if constexpr (on_grid) pass_interval(quiet);
    if constexpr (Shaking::has_knots) pass_knots(bits_of(occupied_ && quiet), bits_of(quiet && ends_at_break));
  }

  /// Of the lanes that were moved on, those that came to a breakpoint go on with the piece that begins there. Where another than the
  /// base motion's is reached too, the motion goes on.
  void pass_knots(std::uint32_t moved, std::uint32_t arrived) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(Row<Real>::lanes); ++i) {
      const std::size_t lane = Base::first_ + i;
      if ((moved >> i & 1U) == 0) continue;
      const bool at_break = (arrived >> i & 1U) != 0;
      b_.fresh[lane] = at_break ? 1.0 : 0.0;
      if (at_break) pass_knot(lane);
    }
  }

  void pass_knot(std::size_t lane) {
    b_.breakpoints[lane] += 1.0;
    const dynamics::Moment<double> now{.period = b_.period[lane],
                                       .time = b_.time[lane],
                                       .period_length = b_.period_length[lane],
                                       .frequency = b_.frequency[lane]};
    const dynamics::Knot* knot = Shaking::template follow<Real>(b_.knot[lane], now, b_.resolution[lane]);
    b_.knot[lane] = knot;
    const auto piece = Shaking::template piece_from<Real>(knot, b_.piece[Shaking::piece_numbers - 1][lane]);
    for (std::size_t i = 0; i < Shaking::piece_numbers; ++i) b_.piece[i][lane] = piece[i];
    const double other_period = b_.other_break_period[lane];
    const double other_time = b_.other_break_time[lane];
    const double until_other = now.until(other_period, other_time);
    if (until_other <= b_.resolution[lane]) b_.at_breakpoint |= 1U << lane;
    const auto knot_period = static_cast<double>(knot[1].instant.period);
    const bool other_first = until_other < now.until(knot_period, knot[1].instant.time);
    b_.break_period[lane] = other_first ? other_period : knot_period;
    b_.break_time[lane] = other_first ? other_time : knot[1].instant.time;
  }

  /// The breakpoint at the end of a brief step is a boundary of the friction grid, if it is known what comes after it.
  void pass_interval(const Truth& quiet) {
    using base::select;
    const Real known = load(b_.intervals.known);
    mark(b_.at_breakpoint, bits_of(quiet && known == Real(0.0)));
    store(b_.intervals.known, known - Real(1.0));
    for (std::size_t lane = Base::first_; lane < Base::first_ + Row<Real>::lanes; ++lane) {
      b_.intervals.present[lane] =
          (b_.intervals.present[lane] + 1) % static_cast<std::int64_t>(dynamics::most_foreseen);
    }
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
    this->for_each_guard([&](Guard guard, const auto&, auto, const auto&, auto) {
      mark(b_.fired[static_cast<std::size_t>(guard)], bits_of(this->is_first(i++)));
    });
  }

  Real rebound_;      ///< tilt rate after an impact, in the frame of the other side
  bool stays_quiet_;  ///< nothing happens in any lane
};

}  // namespace
}  // namespace rocking::lanes
