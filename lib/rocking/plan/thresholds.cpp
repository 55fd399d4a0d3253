#include "rocking/plan/plan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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
    found.to_right.add(block.edges[0].tangent);
    found.to_left.add(block.edges[1].tangent);
    found.has_sides = found.has_sides || !block.is_rectangle();
    for (const dynamics::Edge& edge : block.edges) {
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

}  // namespace rocking
