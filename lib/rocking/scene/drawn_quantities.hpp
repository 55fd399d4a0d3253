#pragma once

#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "rocking/random/source.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/restitution.hpp"

namespace rocking {

/// A number of a scene that may have a law, which each realisation draws once.
struct QuantityPlace {
  random::Source source;   ///< of the draw
  std::string_view name;   ///< in words
  std::string_view place;  ///< JSON pointer into an experiment file
};

namespace quantities {

[[nodiscard]] inline std::string_view place_of(const std::optional<PhysicalAmplitude>& physical) {
  if (!physical) return "/excitation/amplitude";
  return physical->unit == AccelerationUnit::gravity ? "/excitation/amplitude_g" : "/excitation/amplitude_m_s2";
}

[[nodiscard]] inline std::string_view place_of(const std::optional<PhysicalFrequency>& physical) {
  if (!physical) return "/excitation/frequency_ratio";
  return physical->unit == FrequencyUnit::hertz ? "/excitation/frequency_hz" : "/excitation/period_s";
}

/// Of any kind of excitation, constant or not.
template <class Kind, class Visit>
void visit_excitation(Kind& kind, const Visit& visit) {
  using random::Source;
  if constexpr (requires { kind.physical_amplitude; }) {
    auto& amplitude = kind.physical_amplitude;
    visit({Source::excitation_size, "amplitude", place_of(amplitude)}, amplitude ? amplitude->value : kind.amplitude);
    auto& frequency = kind.physical_frequency;
    visit({Source::excitation_frequency, "frequency", place_of(frequency)},
          frequency ? frequency->value : kind.frequency_ratio);
  }
  if constexpr (requires { kind.scale; }) {
    visit({Source::excitation_size, "strength of the ground motion", "/excitation/scale"}, kind.scale);
  }
  if constexpr (requires { kind.phase; }) visit({Source::phase, "phase", "/excitation/phase_rad"}, kind.phase);
}

}  // namespace quantities

/// The one list of what a realisation may draw once: calls visit(QuantityPlace, quantity) for each of these numbers that
/// the scene has. The scene may be constant or not.
template <class AScene, class Visit>
void for_each_quantity(AScene& scene, const Visit& visit) {
  using random::Source;
  // A member that is not named here does not compile: it may be drawn, or it may not.
  auto& [block, slide_inertia, impact_slip_rule, restitution, excitation, friction, fluctuation, initial] = scene;
  for_each_block_number(block, [&visit](const BlockNumber& what, auto& number) {
    visit({what.source, what.name, what.place}, number);
  });
  if (const RestitutionNumber number = number_of(restitution); number.value != nullptr) {
    using Number = std::conditional_t<std::is_const_v<AScene>, const Quantity, Quantity>;
    visit({Source::mean_restitution, number.name, number.place}, const_cast<Number&>(*number.value));
  }
  std::visit([&visit](auto& kind) { quantities::visit_excitation(kind, visit); }, excitation);
  if (friction) {
    auto& [static_coefficient, kinetic_coefficient, kinetic_ratio] = *friction;
    visit({Source::mean_static_friction, "static friction", "/friction/static"}, static_coefficient);
    if (!kinetic_ratio) {
      visit({Source::mean_kinetic_friction, "kinetic friction", "/friction/kinetic"}, kinetic_coefficient);
    }
  }
  auto& [tilt, tilt_rate, slip_rate] = initial;
  visit({Source::tilt, "initial tilt", "/initial/tilt"}, tilt);
  visit({Source::tilt_rate, "initial tilt rate", "/initial/tilt_rate"}, tilt_rate);
  visit({Source::slip_rate, "initial slip rate", "/initial/slip_rate"}, slip_rate);
}

}  // namespace rocking
