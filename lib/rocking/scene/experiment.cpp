#include "rocking/scene/experiment.hpp"

#include <algorithm>

#include "rocking/dynamics/impact.hpp"

namespace rocking {

double restitution_of(const Scene& scene, const dynamics::Geometry& block) {
  return scene.jy25_restitution ? dynamics::inelastic_rate_ratio(block) : scene.restitution;
}

bool is_random(const Scene& scene) {
  bool has_law = false;
  for_each_quantity(scene, [&](const char*, const Quantity& quantity) { has_law = has_law || is_drawn(quantity); });
  const Fluctuation& f = scene.fluctuation;
  return f.static_friction > 0.0 || f.kinetic_friction > 0.0 || f.restitution > 0.0 || f.amplitude > 0.0 || has_law;
}

std::uint64_t effective_realisations(const Condition& condition) {
  return is_random(condition.scene) ? condition.realisations : 1;
}

std::optional<double> common_confidence(const Experiment& experiment) {
  const double first = experiment.conditions.front().confidence;
  const auto has_first = [first](double confidence) { return confidence == first; };
  return std::ranges::all_of(experiment.conditions, has_first, &Condition::confidence) ? std::optional(first)
                                                                                       : std::nullopt;
}

double highest_confidence(const Experiment& experiment) {
  return std::ranges::max_element(experiment.conditions, {}, &Condition::confidence)->confidence;
}

}  // namespace rocking
