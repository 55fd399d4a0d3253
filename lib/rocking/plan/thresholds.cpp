#include "rocking/plan/plan.hpp"

#include <optional>

#include "rocking/dynamics/block.hpp"
#include "rocking/scene/restitution.hpp"

namespace rocking {
namespace {

/// Base acceleration over g from which a block that has just lifted slides: there F = mu N with the forces of rocking
/// without slip at Theta = 0, w = 0, over a base without vertical motion. Absent if no acceleration is enough.
std::optional<double> slide_of_rocking(const dynamics::Geometry& block, double friction) {
  const double s = block.sine, c = block.cosine;
  const double gain = 4.0 / 3.0 - c * c - friction * c * s;
  if (!(gain > 0.0)) return std::nullopt;
  return (friction * (4.0 / 3.0 - s * s) - s * c) / gain;
}

/// Least friction with which an impact from rocking without slip sticks.
double sticking_friction(const dynamics::Geometry& block) {
  return 3.0 * block.tangent / (4.0 + block.tangent * block.tangent);
}

struct Thresholds {
  NumberRange uplift, friction, impact, rocking;
  bool may_slide = false;
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

}  // namespace

std::string thresholds_text(const Experiment& experiment) {
  Thresholds found;
  for (const Condition& condition : experiment.conditions) {
    const dynamics::Geometry block = dynamics::geometry_of(mean_block(condition.scene));
    found.uplift.add(block.tangent);
    found.impact.add(sticking_friction(block));
    if (!condition.scene.friction) continue;
    found.may_slide = true;
    const double friction = mean_of(condition.scene.friction->static_coefficient);
    found.friction.add(friction);
    const auto slide = slide_of_rocking(block, friction);
    if (slide && friction > block.tangent) found.rocking.add(*slide);
  }
  return "A block at rest lifts if the base exceeds " + found.uplift.text() + " g. " + friction_text(found);
}

std::optional<double> least_uplift_scale(const std::vector<dynamics::GroundMotionSample>& samples,
                                         const dynamics::Geometry& block) {
  // abs(alpha) - tan(psi) alpha_v is a convex function of the time between samples, so that its largest value is at one.
  double most = 0.0;
  for (const auto& sample : samples) {
    most = std::max(most, std::abs(sample.horizontal) - block.tangent * sample.vertical);
  }
  if (!(most > 0.0)) return std::nullopt;
  return block.tangent / most;
}

}  // namespace rocking
