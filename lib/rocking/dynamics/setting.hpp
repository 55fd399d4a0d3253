#pragma once

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

}  // namespace rocking::dynamics
