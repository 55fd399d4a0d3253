#pragma once

#include "rocking/base/lane.hpp"
#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

/// A tangent vector: an infinitesimal change of a state, or its rate of change d/dtau.
template <base::Lane Real>
struct Tangent {
  Real tilt = Real(0.0);       ///< of theta [rad]
  Real tilt_rate = Real(0.0);  ///< of w [rad]
  Real slip = Real(0.0);       ///< of X
  Real slip_rate = Real(0.0);  ///< of V
};

/// a + factor b.
template <base::Lane Real>
[[nodiscard]] inline Tangent<Real> plus(const Tangent<Real>& a, const Real& factor, const Tangent<Real>& b) {
  using base::fused;
  return {.tilt = fused(factor, b.tilt, a.tilt),
          .tilt_rate = fused(factor, b.tilt_rate, a.tilt_rate),
          .slip = fused(factor, b.slip, a.slip),
          .slip_rate = fused(factor, b.slip_rate, a.slip_rate)};
}

/// The part of a change that keeps the contact state: without a change of the tilt in full contact, and of V where the
/// block does not slip.
[[nodiscard]] inline Tangent<double> within_contact(Tangent<double> change, const State& state) {
  if (state.tilt == 0.0 && state.tilt_rate == 0.0) change.tilt = change.tilt_rate = 0.0;
  if (state.slip_rate == 0.0) change.slip_rate = 0.0;
  return change;
}

/// A small change of state, in Theta, Theta' and V.
struct Displacement {
  double tilt = 0.0;
  double tilt_rate = 0.0;
  double slip_rate = 0.0;
};

/// Displaces a state, within its contact state, by `wanted`; returns the displacement made.
inline Displacement displace(State& state, const Displacement& wanted, double shape_angle) {
  Displacement done;
  if (is_rocking(state.contact)) {
    done.tilt = wanted.tilt;
    done.tilt_rate = wanted.tilt_rate;
  }
  if (is_sliding(state.contact)) done.slip_rate = wanted.slip_rate;
  state.tilt += done.tilt * shape_angle;
  state.tilt_rate += done.tilt_rate * shape_angle;
  state.slip_rate += done.slip_rate;
  return done;
}

}  // namespace rocking::dynamics
