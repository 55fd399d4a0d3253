#pragma once

#include "rocking/base/lane.hpp"
#include "rocking/dynamics/block.hpp"

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

/// What a sticking impact depends on besides the rates. The landing edge is that of side sign(w1).
template <base::Lane Real, BlockForm form = BlockForm::rectangle>
struct LandingEdge {
  static constexpr double gain = 1.5;

  Real restitution;  ///< e at the landing edge
  Real loss;         ///< of impact_loss
  Real sine;         ///< sin(psi)
  Real cosine;       ///< cos(psi)

  /// Upward rate of the leaving edge over abs(w1), if the landing one rebounds with e.
  [[nodiscard]] Real rebound() const { return Real(1.0) + Real(2.0) * restitution; }
};

template <base::Lane Real>
struct LandingEdge<Real, BlockForm::general> {
  Real restitution;
  Real loss;
  Real sine;      ///< b/R
  Real cosine;    ///< h/R
  Real gain;      ///< 2/(J + r^2)
  Real sideways;  ///< distance of the leaving edge from the centre of mass over that of the landing edge

  [[nodiscard]] Real rebound() const { return sideways + (Real(1.0) + sideways) * restitution; }
};

/// w2 = w1 - V1 c/(J + r^2) - loss w1, with the edge's lever c.
template <base::Lane Real, BlockForm form>
[[nodiscard]] inline Real sticking_rate(const LandingRates<Real>& before, const LandingEdge<Real, form>& edge) {
  const Real by_slip = Real(0.5) * Real(edge.gain) * edge.cosine;
  return (before.tilt_rate - by_slip * before.slip_rate) - edge.loss * before.tilt_rate;
}

/// L = V1 - w1 c, c the lever of the edges at theta = 0.
template <base::Lane Real>
[[nodiscard]] inline Real lambda_term(const LandingRates<Real>& before, const Real& cosine) {
  return before.slip_rate - before.tilt_rate * cosine;
}

/// With L of lambda_term and the edge's levers at theta = 0, P_x = -(c w2 + L) and P_y = s (rebound abs(w1) + sign(w1)
/// w2), rebound = 1 + 2e for a rectangle; the same in the frames of both sides.
template <base::Lane Real, BlockForm form>
[[nodiscard]] inline StickingImpulse<Real> sticking_impulse(const LandingRates<Real>& before,
                                                            const LandingEdge<Real, form>& edge) {
  using base::magnitude, base::select;
  const Real w1 = before.tilt_rate;
  const Real w2 = sticking_rate(before, edge);
  const Real along = select(w1 < Real(0.0), -w2, w2);
  return {.tilt_rate = w2,
          .horizontal = -(edge.cosine * w2 + lambda_term(before, edge.cosine)),
          .vertical = edge.sine * (edge.rebound() * magnitude(w1) + along)};
}

}  // namespace rocking::dynamics
