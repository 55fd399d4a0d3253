#pragma once

#include "rocking/lanes/step.hpp"

namespace rocking::lanes {
namespace {

/// A state within the coming step of the lanes; the slip only where the blocks slip.
template <class Real>
struct Point {
  Real tilt;
  Real tilt_rate;
  Real slip;
  Real slip_rate;
};

/// The state at time x of the step.
template <class Form, class Real = typename Form::Real>
[[nodiscard]] inline Point<Real> point(const dynamics::MotionSeries<Real>& m, const Real& x) {
  using base::fused;
  constexpr std::size_t order = Form::order;
  Point<Real> p;
  p.tilt = m.tilt[order + 1];
  p.tilt_rate = m.tilt_rate[order];
  if constexpr (Form::slips) {
    p.slip = m.slip[order + 1];
    p.slip_rate = m.slip_rate[order];
  }
#pragma GCC unroll 20
  for (std::size_t k = order; k > 0; --k) {
    p.tilt = fused(p.tilt, x, m.tilt[k]);
    p.tilt_rate = fused(p.tilt_rate, x, m.tilt_rate[k - 1]);
    if constexpr (Form::slips) {
      p.slip = fused(p.slip, x, m.slip[k]);
      p.slip_rate = fused(p.slip_rate, x, m.slip_rate[k - 1]);
    }
  }
  p.tilt = fused(p.tilt, x, m.tilt[0]);
  if constexpr (Form::slips) p.slip = fused(p.slip, x, m.slip[0]);
  return p;
}

template <class Form, class Real>
[[nodiscard]] inline auto is_finite(const Point<Real>& p) {
  Real sum = p.tilt + p.tilt_rate;  // finite only if all of them are
  if constexpr (Form::slips) sum = sum + (p.slip + p.slip_rate);
  return sum - sum == Real(0.0);
}

}  // namespace
}  // namespace rocking::lanes
