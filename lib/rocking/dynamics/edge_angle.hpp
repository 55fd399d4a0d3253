#pragma once

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/setting.hpp"

namespace rocking::dynamics {

/// sin and cos of phi = psi - abs(theta), the angle of the edge-to-centre line from the vertical. `tilt` is abs(theta),
/// or S theta; at 0 they are exactly those of psi.
template <base::Lane Real>
[[nodiscard]] inline base::SinCos<Real> edge_angle(const Real& tilt, const EquationConstants<Real>& constants) {
  using base::in_any, base::select;
  const Real phi = constants.shape_angle - tilt;
  const auto is_small = Real(-base::almost_quarter_pi) < phi && phi < Real(base::almost_quarter_pi);
  const auto tilted = in_any(!is_small) ? base::sin_cos(phi) : base::reduced_sin_cos(phi);
  const auto is_flat = tilt == Real(0.0);
  return {select(is_flat, constants.sine, tilted.sine), select(is_flat, constants.cosine, tilted.cosine)};
}

[[nodiscard]] inline base::SinCos<double> edge_angle(const State& state, const EquationConstants<double>& constants) {
  return edge_angle(state.side * state.tilt, constants);
}

}  // namespace rocking::dynamics
