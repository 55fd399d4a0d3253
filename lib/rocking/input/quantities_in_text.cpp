#include "rocking/input/quantities_in_text.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <variant>

#include "rocking/scene/drawn_quantities.hpp"
#include "rocking/scene/excitation.hpp"
#include "rocking/scene/experiment_keys.hpp"

namespace rocking {
namespace {

void add_places(const Scene& scene, std::vector<NamedPlace>& places) {
  for_each_quantity(scene, [&places](const QuantityPlace& what, const Quantity&) {
    if (std::ranges::find(places, what.place, &NamedPlace::place) == places.end()) places.push_back(what);
  });
}

/// Of scenes that together have every number, in every unit.
std::vector<NamedPlace> collected_places() {
  std::vector<NamedPlace> places;
  Scene scene;
  scene.friction.emplace();
  add_places(scene, places);
  scene.initial.units = {StateUnit::si, StateUnit::si, StateUnit::si, StateUnit::si};
  add_places(scene, places);
  scene.initial.units.tilt = StateUnit::degrees;
  add_places(scene, places);
  scene.restitution = RateRatio{.right = 1.0};
  add_places(scene, places);
  for (std::size_t law = 1; law < std::variant_size_v<Restitution>; ++law) {
    scene.restitution = alternative_at<Restitution>(law);
    add_places(scene, places);
  }
  for (const AccelerationUnit unit : {AccelerationUnit::gravity, AccelerationUnit::m_s2}) {
    scene.excitation = Pulse{.physical_amplitude = PhysicalAmplitude{.unit = unit}};
    add_places(scene, places);
    scene.excitation = Harmonic{.vertical = VerticalHarmonic{.physical_amplitude = PhysicalAmplitude{.unit = unit}}};
    add_places(scene, places);
  }
  for (const FrequencyUnit unit : {FrequencyUnit::hertz, FrequencyUnit::period_s}) {
    scene.excitation = Pulse{.physical_frequency = PhysicalFrequency{.unit = unit}};
    add_places(scene, places);
    scene.excitation = Harmonic{.vertical = VerticalHarmonic{.physical_frequency = PhysicalFrequency{.unit = unit}}};
    add_places(scene, places);
  }
  for (const Building& building : {Building{}, Building{.modes = std::vector<BuildingMode>(most_building_modes)}}) {
    scene.excitation = Recorded{.building = building};
    add_places(scene, places);
  }
  for (const NamedPlace& each : quantities::strengths) places.push_back(each);
  return places;
}

}  // namespace

SweptValue swept_value(const Json& value) {
  if (value.is_number_float()) return value.get<double>();
  const bool fits = !value.is_number_unsigned() || std::in_range<std::int64_t>(value.get<std::uint64_t>());
  if (value.is_number_integer() && fits) return value.get<std::int64_t>();
  if (value.is_string()) return value.get<std::string>();
  return WrittenPart{value.dump()};
}

Json json_of(const SweptValue& value) {
  if (const auto* part = std::get_if<WrittenPart>(&value)) return Json::parse(part->text);
  if (const auto* word = std::get_if<std::string>(&value)) return *word;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole;
  return std::get<double>(value);
}

std::string json_text_of(const SweptValue& value) { return json_of(value).dump(); }

const std::vector<NamedPlace>& places_of_quantities() {
  static const std::vector<NamedPlace> places = collected_places();
  return places;
}

}  // namespace rocking
