#include "rocking/plan/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <variant>

#include "rocking/dynamics/block.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/restitution.hpp"

namespace rocking {
namespace {

/// Base acceleration over g from which a block that has just lifted slides: there F = mu N with the forces of rocking
/// without slip at Theta = 0, w = 0, over a base without vertical motion. Absent if no acceleration is enough.
std::optional<double> slide_of_rocking(const dynamics::Geometry& block, const dynamics::Edge& edge, double friction) {
  const double s = edge.sine, c = edge.cosine;
  const double gain = block.load - edge.rocking_gain * c * (c + friction * s);
  if (!(gain > 0.0)) return std::nullopt;
  return (friction * (block.load - edge.rocking_gain * s * s) - edge.rocking_gain * s * c) / gain;
}

/// Least friction with which an impact from rocking without slip sticks.
double sticking_friction(const dynamics::Geometry& block, const dynamics::Edge& landing) {
  return landing.sine * landing.cosine / (block.inertia + landing.cosine * landing.cosine);
}

struct Thresholds {
  NumberRange uplift, friction, impact, rocking;
  NumberRange to_right, to_left;  ///< uplift by a base acceleration to the right, which lifts over the left edge
  bool may_slide = false;
  bool has_sides = false;
};

std::string friction_text(const Thresholds& found) {
  if (!found.may_slide) return "Friction is not given: the block does not slide.\n";
  std::string text = "Static friction " + found.friction.text() +
                     ": a block at rest slides before it lifts if it is below " + found.uplift.text() +
                     ", an impact slips if it is below " + found.impact.text();
  if (found.rocking.least <= found.rocking.largest) {
    text += "; a block that begins to rock slides if the base exceeds " + found.rocking.text() + " g";
  }
  return text + ".\n";
}

/// What a vertical harmonic motion changes; empty without one.
std::string vertical_text(const Experiment& experiment) {
  NumberRange amplitude;
  const Condition* without_strobe = nullptr;
  for (const Condition& condition : experiment.conditions) {
    if (vertical_of(condition.scene.excitation) == nullptr) continue;
    const dynamics::Geometry block = dynamics::geometry_of(mean_block(condition.scene));
    const auto& harmonic = std::get<Harmonic>(condition.scene.excitation);
    amplitude.add(harmonic.vertical_sine(block, condition.scene.block.gravity).amplitude);
    if (relations::vertical_without_strobe(condition)) without_strobe = &condition;
  }
  if (!(amplitude.least <= amplitude.largest)) return "";
  std::string text = "The base also moves vertically, by up to " + amplitude.text() +
                     " g: these accelerations are to be multiplied by 1 + a_v/g at each instant.\n";
  if (without_strobe != nullptr) {
    const Refusal refusal = *relations::vertical_without_strobe(*without_strobe);
    text += "Only for `rocking trajectory`, since the vertical frequency " + refusal.reason + ".\n";
  }
  return text;
}

}  // namespace

std::string thresholds_text(const Experiment& experiment) {
  Thresholds found;
  for (const Condition& condition : experiment.conditions) {
    const dynamics::Geometry block = dynamics::geometry_of(mean_block(condition.scene));
    if (!(block.open_side < 0.0)) found.to_right.add(block.edges[0].tangent);
    if (!(block.open_side > 0.0)) found.to_left.add(block.edges[1].tangent);
    found.has_sides = found.has_sides || (!block.is_rectangle() && block.open_side == 0.0);
    for (const double side : {1.0, -1.0}) {
      if (side * block.open_side < 0.0) continue;
      const dynamics::Edge& edge = block.edge(side);
      found.uplift.add(edge.tangent);
      found.impact.add(sticking_friction(block, edge));
      if (!condition.scene.friction) continue;
      const double friction = mean_of(condition.scene.friction->static_coefficient);
      const auto slide = slide_of_rocking(block, edge, friction);
      if (slide && friction > edge.tangent) found.rocking.add(*slide);
      found.may_slide = true;
      found.friction.add(friction);
    }
  }
  const std::string uplift =
      found.has_sides ? found.to_right.text() + " g to the right or " + found.to_left.text() + " g to the left"
                      : found.uplift.text() + " g";
  return "A block at rest lifts if the base exceeds " + uplift + ". " + friction_text(found) +
         vertical_text(experiment);
}

std::optional<double> least_uplift_scale(const std::vector<dynamics::GroundMotionSample>& samples,
                                         const std::array<double, 2>& tangents) {
  // abs(alpha) - tan(psi) alpha_v is a convex function of the time between samples on each side, so that its largest value
  // is at one of them, or where alpha = 0 and another sample has a larger one.
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double least = infinity;
  for (const auto& [time, horizontal, vertical] : samples) {
    const double tangent = tangents[horizontal < 0.0 ? 1 : 0];
    const double push = std::abs(horizontal) - tangent * vertical;
    if (push > 0.0) least = std::min(least, tangent / push);
  }
  return least < infinity ? std::optional(least) : std::nullopt;
}

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
  if (const auto* pulse = std::get_if<Pulse>(&scene.excitation)) {  // A_h of this shape is no peak
    if (pulse->shape == dynamics::PulseShape::mavroeidis_papageorgiou) return std::nullopt;
  }
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
  if (recorded->building && is_drawn(*recorded->building)) return std::nullopt;
  auto [left, right] = shapes.least_tangents;
  const auto scale =
      least_uplift_scale(base_motion(*recorded), std::array{std::min(left, limit), std::min(right, limit)});
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
