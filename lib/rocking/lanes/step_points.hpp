#pragma once

#include <cstddef>

#include "rocking/lanes/step.hpp"

namespace rocking::lanes {
namespace {

/// States within the coming step of the lanes: at any time, and at the strobe instant.
template <Kind kind, class Shaking, class Real>
class StepPoints : public Step<kind, Shaking, Real> {
  using Base = Step<kind, Shaking, Real>;

 protected:
  using Base::state_, Base::load, Base::m_, Base::order, Base::slips, Base::store, Base::until;

 public:
  using Base::Base;

 protected:
  struct Point {
    Real tilt;
    Real tilt_rate;
    Real slip;
    Real slip_rate;
  };

  /// The state at time x of the step.
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
    Real sum = p.tilt + p.tilt_rate;  // finite only if all of them are
    if constexpr (slips) sum = sum + (p.slip + p.slip_rate);
    return sum - sum == Real(0.0);
  }

  /// The strobe instant within a part of the step.
  struct Strobing {
    Real instant;
    TruthOf<Real> strobes;    ///< there is one
    TruthOf<Real> is_last;    ///< the run ends with it
    TruthOf<Real> is_simple;  ///< there is no second one
  };

  /// In the step up to its time `end`.
  [[nodiscard]] Strobing strobing(const Real& end) const {
    const Real strobe_period = load(state_.strobe_period);
    const Real strobe_time = load(state_.strobe_time);
    const Real instant = until(strobe_period, strobe_time);
    const auto strobes = instant < end;
    if (bits_of(strobes) == 0) return {instant, strobes, strobes, !strobes};
    const auto is_last = load(state_.strobes_left) < Real(1.5);
    const auto is_only = is_last || !(until(strobe_period + Real(1.0), strobe_time) < end);
    return {instant, strobes, is_last, is_only || !strobes};
  }

  /// The time of the step at which the state is that of the strobe point.
  [[nodiscard]] static Real time_of(const Strobing& strobing, const Real& resolution) {
    using base::select;
    return select(resolution < strobing.instant, strobing.instant, Real(0.0));
  }

  /// Stores the state at the strobe instant; true in the lanes where it is finite.
  TruthOf<Real> store_strobe(const Strobing& strobing, const Real& resolution) {
    const Point p = point(time_of(strobing, resolution));
    store(state_.strobe_tilt, p.tilt);
    store(state_.strobe_tilt_rate, p.tilt_rate);
    if constexpr (slips) {
      store(state_.strobe_slip, p.slip);
      store(state_.strobe_slip_rate, p.slip_rate);
    }
    return is_finite(p);
  }
};

}  // namespace
}  // namespace rocking::lanes
