#pragma once

#include <cstddef>
#include <type_traits>

#include "rocking/dynamics/guards.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/integrate/step_length.hpp"
#include "rocking/integrate/zero_crossing.hpp"
#include "rocking/lanes/lane_access.hpp"
#include "rocking/lanes/ordinary_guards.hpp"

namespace rocking::lanes {
namespace {

using dynamics::Count;
using dynamics::MotionSeries;

/// The coming step of the lanes: its series, length and guards.
///
/// The expressions are those of dynamics::BlockMotion and integrate::step, in the same order, so that a lane computes
/// the bits that the motion would compute alone.
template <Kind kind, class Shaking, class Real>
class Step : public LaneAccess<kind, Shaking, Real> {
  using Access = LaneAccess<kind, Shaking, Real>;

 protected:
  using Access::state_, Access::load, Access::order, Access::slips;
  using Guards = OrdinaryGuards<kind, Shaking, Real>;
  static constexpr std::size_t guards = Guards::count;

 public:
  using Access::Access;

  /// The state of the base and the block at the start.
  [[gnu::noinline]] void begin() {
    time_ = load(state_.time);
    period_ = load(state_.period);
    period_length_ = load(state_.period_length);
    dynamics::Piece<Shaking, Real> piece;
    for (std::size_t i = 0; i < Shaking::piece_numbers; ++i) piece[i] = load(state_.piece[i]);
    Shaking::template expand<order_of(kind)>(m_, piece, load(state_.amplitude), moment());
    m_.tilt[0] = load(state_.tilt);
    m_.tilt_rate[0] = load(state_.tilt_rate);
    dynamics::begin_angle(m_, this->constants());
  }

  /// The series from there, and the length of the step.
  [[gnu::noinline, gnu::flatten]] void expand() {
    using base::smaller;
    if constexpr (slips) {
      m_.slip_rate[0] = load(state_.slip_rate);
      m_.slip[0] = load(state_.slip);
      dynamics::expand_rock_slide<order_of(kind), Shaking::has_vertical>(
          m_, this->constants(),
          {.drag = load(state_.slip_sign) * this->kinetic_friction(), .first_rate_gate = Real(1.0)});
      length_ = smaller(length_of(m_.slip_rate), length_of(m_.tilt_rate));
    } else {
      dynamics::expand_rock<order_of(kind), Shaking::has_vertical>(m_, this->constants(), Real(1.0));
      length_ = length_of(m_.tilt_rate);
    }
    reach_ = until(load(state_.break_period), load(state_.break_time));
    if constexpr (Access::is_brief) {
      fits_ = base::at_most(reach_, length_);
      if constexpr (!Access::on_grid) {
        fits_ = fits_ && base::at_most(reach_, Real(dynamics::brief_step) * period_length_);
      }
      length_ = reach_;
    } else {
      fits_ = Real(dynamics::brief_step) * period_length_ < reach_;
      length_ = smaller(period_length_, smaller(reach_, length_));
    }
    if constexpr (Access::knows_reach) {
      out_of_reach_ = dynamics::out_of_reach<Real>({.tilt = m_.tilt[0],
                                                    .tilt_rate = m_.tilt_rate[0],
                                                    .base_amplitude = load(state_.amplitude),
                                                    .length = length_},
                                                   this->constants());
      presses_ = out_of_reach_.normal;
      // Without a friction guard, the series of N is needed by its own guard only.
      if (!Access::tests_friction && bits_of(!presses_) == 0) return;
    }
    if constexpr (!slips) dynamics::expand_normal<order_of(kind), Shaking::has_vertical>(m_);
    presses_ = Real(0.0) < m_.normal[0];
  }

 protected:
  [[nodiscard]] Real until(const Real& period, const Real& time) const { return moment().until(period, time); }

  template <class Visitor>
  void for_each_guard(Visitor&& visit) const {
    dynamics::for_each_rocking_guard(m_, Guards(state_, *this, m_, out_of_reach_), Count<order>{}, visit);
  }

  /// Lower bound of the guard's polynomial over the step, without its first coefficient where that is known to be 0;
  /// computed as in integrate::is_clearly_positive.
  template <std::size_t count, class Zero, class Coefficient>
  [[nodiscard]] Real bound(Count<count>, const Zero& starts_at_zero, Coefficient coefficient) const {
    using base::fused, base::select;
    Real rest(0.0);
#pragma GCC unroll 20
    for (std::size_t k = count - 1; k > 1; --k) rest = integrate::bound_below(rest, coefficient(k), length_);
    const Real second = coefficient(1);
    const Real whole = fused(integrate::bound_below(rest, second, length_), length_, coefficient(0));
    if constexpr (std::is_same_v<Zero, NeverZero>) {
      return whole;
    } else {
      return select(starts_at_zero, fused(rest, length_, second), whole);
    }
  }

  /// Whether the motion alone would compute this step with the same order and length, and end it later than it begins.
  [[nodiscard]] TruthOf<Real> is_ordinary(const Real& resolution, const Real& steps_since) const {
    return fits_ && Real(dynamics::least_step) * resolution < length_ && time_ < time_ + length_ &&
           steps_since < Real(static_cast<double>(dynamics::step_budget) + 0.5);
  }

  MotionSeries<Real> m_;
  Real time_;
  Real period_;
  Real period_length_;
  Real reach_;  ///< time to the next breakpoint
  Real length_;
  TruthOf<Real> fits_;                                ///< the order suffices for the step
  TruthOf<Real> presses_;                             ///< N > 0; otherwise other guards would be armed
  dynamics::OutOfReach<TruthOf<Real>> out_of_reach_;  ///< without slip

 private:
  [[nodiscard]] Real length_of(const typename MotionSeries<Real>::Row& row) const {
    return integrate::step_length(row[order - 1], row[order], static_cast<int>(order), load(state_.largest));
  }

  [[nodiscard]] dynamics::Moment<Real> moment() const {
    return {.period = period_, .time = time_, .period_length = period_length_, .frequency = load(state_.frequency)};
  }
};

}  // namespace
}  // namespace rocking::lanes
