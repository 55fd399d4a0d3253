#include <array>
#include <cmath>
#include <limits>
#include <variant>

#include "rocking/plan/plan.hpp"

namespace rocking {
namespace {

bool starts_at_rest(const InitialState& initial) {
  const auto is_zero = [](const Quantity& quantity) {
    const Reach reach = reach_of(quantity);
    return reach.least == 0.0 && reach.largest == 0.0;
  };
  return is_zero(initial.tilt) && is_zero(initial.tilt_rate) && is_zero(initial.slip_rate);
}

/// Least 1 + alpha_v of any realisation under a vertical sine; 1 without one.
double least_weight(const Scene& scene) {
  const VerticalHarmonic* vertical = vertical_of(scene.excitation);
  if (vertical == nullptr) return 1.0;
  const auto& [amplitude, ratio, phase, physical, frequency] = *vertical;
  if (!physical) {
    const dynamics::Geometry squat = shapes_of(scene.block).squattest;
    const double psi = std::max(squat.edges[0].shape_angle, squat.edges[1].shape_angle);
    return 1.0 - reach_of(amplitude).largest * psi;
  }
  const bool in_g = physical->unit == AccelerationUnit::gravity;
  return 1.0 - reach_of(physical->value).largest / (in_g ? 1.0 : scene.block.gravity);
}

/// Least intensity at which abs(alpha)/(1 + alpha_v) reaches `limit`, or tan(psi) where that is smaller. Infinite where
/// none does; absent where none is known.
std::optional<double> least_at(const Scene& scene, double intensity, double limit) {
  if (!starts_at_rest(scene.initial) || scene.fluctuation.amplitude > 0.0) return std::nullopt;
  const ShapeRange shapes = shapes_of(scene.block);
  const auto* recorded = std::get_if<Recorded>(&scene.excitation);
  if (recorded == nullptr) {
    // The largest abs(alpha) of the other kinds is A_h psi; the least 1 + alpha_v is 1 without vertical motion.
    const double lightest = least_weight(scene);
    if (!(lightest > 0.0)) return std::nullopt;
    const auto amplitude = [&](const dynamics::Geometry& block, double acceleration) {
      return lightest * (acceleration / block.shape_angle * amplitude_unit(scene, block));
    };
    return std::min(amplitude(shapes.most_slender, shapes.most_slender.tangent), amplitude(shapes.squattest, limit));
  }
  if (!recorded->ground_motion || is_drawn(recorded->scale)) return std::nullopt;
  auto [left, right] = shapes.least_tangents;
  const auto scale =
      least_uplift_scale(recorded->ground_motion->samples, std::array{std::min(left, limit), std::min(right, limit)});
  if (!scale) return std::numeric_limits<double>::infinity();
  return intensity * (*scale / mean_of(recorded->scale));
}

/// Least static friction of any realisation.
double least_friction(const Scene& scene) {
  if (!scene.friction) return std::numeric_limits<double>::infinity();
  const double least = reach_of(scene.friction->static_coefficient).least;
  const double sigma = scene.fluctuation.static_friction;
  if (sigma == 0.0) return least;
  return scene.fluctuation.laws.static_friction == FluctuationLaw::uniform ? least - std::sqrt(3.0) * sigma : 0.0;
}

}  // namespace

std::optional<double> least_uplift(const Scene& scene, double intensity) {
  return least_at(scene, intensity, std::numeric_limits<double>::infinity());
}

std::optional<double> least_sliding(const Scene& scene, double intensity) {
  const double friction = least_friction(scene);
  return friction > 0.0 ? least_at(scene, intensity, friction) : std::nullopt;
}

}  // namespace rocking
