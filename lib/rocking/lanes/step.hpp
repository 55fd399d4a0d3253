#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/guards.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/integrate/sign_loss.hpp"
#include "rocking/integrate/step_length.hpp"
#include "rocking/lanes/block.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/lanes/pack.hpp"

/// The coming step of all lanes of a block: its series, length and guards. Only for the units that are compiled for an
/// instruction set: what is here and in pack.hpp is each unit's own.
///
/// The expressions are those of dynamics::BlockMotion and integrate::step, in their order, so that a lane gets the bits of a
/// realisation that is advanced alone.
namespace rocking::lanes {
namespace {

using dynamics::Guard;
using dynamics::MotionSeries;

template <class Real>
using TruthOf = decltype(std::declval<Real>() < std::declval<Real>());

using dynamics::Count;

/// In place of the lanes where a first coefficient is known to be 0.
struct NeverZero {};
/// In place of the lanes where a guard is out of reach.
struct InReach {};

/// `Shaking`: the kind of the base motion.
template <Kind kind, class Shaking, class Real>
class Step {
 public:
  /// Of as many lanes as a Real has, from `first` on.
  Step(Block& block, std::size_t first) : b_(block), first_(first) {}

  /// Where the base and the block's edge are.
  [[gnu::noinline]] void begin() {
    using base::select;
    time_ = load(b_.time);
    period_ = load(b_.period);
    period_length_ = load(b_.period_length);
    dynamics::Piece<Shaking, Real> piece;
    for (std::size_t i = 0; i < Shaking::piece_numbers; ++i) piece[i] = load(b_.piece[i]);
    Shaking::template expand<order_of(kind)>(m_, piece, load(b_.amplitude), moment());
    m_.tilt[0] = load(b_.tilt);
    m_.tilt_rate[0] = load(b_.tilt_rate);
    const auto angle = sin_cos_of_edge(load(b_.shape_angle) - m_.tilt[0]);
    const auto starts_flat = m_.tilt[0] == Real(0.0);
    m_.sine[0] = select(starts_flat, load(b_.sine), angle.sine);
    m_.cosine[0] = select(starts_flat, load(b_.cosine), angle.cosine);
  }

  /// The series from there, and how far they reach.
  [[gnu::noinline]] void expand() {
    using base::smaller;
    if constexpr (slips) {
      m_.slip_rate[0] = load(b_.slip_rate);
      m_.slip[0] = load(b_.slip);
      dynamics::expand_rock_slide<order_of(kind), Shaking::has_vertical>(
          m_,
          {.inertia = load(b_.inertia), .drag = load(b_.slip_sign) * kinetic_friction(), .first_rate_gate = Real(1.0)});
      length_ = smaller(length_of(m_.slip_rate), length_of(m_.tilt_rate));
    } else {
      dynamics::expand_rock<order_of(kind), Shaking::has_vertical>(m_, Real(1.0));
      length_ = length_of(m_.tilt_rate);
    }
    reach_ = until(load(b_.break_period), load(b_.break_time));
    if constexpr (is_brief) {
      fits_ = base::at_most(reach_, length_);
      if constexpr (!on_grid) fits_ = fits_ && base::at_most(reach_, Real(dynamics::brief_step) * period_length_);
      length_ = reach_;
    } else {
      fits_ = Real(dynamics::brief_step) * period_length_ < reach_;
      length_ = smaller(period_length_, smaller(reach_, length_));
    }
    if constexpr (knows_reach) {
      out_of_reach_ = dynamics::out_of_reach(m_.tilt[0], m_.tilt_rate[0], load(b_.amplitude), length_,
                                             load(b_.shape_angle), load(b_.sine));
      presses_ = out_of_reach_.normal;
      // Where no friction has to hold the block, N is of use for its guard alone.
      if (!lanes::tests_friction(kind) && bits_of(!presses_) == 0) return;
    }
    if constexpr (!slips) dynamics::expand_normal<order_of(kind), Shaking::has_vertical>(m_);
    presses_ = Real(0.0) < m_.normal[0];
  }

