#pragma once

#include "rocking/base/lane.hpp"

namespace rocking::dynamics {

/// Tilt rate after a sticking impact, and its impulses over m R p.
template <base::Lane Real>
struct StickingImpulse {
  Real tilt_rate;   ///< w2
  Real horizontal;  ///< P_x
  Real vertical;    ///< P_y
};

/// Rates w1, V1 before an impact.
template <base::Lane Real>
struct LandingRates {
  Real tilt_rate;
  Real slip_rate;
};

/// What a sticking impact depends on besides the rates.
template <base::Lane Real>
struct LandingEdge {
  Real restitution;  ///< e at the landing edge
  Real loss;         ///< (3/2)(1 + e) sin^2(psi)
  Real sine;         ///< sin(psi)
  Real cosine;       ///< cos(psi)
};

/// w2 = w1 - (3/4) V1 cos(psi) - (3/2)(1 + e) sin^2(psi) w1.
template <base::Lane Real>
[[nodiscard]] inline Real sticking_rate(const LandingRates<Real>& before, const LandingEdge<Real>& edge) {
  return (before.tilt_rate - Real(0.75) * edge.cosine * before.slip_rate) - edge.loss * before.tilt_rate;
}

/// L = V1 - w1 cos(psi).
template <base::Lane Real>
[[nodiscard]] inline Real lambda_term(const LandingRates<Real>& before, const Real& cosine) {
  return before.slip_rate - before.tilt_rate * cosine;
}

/// With L of lambda_term, P_x = -(cos(psi) w2 + L) and P_y = sin(psi) ((1 + 2e) abs(w1) + sign(w1) w2); the same in the
/// frames of both sides.
template <base::Lane Real>
[[nodiscard]] inline StickingImpulse<Real> sticking_impulse(const LandingRates<Real>& before,
                                                            const LandingEdge<Real>& edge) {
  using base::magnitude, base::select;
  const Real w1 = before.tilt_rate;
  const Real w2 = sticking_rate(before, edge);
  const Real along = select(w1 < Real(0.0), -w2, w2);
  return {.tilt_rate = w2,
          .horizontal = -(edge.cosine * w2 + lambda_term(before, edge.cosine)),
          .vertical = edge.sine * ((Real(1.0) + Real(2.0) * edge.restitution) * magnitude(w1) + along)};
}

}  // namespace rocking::dynamics
