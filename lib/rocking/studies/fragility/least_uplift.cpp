#include "rocking/studies/fragility/least_uplift.hpp"

#include <limits>
#include <variant>

#include "rocking/plan/thresholds.hpp"

namespace rocking {
namespace {

bool starts_at_rest(const InitialState& initial) {
  const auto is_zero = [](const Quantity& quantity) {
    const Reach reach = reach_of(quantity);
    return reach.least == 0.0 && reach.largest == 0.0;
  };
  return is_zero(initial.tilt) && is_zero(initial.tilt_rate) && is_zero(initial.slip_rate);
}

}  // namespace

std::optional<double> least_uplift(const Scene& scene, double intensity) {
  if (!starts_at_rest(scene.initial) || scene.fluctuation.amplitude > 0.0) return std::nullopt;
  const dynamics::Geometry block = shapes_of(scene.block).most_slender;
  const auto* recorded = std::get_if<Recorded>(&scene.excitation);
  if (recorded == nullptr) {
    // The largest abs(alpha) of the other kinds is A_h psi.
    return block.tangent / block.shape_angle * amplitude_unit(scene, block);
  }
  if (!recorded->ground_motion || is_drawn(recorded->scale)) return std::nullopt;
  const auto scale = least_uplift_scale(recorded->ground_motion->samples, block);
  if (!scale) return std::numeric_limits<double>::infinity();
  return intensity * (*scale / mean_of(recorded->scale));
}

}  // namespace rocking
