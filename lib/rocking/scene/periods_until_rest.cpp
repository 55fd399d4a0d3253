#include "rocking/scene/periods_until_rest.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "rocking/dynamics/impact.hpp"

namespace rocking {

std::int64_t periods_until_rest(const Scene& scene) {
  constexpr double two_pi = 0x1.921fb54442d18p+2;
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  const double delta = dynamics::inelastic_rate_ratio(block, scene.restitution);
  const double coming_to_rest = 8.0 + 4.0 / std::max(1.0 - std::abs(delta), 1e-3);
  const double shaking =
      std::visit([&](const auto& kind) { return kind.end_of_shaking(block.frequency_parameter); }, scene.excitation);
  return static_cast<std::int64_t>(std::ceil((shaking + coming_to_rest) * frequency_ratio(scene.excitation) / two_pi));
}

}  // namespace rocking
