#include "rocking/dynamics/block.hpp"

#include <cmath>

#include "rocking/base/elementary.hpp"

namespace rocking::dynamics {

Geometry geometry_of(const Block& block) {
  const double diagonal = std::sqrt(block.width * block.width + block.height * block.height);
  const double half_diagonal = 0.5 * diagonal;
  return {.shape_angle = base::arc_tangent(block.width / block.height),
          .half_diagonal = half_diagonal,
          .frequency_parameter = std::sqrt(0.75 * block.gravity / half_diagonal),
          .sine = block.width / diagonal,
          .cosine = block.height / diagonal,
          .tangent = block.width / block.height};
}

}  // namespace rocking::dynamics
