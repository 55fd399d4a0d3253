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
template <Kind kind, class Real>
class Advance : Losses<kind, Real> {
  using Base = Losses<kind, Real>;
  using Base::b_, Base::duration_, Base::end_, Base::in_doubt_, Base::is_brief, Base::isolations_, Base::load,
      Base::losses_, Base::lost_, Base::m_, Base::mark, Base::occupied_, Base::period_, Base::period_length_,
      Base::presses_, Base::reach_, Base::slips, Base::store, Base::time_, Base::unclear_;
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
  static constexpr bool may_land = !slips;

  /// The lanes in which a block comes down at the end of the step and may rock on over the other edge at once: an impact that
  /// sticks is all that happens, and no chatter ends with it. As dynamics::Automaton::land says it.
  Truth find_rebounds(const Truth& fits) {
    rebound_ = -dynamics::sticking_rate<Real>({end_.tilt_rate, Real(0.0)}, load(b_.impact_loss), load(b_.cosine));
    Truth lands = fits && this->is_first(0) && time_ < time_ + duration_ && end_.tilt_rate < Real(0.0) &&
                  load(b_.least_rebound) < rebound_;
    for (std::size_t i = 1; i < Base::guards; ++i) lands = lands && !this->is_first(i);
    if constexpr (kind == Kind::rock_with_friction) lands = lands && sticks();
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
