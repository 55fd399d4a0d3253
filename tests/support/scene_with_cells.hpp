#pragma once

#include "rocking/scene/experiment.hpp"
#include "support/excitation.hpp"

namespace rocking::support {

/// A wide block, which slides and does not rock, on cells of this length with friction of their own.
inline Scene scene_with_cells(double length_m) {
  Scene scene;
  scene.block = {.width = 3.0, .height = 2.0};
  harmonic(scene).frequency_ratio = 6.0;
  scene.friction = Friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.3};
  scene.fluctuation.static_friction = 0.02;
  scene.fluctuation.kinetic_friction = 0.03;
  scene.fluctuation.refresh_slip_m = length_m;
  return scene;
}

}  // namespace rocking::support