 protected:
  static constexpr bool slips = lanes::slips(kind);
  static constexpr bool is_brief = lanes::is_brief(kind);
  /// Steps end with the intervals of the friction grid, which are known beforehand.
  static constexpr bool on_grid = slips && is_brief && !Shaking::has_knots;
  /// Breakpoints are passed here.
  static constexpr bool passes_breakpoints = on_grid || Shaking::has_knots;
  /// Some guards may be known to be out of reach.
  static constexpr bool knows_reach = !slips && Shaking::bounds_acceleration && !Shaking::has_vertical;
  static constexpr std::size_t order = order_of(kind);

  [[nodiscard]] Real load(const LaneRow& row) const { return Row<Real>::load(row.data() + first_); }
  void store(LaneRow& row, const Real& value) const { Row<Real>::store(value, row.data() + first_); }
  /// Puts the truths of these lanes among those of all.
  void mark(std::uint32_t& truths, std::uint32_t of_these) const {
    truths = (truths & ~(every_lane << first_)) | of_these << first_;
  }
  [[nodiscard]] Real kinetic_friction() const {
    if constexpr (!on_grid) return load(b_.kinetic_friction);
    using base::select, base::smaller;
    const Real wanted = Row<Real>::load_each(&b_.intervals.kinetic_friction[first_], &b_.intervals.present[first_]);
    return smaller(select(wanted < Real(0.0), Real(0.0), wanted), load(b_.static_friction));
  }
  static constexpr std::uint32_t every_lane = (1U << Row<Real>::lanes) - 1U;

  /// base::sin_cos, without the reduction if no lane needs it.
  [[nodiscard]] static base::SinCos<Real> sin_cos_of_edge(const Real& angle) {
    const auto reduced = Real(-base::almost_quarter_pi) < angle && angle < Real(base::almost_quarter_pi);
    return bits_of(!reduced) == 0 ? base::reduced_sin_cos(angle) : base::sin_cos(angle);
  }

  [[nodiscard]] Real length_of(const typename MotionSeries<Real>::Row& row) const {
    return integrate::step_length(row[order - 1], row[order], static_cast<int>(order), load(b_.largest));
  }

  [[nodiscard]] dynamics::Moment<Real> moment() const {
    return {.period = period_, .time = time_, .period_length = period_length_, .frequency = load(b_.frequency)};
  }
  [[nodiscard]] Real until(const Real& period, const Real& time) const { return moment().until(period, time); }

  static constexpr std::size_t guards = slips ? 4 : lanes::tests_friction(kind) ? 5 : 3;

  /// The guards that are armed in an ordinary step, as dynamics::for_each_rocking_guard asks for them. A first coefficient is known
  /// to be 0 where a truth says so.
  class OrdinaryGuards {
   public:
    explicit OrdinaryGuards(const Step& step) : step_(step) {}

    static constexpr bool was_past_balance() { return false; }
    static constexpr bool slips() { return Step::slips; }
    static constexpr bool tests_friction() { return lanes::tests_friction(kind); }
    static constexpr bool determinant_may_vanish() { return false; }
    static constexpr InReach in_reach() { return {}; }
    auto past_balance_out_of_reach() const {
      if constexpr (Step::knows_reach) {
        return step_.out_of_reach_.past_balance;
      } else {
        return InReach{};
      }
    }
    auto normal_out_of_reach() const {
      if constexpr (Step::knows_reach) {
        return step_.out_of_reach_.normal;
      } else {
        return InReach{};
      }
    }
    static constexpr NeverZero no_zeros() { return {}; }
    static constexpr NeverZero normal_zeros() { return {}; }
    static constexpr NeverZero inward_zeros() { return {}; }
    static constexpr NeverZero outward_zeros() { return {}; }
    TruthOf<Real> tilt_zeros() const { return step_.m_.tilt[0] == Real(0.0); }
    TruthOf<Real> slip_zeros() const { return step_.m_.slip_rate[0] == Real(0.0); }
    Real shape_angle() const { return step_.load(step_.b_.shape_angle); }
    Real slip_sign() const { return step_.load(step_.b_.slip_sign); }
    Real static_friction() const { return step_.load(step_.b_.static_friction); }
    Real inertia() const { return step_.load(step_.b_.inertia); }
    static const Real& seen_from_ground(const Real& normal) { return normal; }

