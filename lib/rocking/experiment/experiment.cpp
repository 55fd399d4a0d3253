#include "rocking/experiment/experiment.hpp"

#include <algorithm>

namespace rocking::experiment {

bool is_random(const Scene& scene) {
  const auto is_law = [](const Quantity& quantity) { return !std::holds_alternative<double>(quantity); };
  const Fluctuation& f = scene.fluctuation;
  return f.static_friction > 0.0 || f.kinetic_friction > 0.0 || f.restitution > 0.0 || f.amplitude > 0.0 ||
         is_law(start_phase(scene.excitation)) || is_law(scene.initial.tilt) || is_law(scene.initial.tilt_rate) ||
         is_law(scene.initial.slip_rate);
}

std::optional<double> common_confidence(const Experiment& experiment) {
  const double first = experiment.conditions.front().confidence;
  const auto has_first = [first](double confidence) { return confidence == first; };
  return std::ranges::all_of(experiment.conditions, has_first, &Condition::confidence) ? std::optional(first) : std::nullopt;
}

double highest_confidence(const Experiment& experiment) {
  return std::ranges::max_element(experiment.conditions, {}, &Condition::confidence)->confidence;
}

}  // namespace rocking::experiment
