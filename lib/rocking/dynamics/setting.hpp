#pragma once

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

/// What a scene fixes for a realisation.
struct Setting {
  Geometry block;
  double inertia;  ///< J
  ImpactSlipRule impact_slip_rule;
  double tolerance;  ///< of a step, in Theta and Theta'; of a hop, see hop_is_too_small
};

/// Constants of the equations between events. `Real` is a number of one motion, a pack of lanes, or a row of a table
/// with a number for each lane.
template <class Real>
struct EquationConstants {
  Real shape_angle;  ///< psi
  Real sine;         ///< sin(psi)
  Real cosine;       ///< cos(psi)
  Real inertia;      ///< J
};

/// Calls use(a's constant, b's constant) for each of them.
template <class A, class B, class Use>
void for_each_constant(EquationConstants<A>& a, const EquationConstants<B>& b, Use&& use) {
  use(a.shape_angle, b.shape_angle);
  use(a.sine, b.sine);
  use(a.cosine, b.cosine);
  use(a.inertia, b.inertia);
}

[[nodiscard]] inline EquationConstants<double> equation_constants(const Setting& setting) {
  return {.shape_angle = setting.block.shape_angle,
          .sine = setting.block.sine,
          .cosine = setting.block.cosine,
          .inertia = setting.inertia};
}

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
