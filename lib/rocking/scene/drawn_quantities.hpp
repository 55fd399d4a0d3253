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

/// A number of a block that may have a law.
struct BlockNumber {
  random::Source source;
  std::string_view name;   ///< in words
  std::string_view place;  ///< JSON pointer into an experiment file
  bool is_length = true;   ///< positive, and truncated to the bounds where it is drawn
};

/// Of number `k` of part `part`, in the order of the members of BlockPart.
[[nodiscard]] BlockNumber part_number(std::size_t part, std::size_t k);

/// Calls visit(BlockNumber, quantity) for each number that the form of the block has.
template <class ABlock, class Visit>
void for_each_block_number(ABlock& block, const Visit& visit) {
  using random::Source;
  auto& [width, height, gravity, mass] = block;
  const auto visit_mass = [&visit, &width = width, &height = height](auto& form) {
    using MassForm = std::remove_cvref_t<decltype(form)>;
    if constexpr (std::is_same_v<MassForm, GivenEdges>) {
      auto& [edges, centre_height, radius] = form;
      visit(BlockNumber{Source::left_edge, "distance of the left edge", "/block/edges_m/0"}, edges[0]);
      visit(BlockNumber{Source::right_edge, "distance of the right edge", "/block/edges_m/1"}, edges[1]);
      visit(BlockNumber{Source::centre_height, "height of the centre of mass", "/block/centre_height_m"},
            centre_height);
      visit(BlockNumber{Source::radius_of_gyration, "radius of gyration", "/block/radius_of_gyration_m"}, radius);
    } else if constexpr (std::is_same_v<MassForm, GivenParts>) {
      for (std::size_t i = 0; i < form.parts.size(); ++i) {
        auto& [part_width, part_height, part_mass, x, bottom] = form.parts[i];
        visit(part_number(i, 0), part_width);
        visit(part_number(i, 1), part_height);
        visit(part_number(i, 2), part_mass);
        visit(part_number(i, 3), x);
        visit(part_number(i, 4), bottom);
      }
      if (!form.base) return;
      visit(BlockNumber{Source::base_left, "left end of the base", "/block/base_m/0", false}, (*form.base)[0]);
      visit(BlockNumber{Source::base_right, "right end of the base", "/block/base_m/1", false}, (*form.base)[1]);
    } else {
      visit(BlockNumber{Source::block_width, "width of the block", "/block/width_m"}, width);
      visit(BlockNumber{Source::block_height, "height of the block", "/block/height_m"}, height);
      if constexpr (std::is_same_v<MassForm, GivenCentre>) {
        auto& [centre_height, offset, radius] = form;
        if (centre_height) {
          visit(BlockNumber{Source::centre_height, "height of the centre of mass", "/block/centre_height_m"},
                *centre_height);
        }
        if (offset) {
          visit(BlockNumber{Source::centre_offset, "offset of the centre of mass", "/block/centre_offset_m", false},
                *offset);
        }
        if (radius) {
          visit(BlockNumber{Source::radius_of_gyration, "radius of gyration", "/block/radius_of_gyration_m"}, *radius);
        }
      }
    }
  };
  std::visit(visit_mass, mass);
}

namespace quantities {

[[nodiscard]] inline std::string_view place_of(const std::optional<PhysicalAmplitude>& physical) {
  if (!physical) return "/excitation/amplitude";
  return physical->unit == AccelerationUnit::gravity ? "/excitation/amplitude_g" : "/excitation/amplitude_m_s2";
}

[[nodiscard]] inline std::string_view place_of(const std::optional<PhysicalFrequency>& physical) {
  if (!physical) return "/excitation/frequency_ratio";
  return physical->unit == FrequencyUnit::hertz ? "/excitation/frequency_hz" : "/excitation/period_s";
}

[[nodiscard]] inline std::string_view place_of_vertical(const std::optional<PhysicalAmplitude>& physical) {
  if (!physical) return "/excitation/vertical/amplitude";
  return physical->unit == AccelerationUnit::gravity ? "/excitation/vertical/amplitude_g"
                                                     : "/excitation/vertical/amplitude_m_s2";
}

[[nodiscard]] inline std::string_view place_of_vertical(const std::optional<PhysicalFrequency>& physical) {
  if (!physical) return "/excitation/vertical/frequency_ratio";
  return physical->unit == FrequencyUnit::hertz ? "/excitation/vertical/frequency_hz" : "/excitation/vertical/period_s";
}

[[nodiscard]] inline std::string_view place_of_tilt(const InitialUnits& units) {
  return units.tilt == StateUnit::si ? "/initial/tilt_rad" : "/initial/tilt";
}
[[nodiscard]] inline std::string_view place_of_tilt_rate(const InitialUnits& units) {
  return units.tilt_rate == StateUnit::si ? "/initial/tilt_rate_rad_s" : "/initial/tilt_rate";
}
[[nodiscard]] inline std::string_view place_of_slip(const InitialUnits& units) {
  return units.slip == StateUnit::si ? "/initial/slip_m" : "/initial/slip";
}
[[nodiscard]] inline std::string_view place_of_slip_rate(const InitialUnits& units) {
  return units.slip_rate == StateUnit::si ? "/initial/slip_rate_m_s" : "/initial/slip_rate";
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
  if constexpr (requires { kind.vertical; }) {
    if (!kind.vertical) return;
    auto& [amplitude, frequency, phase, physical_amplitude, physical_frequency] = *kind.vertical;
    visit({Source::vertical_size, "vertical amplitude", place_of_vertical(physical_amplitude)},
          physical_amplitude ? physical_amplitude->value : amplitude);
    visit({Source::vertical_frequency, "vertical frequency", place_of_vertical(physical_frequency)},
          physical_frequency ? physical_frequency->value : frequency);
    visit({Source::vertical_phase, "vertical phase", "/excitation/vertical/phase_rad"}, phase);
  }
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
  for (const RestitutionNumber& number : numbers_of(restitution)) {
    using Number = std::conditional_t<std::is_const_v<AScene>, const Quantity, Quantity>;
    if (number.value != nullptr) visit({number.source, number.name, number.place}, const_cast<Number&>(*number.value));
  }
  std::visit([&visit](auto& kind) { quantities::visit_excitation(kind, visit); }, excitation);
  if (friction) {
    auto& [static_coefficient, kinetic_coefficient, kinetic_ratio] = *friction;
    visit({Source::mean_static_friction, "static friction", "/friction/static"}, static_coefficient);
    if (!kinetic_ratio) {
      visit({Source::mean_kinetic_friction, "kinetic friction", "/friction/kinetic"}, kinetic_coefficient);
    }
  }
  auto& [tilt, tilt_rate, slip, slip_rate, units] = initial;
  visit({Source::tilt, "initial tilt", quantities::place_of_tilt(units)}, tilt);
  visit({Source::tilt_rate, "initial tilt rate", quantities::place_of_tilt_rate(units)}, tilt_rate);
  visit({Source::slip, "initial slip", quantities::place_of_slip(units)}, slip);
  visit({Source::slip_rate, "initial slip rate", quantities::place_of_slip_rate(units)}, slip_rate);
}

}  // namespace rocking
