#include "rocking/scene/experiment.hpp"

#include <algorithm>

#include "rocking/dynamics/impact.hpp"

namespace rocking {

double restitution_of(const Scene& scene, const dynamics::Geometry& block) {
  if (const auto* ratio = std::get_if<RateRatio>(&scene.restitution))
    return dynamics::restitution_of_rate_ratio(block, ratio->value);
  const auto* number = std::get_if<double>(&scene.restitution);
  return number != nullptr ? *number : dynamics::inelastic_rate_ratio(block);
}

double restitution_unit(const Scene& scene, const dynamics::Geometry& block) {
  return std::holds_alternative<RateRatio>(scene.restitution) ? dynamics::impact_loss(0.0, block) : 1.0;
}

double amplitude_unit(const Scene& scene, const dynamics::Geometry& block) {
  return std::visit([&](const auto& kind) { return kind.size_unit(block, scene.block.gravity); }, scene.excitation);
}

double amplitude_for(const Scene& scene, const dynamics::Geometry& block) {
  return size_of(scene.excitation) / amplitude_unit(scene, block);
}

double frequency_ratio_for(const Scene& scene, const dynamics::Geometry& block) {
  const dynamics::Geometry mean = dynamics::geometry_of(mean_block(scene));
  return std::visit([&](const auto& kind) { return kind.frequency_ratio_for(block, mean); }, scene.excitation);
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
