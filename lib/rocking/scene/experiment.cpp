#include "rocking/scene/experiment.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "rocking/scene/drawn_quantities.hpp"

namespace rocking {
std::optional<double> number_in(const SweptValue& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return std::nullopt;
}

double mean_static(const Friction& friction) { return mean_of(friction.static_coefficient); }

double mean_kinetic(const Friction& friction) {
  return friction.kinetic_ratio ? *friction.kinetic_ratio * mean_static(friction)
                                : mean_of(friction.kinetic_coefficient);
}

RedrawnQuantity law_along_the_way(FluctuationLaw law, double mean, double sigma) {
  constexpr double root_three = 0x1.bb67ae8584caap+0;
  if (sigma == 0.0) return mean;
  switch (law) {
    case FluctuationLaw::normal: return Normal{.mean = mean, .sigma = sigma};
    case FluctuationLaw::lognormal:
      // The mean may itself be drawn, and limited to 0.
      return mean > 0.0 ? RedrawnQuantity(Lognormal{.mean = mean, .sigma = sigma}) : RedrawnQuantity(mean);
    case FluctuationLaw::uniform: return Uniform{.low = mean - root_three * sigma, .high = mean + root_three * sigma};
  }
  return mean;
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

namespace {

/// Of a harmonic excitation with a vertical part: absent where Omega_v/Omega_h differs between realisations.
std::optional<dynamics::VerticalSine> common_vertical_sine(const Scene& scene) {
  const auto& harmonic = std::get<Harmonic>(scene.excitation);
  const VerticalHarmonic& vertical = *harmonic.vertical;
  const auto drawn = [](const auto& kind) {
    return is_drawn(kind.physical_frequency ? kind.physical_frequency->value : kind.frequency_ratio);
  };
  const bool follows_block = harmonic.physical_frequency.has_value() != vertical.physical_frequency.has_value();
  if (drawn(harmonic) || drawn(vertical) || (follows_block && is_drawn(scene.block))) return std::nullopt;
  return harmonic.vertical_sine(dynamics::geometry_of(mean_block(scene)), scene.block.gravity);
}

/// The scene itself, or where its vertical frequency is drawn from `values` the scene with each of them.
std::vector<Scene> with_each_vertical_frequency(const Scene& scene) {
  const auto frequency_of = [](Scene& of) -> Quantity& {
    VerticalHarmonic& vertical = *std::get<Harmonic>(of.excitation).vertical;
    return vertical.physical_frequency ? vertical.physical_frequency->value : vertical.frequency_ratio;
  };
  std::vector<Scene> scenes{scene};
  const Quantity frequency = frequency_of(scenes.front());
  const auto* values = std::get_if<Values>(&frequency);
  if (values == nullptr) return scenes;
  scenes.assign(values->values.size(), scene);
  for (std::size_t i = 0; i < scenes.size(); ++i) frequency_of(scenes[i]) = values->values[i];
  return scenes;
}

}  // namespace

std::optional<std::int64_t> periods_of_base(const Scene& scene) {
  if (!is_periodic(scene.excitation)) return std::nullopt;
  if (vertical_of(scene.excitation) == nullptr) return 1;
  std::int64_t common = 1;
  for (const Scene& each : with_each_vertical_frequency(scene)) {
    const auto sine = common_vertical_sine(each);
    if (!sine || sine->cycles != std::floor(sine->cycles)) return std::nullopt;
    common = std::lcm(common, static_cast<std::int64_t>(sine->periods));
    constexpr std::int64_t most = 1'000'000;  // below it the least common multiple of two cannot overflow
    if (common > most) return std::nullopt;
  }
  return common;
}

bool has_mirror_symmetry(const Scene& scene) {
  if (!dynamics::geometry_of(mean_block(scene)).has_mirror_symmetry()) return false;
  if (!is_alike_at_both_edges(scene.restitution)) return false;
  if (vertical_of(scene.excitation) == nullptr) return true;
  const auto sine = common_vertical_sine(scene);
  return sine && sine->periods == 1.0 && 0.5 * sine->cycles == std::floor(0.5 * sine->cycles);
}

bool is_random_along_the_way(const Scene& scene) {
  const Fluctuation& f = scene.fluctuation;
  return f.static_friction > 0.0 || f.kinetic_friction > 0.0 || f.restitution > 0.0 || f.amplitude > 0.0;
}

std::vector<NamedPlace> drawn_once(const Scene& scene) {
  std::vector<NamedPlace> drawn;
  for_each_quantity(scene, [&drawn](const QuantityPlace& what, const Quantity& quantity) {
    if (is_drawn(quantity)) drawn.push_back(what);
  });
  return drawn;
}

std::optional<std::string_view> place_of_randomness(const Scene& scene) {
  if (const auto drawn = drawn_once(scene); !drawn.empty()) return drawn.front().place;
  return is_random_along_the_way(scene) ? std::optional<std::string_view>("/fluctuation") : std::nullopt;
}

bool is_random(const Scene& scene) { return place_of_randomness(scene).has_value(); }

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
