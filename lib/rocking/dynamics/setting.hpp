#pragma once

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/formulation.hpp"

namespace rocking::dynamics {

/// What a scene fixes for a realisation.
struct Setting {
  Geometry block;
  double inertia;  ///< J
  ImpactSlipRule impact_slip_rule;
  double tolerance;  ///< of a step, in Theta and Theta'; of a hop, see Landing::hop_is_too_small
};

}  // namespace rocking::dynamics
