#include "rocking/dynamics/validity.hpp"

#include <algorithm>
#include <cmath>

namespace rocking::dynamics {

double painleve_friction(const Geometry& block, SlideInertia inertia) {
  const double twice = 2.0 * inertia_ratio(inertia) + 1.0;
  const double in_motion = std::sqrt(twice * twice - 1.0);
  const double in_impact = (1.0 / 3.0 + block.sine * block.sine) / (block.sine * block.cosine);
  return std::min(in_motion, in_impact);
}

}  // namespace rocking::dynamics