   private:
    const Step& step_;
  };

  template <class Visitor>
  void for_each_guard(Visitor&& visit) const {
    dynamics::for_each_rocking_guard(m_, OrdinaryGuards(*this), Count<order>{}, visit);
  }

  /// Below the guard's polynomial over the step, without its first coefficient where that is known to be 0; as
  /// integrate::is_clearly_positive says it.
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

  struct Point {
    Real tilt;
    Real tilt_rate;
    Real slip;
    Real slip_rate;
  };

  /// The state x into the step.
  [[nodiscard]] Point point(const Real& x) const {
    using base::fused;
    Point p;
    p.tilt = m_.tilt[order + 1];
    p.tilt_rate = m_.tilt_rate[order];
    if constexpr (slips) {
      p.slip = m_.slip[order + 1];
      p.slip_rate = m_.slip_rate[order];
    }
#pragma GCC unroll 20
    for (std::size_t k = order; k > 0; --k) {
      p.tilt = fused(p.tilt, x, m_.tilt[k]);
      p.tilt_rate = fused(p.tilt_rate, x, m_.tilt_rate[k - 1]);
      if constexpr (slips) {
        p.slip = fused(p.slip, x, m_.slip[k]);
        p.slip_rate = fused(p.slip_rate, x, m_.slip_rate[k - 1]);
      }
    }
    p.tilt = fused(p.tilt, x, m_.tilt[0]);
    if constexpr (slips) p.slip = fused(p.slip, x, m_.slip[0]);
    return p;
  }

  [[nodiscard]] static auto is_finite(const Point& p) {
    Real sum = p.tilt + p.tilt_rate;  // finite only where all of them are
    if constexpr (slips) sum = sum + (p.slip + p.slip_rate);
    return sum - sum == Real(0.0);
  }

  /// Whether alone the motion would do this step too, from `length` on.
  [[nodiscard]] TruthOf<Real> is_ordinary(const Real& resolution, const Real& steps_since) const {
    return fits_ && Real(dynamics::least_step) * resolution < length_ && time_ < time_ + length_ &&
           steps_since < Real(static_cast<double>(dynamics::step_budget) + 0.5);
  }

  /// The strobe point that the next `end` of time reach, if they do.
  struct Strobing {
    Real instant;
    TruthOf<Real> strobes;
    TruthOf<Real> is_last;    ///< the run ends with it
    TruthOf<Real> is_simple;  ///< no other comes after it
  };

  [[nodiscard]] Strobing strobing(const Real& end) const {
    const Real strobe_period = load(b_.strobe_period);
    const Real strobe_time = load(b_.strobe_time);
    const Real instant = until(strobe_period, strobe_time);
    const auto strobes = instant < end;
    if (bits_of(strobes) == 0) return {instant, strobes, strobes, !strobes};
    const auto is_last = load(b_.strobes_left) < Real(1.5);
    const auto is_only = is_last || !(until(strobe_period + Real(1.0), strobe_time) < end);
    return {instant, strobes, is_last, is_only || !strobes};
  }

  /// The state at the strobe instant, put into the block; true in the lanes where it is finite.
  TruthOf<Real> store_strobe(const Strobing& strobing, const Real& resolution) {
    using base::select;
    const Point p = point(select(resolution < strobing.instant, strobing.instant, Real(0.0)));
    store(b_.strobe_tilt, p.tilt);
    store(b_.strobe_tilt_rate, p.tilt_rate);
    if constexpr (slips) {
      store(b_.strobe_slip, p.slip);
      store(b_.strobe_slip_rate, p.slip_rate);
    }
    return is_finite(p);
  }

  Block& b_;
  std::size_t first_;
  MotionSeries<Real> m_;
  Real time_;
  Real period_;
  Real period_length_;
  Real reach_;  ///< time until the equations change
  Real length_;
  TruthOf<Real> fits_;     ///< whether the order does for the step
  TruthOf<Real> presses_;  ///< on the ground: else the guards are others than are looked at here
  dynamics::OutOfReach<TruthOf<Real>> out_of_reach_;  ///< where it sticks
};

}  // namespace
}  // namespace rocking::lanes
