#include "rocking/scene/periods_until_rest.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "rocking/dynamics/impact.hpp"

namespace rocking {

std::int64_t periods_until_rest(const Scene& scene) {
  constexpr double two_pi = 0x1.921fb54442d18p+2;
  constexpr double first_hop = 8.0, other_hops = 4.0, least_loss = 1e-3;  // derived in the header
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  const double delta = dynamics::inelastic_rate_ratio(block, restitution_of(scene, block));
  const double coming_to_rest = first_hop + other_hops / std::max(1.0 - std::abs(delta), least_loss);
  const double shaking = std::visit([&](const auto& kind) { return kind.end_of_shaking(block); }, scene.excitation);
  const double periods = std::ceil((shaking + coming_to_rest) * frequency_ratio_for(scene, block) / two_pi);
  return std::isfinite(periods) ? static_cast<std::int64_t>(periods) : 1;  // not finite: the block is refused anyway
}

}  // namespace rocking
