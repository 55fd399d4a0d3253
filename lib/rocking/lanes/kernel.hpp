#pragma once

#include <limits>
#include <new>

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/guards.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/integrate/sign_loss.hpp"
#include "rocking/integrate/step_length.hpp"
#include "rocking/lanes/block.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/lanes/pack.hpp"

/// One step of all lanes of a block. Only for the units that are compiled for an instruction set: what is here and in
/// pack.hpp is each unit's own.
///
/// The expressions are those of dynamics::BlockMotion and integrate::advance, in their order, so that a lane gets the bits
/// of a realisation that is advanced alone. A lane in which anything happens is left as it was; its series are there.
namespace rocking::lanes {
namespace {

using dynamics::Guard;
using dynamics::MotionSeries;

template <Kind kind, class Real>
class Step {
 public:
  explicit Step(Block& block) : b_(block), m_(*new (block.series.data()) MotionSeries<Real>) {}

  void run() {
    expand();
    bound_guards();
    move();
  }

 private:
  static constexpr bool slips = kind == Kind::rock_slide || kind == Kind::rock_slide_briefly;
  static constexpr std::size_t order = order_of(kind);

  static Real load(const LaneRow& row) { return Row<Real>::load(row.data()); }
  static void store(LaneRow& row, const Real& value) { Row<Real>::store(value, row.data()); }

  void expand() {
    using base::select, base::smaller;
    time_ = load(b_.time);
    period_ = load(b_.period);
    period_length_ = load(b_.period_length);
    const Real frequency = load(b_.frequency);
    dynamics::expand_harmonic<order_of(kind)>(m_.base, load(b_.amplitude), frequency, base::sin_cos(frequency * time_));
    m_.tilt[0] = load(b_.tilt);
    m_.tilt_rate[0] = load(b_.tilt_rate);
    const auto angle = base::sin_cos(load(b_.shape_angle) - m_.tilt[0]);
    starts_flat_ = m_.tilt[0] == Real(0.0);
    m_.sine[0] = select(starts_flat_, load(b_.sine), angle.sine);
    m_.cosine[0] = select(starts_flat_, load(b_.cosine), angle.cosine);
    if constexpr (slips) {
      m_.slip_rate[0] = load(b_.slip_rate);
      m_.slip[0] = load(b_.slip);
      dynamics::expand_rock_slide<order_of(kind), false>(
          m_, {.inertia = load(b_.inertia), .drag = load(b_.drag), .first_rate_gate = Real(1.0)});
      length_ = smaller(length_of(m_.slip_rate), length_of(m_.tilt_rate));
    } else {
      dynamics::expand_rock<order_of(kind), false>(m_, Real(1.0));
      length_ = length_of(m_.tilt_rate);
    }
    reach_ = until(load(b_.break_period), load(b_.break_time));
    if constexpr (kind == Kind::rock_slide_briefly) {
      fits_ = reach_ < length_ || reach_ == length_;
      length_ = reach_;
    } else {
      fits_ = Real(dynamics::brief_step) * period_length_ < reach_;
      length_ = smaller(period_length_, smaller(reach_, length_));
    }
    b_.misfits = ~bits_of(fits_);
    store(b_.length, length_);
  }

  [[nodiscard]] Real length_of(const typename MotionSeries<Real>::Row& row) const {
    return integrate::step_length(row[order - 1], row[order], static_cast<int>(order), load(b_.largest));
  }

  [[nodiscard]] Real until(const Real& period, const Real& time) const {
    return (period - period_) * period_length_ + (time - time_);
  }

  void bound_guards() {
    using base::select;
    const Real zero(0.0);
    clear_ = length_ == length_;
    const Real shape_angle = load(b_.shape_angle);
    keep_clear(Guard::tilt, bound_but_zero<order + 2>(starts_flat_, [&](std::size_t k) { return m_.tilt[k]; }));
    keep_clear(Guard::past_balance,
               bound<0, order + 2>([&](std::size_t k) { return (k == 0 ? shape_angle : zero) - m_.tilt[k]; }));
    keep_clear(Guard::normal, bound<0, order>([&](std::size_t k) { return m_.normal[k]; }));
    if constexpr (slips) {
      const Real sign = load(b_.slip_sign);
      keep_clear(Guard::slip, bound_but_zero<order + 1>(m_.slip_rate[0] == zero,
                                                        [&](std::size_t k) { return sign * m_.slip_rate[k]; }));
    }
    if constexpr (kind == Kind::rock_with_friction) {
      const Real mu_s = load(b_.static_friction);
      const auto friction = [&](std::size_t k) {
        return Real(4.0 / 3.0) * m_.base[k] - Real(static_cast<double>(k + 1)) * m_.rate_cosine[k + 1];
      };
      keep_clear(Guard::friction_inward,
                 bound<0, order>([&](std::size_t k) { return mu_s * m_.normal[k] - friction(k); }));
      keep_clear(Guard::friction_outward,
                 bound<0, order>([&](std::size_t k) { return mu_s * m_.normal[k] + friction(k); }));
    }
  }

  void keep_clear(Guard guard, const Real& lower_bound) {
    const auto is_clear = Real(0.0) < lower_bound;
    b_.unclear[static_cast<std::size_t>(guard)] = ~bits_of(is_clear);
    clear_ = clear_ && is_clear;
  }

  /// Of the polynomial with `count` coefficients over the step, from coefficient `first` on; see integrate.
  template <std::size_t first, std::size_t count, class Coefficient>
  [[nodiscard]] Real bound(Coefficient coefficient) const {
    Real below(0.0);
#pragma GCC unroll 20
    for (std::size_t k = count; k > first; --k) below = integrate::bound_below(below, coefficient(k - 1), length_);
    return below;
  }

  /// The same, coefficient 0 divided out in the lanes where it is known to be 0.
  template <std::size_t count, class Truths, class Coefficient>
  [[nodiscard]] Real bound_but_zero(const Truths& starts_at_zero, Coefficient coefficient) const {
    using base::select;
    const Real rest = bound<1, count>(coefficient);
    return select(starts_at_zero, rest, integrate::bound_below(rest, coefficient(0), length_));
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
    Point p{m_.tilt[order + 1], m_.tilt_rate[order], m_.slip[order + 1], m_.slip_rate[order]};
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
    const auto rocks = p.tilt - p.tilt == Real(0.0) && p.tilt_rate - p.tilt_rate == Real(0.0);
    if constexpr (slips) {
      return rocks && p.slip - p.slip == Real(0.0) && p.slip_rate - p.slip_rate == Real(0.0);
    } else {
      return rocks;
    }
  }

  /// Moves on the lanes where nothing happened: no guard in doubt, no breakpoint, at most one strobe point, not the last.
  void move() {
    using base::select;
    const Real one(1.0);
    const Real resolution = load(b_.resolution);
    const Point next = point(length_);
    const Real later = time_ + length_;
    const auto wraps = !(later < period_length_);
    const Real time = select(wraps, later - period_length_, later);
    const Real steps_since = load(b_.steps_since_strobe) + one;

    const Real end = length_ - resolution;
    const Real strobe_period = load(b_.strobe_period);
    const Real strobe_time = load(b_.strobe_time);
    const Real instant = until(strobe_period, strobe_time);
    const auto strobes = instant < end;
    const Real strobes_left = load(b_.strobes_left);

    auto quiet = clear_ && fits_ && is_finite(next) && Real(dynamics::least_step) * resolution < length_ &&
                 time_ < later && time < period_length_ &&
                 steps_since < Real(static_cast<double>(dynamics::step_budget) + 0.5) &&
                 !(strobes && (strobes_left < Real(1.5) || until(strobe_period + one, strobe_time) < end));
    const auto arrives = !(length_ < reach_ - resolution);
    if constexpr (kind != Kind::rock_slide_briefly) quiet = quiet && !arrives;
    auto strobed = quiet && strobes;
    if (bits_of(strobed) != 0) {
      const Point at_strobe = point(select(resolution < instant, instant, Real(0.0)));
      store(b_.strobe_tilt, at_strobe.tilt);
      store(b_.strobe_tilt_rate, at_strobe.tilt_rate);
      if constexpr (slips) {
        store(b_.strobe_slip, at_strobe.slip);
        store(b_.strobe_slip_rate, at_strobe.slip_rate);
      }
      quiet = quiet && (is_finite(at_strobe) || !strobes);
      strobed = quiet && strobes;
      store(b_.strobe_period, select(strobed, strobe_period + one, strobe_period));
      store(b_.strobes_left, select(strobed, strobes_left - one, strobes_left));
    }
    b_.strobed = bits_of(strobed);
    b_.quiet = bits_of(quiet);
    b_.arrived = bits_of(quiet && arrives);
    store(b_.steps_since_strobe, select(strobed, Real(0.0), select(quiet, steps_since, load(b_.steps_since_strobe))));
    store(b_.steps, select(quiet, load(b_.steps) + one, load(b_.steps)));
    store(b_.tilt, select(quiet, next.tilt, m_.tilt[0]));
    store(b_.tilt_rate, select(quiet, next.tilt_rate, m_.tilt_rate[0]));
    if constexpr (slips) {
      store(b_.slip, select(quiet, next.slip, m_.slip[0]));
      store(b_.slip_rate, select(quiet, next.slip_rate, m_.slip_rate[0]));
    }
    store(b_.time, select(quiet, time, time_));
    store(b_.period, select(quiet && wraps, period_ + one, period_));
  }

  using Truths = decltype(std::declval<Real>() < std::declval<Real>());

  Block& b_;
  MotionSeries<Real>& m_;
  Real time_;
  Real period_;
  Real period_length_;
  Real reach_;
  Real length_;
  Truths starts_flat_;
  Truths fits_;
  Truths clear_;
};

template <Kind kind, class Real>
void step(Block& block) {
  Step<kind, Real>(block).run();
}

template <class Real>
constexpr Kernels kernels_of(std::string_view name) {
  return {.name = name,
          .lanes = Row<Real>::lanes,
          .step = {step<Kind::rock, Real>, step<Kind::rock_with_friction, Real>, step<Kind::rock_slide, Real>,
                   step<Kind::rock_slide_briefly, Real>}};
}

}  // namespace
}  // namespace rocking::lanes
