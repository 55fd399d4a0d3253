#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "rocking/random/source.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {

/// A number of a block that may have a law.
struct BlockNumber : QuantityPlace {
  bool is_length = true;  ///< positive, and truncated to the bounds where it is drawn
};

/// Of number `k` of part `part`, in the order of the members of BlockPart.
[[nodiscard]] BlockNumber part_number(std::size_t part, std::size_t k);

/// A number of a building that may have a law.
struct BuildingNumber : QuantityPlace {
  const Rule* rule = nullptr;  ///< that a drawn one must keep; null: any
};

/// Of number `k` of mode `i` of a building, in the order of the members of BuildingMode.
[[nodiscard]] BuildingNumber mode_number(std::size_t i, std::size_t k);

/// Calls visit(BlockNumber, quantity) for each number that the form of the block has.
template <class ABlock, class Visit>
void for_each_block_number(ABlock& block, const Visit& visit) {
  using random::Source;
  auto& [width, height, gravity, mass, wall] = block;
  const auto visit_mass = [&visit, &width = width, &height = height](auto& form) {
    using MassForm = std::remove_cvref_t<decltype(form)>;
    if constexpr (std::is_same_v<MassForm, GivenEdges>) {
      auto& [edges, centre_height, radius] = form;
      visit(BlockNumber{{{"/block/edges_m/0", "distance of the left edge"}, Source::left_edge}}, edges[0]);
      visit(BlockNumber{{{"/block/edges_m/1", "distance of the right edge"}, Source::right_edge}}, edges[1]);
      visit(BlockNumber{{{"/block/centre_height_m", "height of the centre of mass"}, Source::centre_height}},
            centre_height);
      visit(BlockNumber{{{"/block/radius_of_gyration_m", "radius of gyration"}, Source::radius_of_gyration}}, radius);
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
      visit(BlockNumber{{{"/block/base_m/0", "left end of the base"}, Source::base_left}, false}, (*form.base)[0]);
      visit(BlockNumber{{{"/block/base_m/1", "right end of the base"}, Source::base_right}, false}, (*form.base)[1]);
    } else if constexpr (!std::is_same_v<MassForm, GivenSlenderness>) {  // which has no numbers with laws
      visit(BlockNumber{{{"/block/width_m", "width", "B"}, Source::block_width}}, width);
      visit(BlockNumber{{{"/block/height_m", "height", "H"}, Source::block_height}}, height);
      if constexpr (std::is_same_v<MassForm, GivenCentre>) {
        auto& [centre_height, offset, radius] = form;
        if (centre_height) {
          visit(BlockNumber{{{"/block/centre_height_m", "height of the centre of mass"}, Source::centre_height}},
                *centre_height);
        }
        if (offset) {
          visit(BlockNumber{{{"/block/centre_offset_m", "offset of the centre of mass"}, Source::centre_offset}, false},
                *offset);
        }
        if (radius) {
          visit(BlockNumber{{{"/block/radius_of_gyration_m", "radius of gyration"}, Source::radius_of_gyration}},
                *radius);
        }
      }
    }
  };
  std::visit(visit_mass, mass);
}

namespace quantities {

/// In the order of the units: the normalised number, then AccelerationUnit or FrequencyUnit.
inline constexpr std::array<NamedPlace, 3> amplitudes{{{"/excitation/amplitude", "base amplitude", "A_h"},
                                                       {"/excitation/amplitude_g", "base amplitude"},
                                                       {"/excitation/amplitude_m_s2", "base amplitude"}}};
inline constexpr std::array<NamedPlace, 3> frequencies{{{"/excitation/frequency_ratio", "frequency ratio", "Ω_h"},
                                                        {"/excitation/frequency_hz", "base frequency"},
                                                        {"/excitation/period_s", "base period"}}};
inline constexpr std::array<NamedPlace, 3> vertical_amplitudes{
    {{"/excitation/vertical/amplitude", "vertical amplitude", "A_v"},
     {"/excitation/vertical/amplitude_g", "vertical amplitude"},
     {"/excitation/vertical/amplitude_m_s2", "vertical amplitude"}}};
inline constexpr std::array<NamedPlace, 3> vertical_frequencies{
    {{"/excitation/vertical/frequency_ratio", "vertical frequency ratio", "Ω_v"},
     {"/excitation/vertical/frequency_hz", "vertical frequency"},
     {"/excitation/vertical/period_s", "vertical period"}}};
/// Of a ground motion, in the order of all_strengths.
inline constexpr std::array<NamedPlace, all_strengths.size()> strengths{
    {{"/excitation/scale", "scale of the ground motion"},
     {"/excitation/pga_g", "peak ground acceleration", "PGA"},
     {"/excitation/pgv_m_s", "peak ground velocity", "PGV"},
     {"/excitation/sa_g", "spectral acceleration", "PSa"},
     {"/excitation/sa_p_g", "spectral acceleration at 2π/p", "PSa"},
     {"/excitation/avgsa_g", "average spectral acceleration", "avgSa"},
     {"/excitation/sa_absolute_g", "absolute spectral acceleration"}}};
/// In the order of StateUnit.
inline constexpr std::array<NamedPlace, 3> tilts{{{"/initial/tilt", "initial tilt", "Θ_0"},
                                                  {"/initial/tilt_rad", "initial tilt", "θ_0"},
                                                  {"/initial/tilt_deg", "initial tilt", "θ_0"}}};
inline constexpr std::array<NamedPlace, 2> tilt_rates{
    {{"/initial/tilt_rate", "initial tilt rate", "Θ′_0"}, {"/initial/tilt_rate_rad_s", "initial tilt rate"}}};
inline constexpr std::array<NamedPlace, 2> slips{
    {{"/initial/slip", "initial slip", "X_0"}, {"/initial/slip_m", "initial slip"}}};
inline constexpr std::array<NamedPlace, 2> slip_rates{
    {{"/initial/slip_rate", "initial slip rate", "V_0"}, {"/initial/slip_rate_m_s", "initial slip rate"}}};

template <class Physical>
[[nodiscard]] constexpr const NamedPlace& in_unit_of(const std::optional<Physical>& physical,
                                                     const std::array<NamedPlace, 3>& units) {
  return units[physical ? static_cast<std::size_t>(physical->unit) + 1 : 0];
}
template <std::size_t size>
[[nodiscard]] constexpr const NamedPlace& in_unit(StateUnit unit, const std::array<NamedPlace, size>& units) {
  return units[static_cast<std::size_t>(unit)];
}

/// Constant or not.
template <class ABuilding, class Visit>
void visit_building(ABuilding& building, const Visit& visit) {
  using random::Source;
  auto& [frequency, damping, height, uniform_modes, modes] = building;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    auto& [own_frequency, own_damping, factor] = modes[i];
    visit(mode_number(i, 0), own_frequency);
    visit(mode_number(i, 1), own_damping);
    visit(mode_number(i, 2), factor);
  }
  if (!modes.empty()) return;
  visit(BuildingNumber{{{"/excitation/building/frequency_hz", "frequency of the building", "f_1"},
                        Source::building_frequency},
                       &rules::building_frequency_hz},
        frequency);
  visit(BuildingNumber{{{"/excitation/building/damping_ratio", "damping ratio of the building"},
                        Source::building_damping},
                       &rules::damping_ratio},
        damping);
  visit(BuildingNumber{{{"/excitation/building/height_ratio", "height of the floor over that of the building"},
                        Source::building_height},
                       &rules::height_ratio},
        height);
}

/// Of any kind of excitation, constant or not.
template <class Kind, class Visit>
void visit_excitation(Kind& kind, const Visit& visit) {
  using random::Source;
  if constexpr (requires { kind.physical_amplitude; }) {
    auto& amplitude = kind.physical_amplitude;
    visit({in_unit_of(amplitude, amplitudes), Source::excitation_size}, amplitude ? amplitude->value : kind.amplitude);
    auto& frequency = kind.physical_frequency;
    visit({in_unit_of(frequency, frequencies), Source::excitation_frequency},
          frequency ? frequency->value : kind.frequency_ratio);
  }
  if constexpr (requires { kind.scale; }) {
    visit({strengths[0], Source::excitation_size}, kind.scale);
  }
  if constexpr (requires { kind.building; }) {
    if (kind.building) {
      visit_building(*kind.building,
                     [&visit](const BuildingNumber& what, auto& number) { visit(QuantityPlace(what), number); });
    }
  }
  if constexpr (requires { kind.phase; }) visit({{"/excitation/phase_rad", "phase", "Φ"}, Source::phase}, kind.phase);
  if constexpr (requires { kind.vertical; }) {
    if (!kind.vertical) return;
    auto& [amplitude, frequency, phase, physical_amplitude, physical_frequency] = *kind.vertical;
    visit({in_unit_of(physical_amplitude, vertical_amplitudes), Source::vertical_size},
          physical_amplitude ? physical_amplitude->value : amplitude);
    visit({in_unit_of(physical_frequency, vertical_frequencies), Source::vertical_frequency},
          physical_frequency ? physical_frequency->value : frequency);
    visit({{"/excitation/vertical/phase_rad", "vertical phase", "Φ_v"}, Source::vertical_phase}, phase);
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
  for_each_block_number(block, [&visit](const BlockNumber& what, auto& number) { visit(QuantityPlace(what), number); });
  for (const RestitutionNumber& number : numbers_of(restitution)) {
    using Number = std::conditional_t<std::is_const_v<AScene>, const Quantity, Quantity>;
    if (number.value != nullptr) visit(QuantityPlace(number), const_cast<Number&>(*number.value));
  }
  std::visit([&visit](auto& kind) { quantities::visit_excitation(kind, visit); }, excitation);
  if (friction) {
    auto& [static_coefficient, kinetic_coefficient, kinetic_ratio] = *friction;
    visit({{"/friction/static", "static friction", "μ_s"}, Source::mean_static_friction}, static_coefficient);
    if (!kinetic_ratio) {
      visit({{"/friction/kinetic", "kinetic friction", "μ_k"}, Source::mean_kinetic_friction}, kinetic_coefficient);
    }
  }
  auto& [tilt, tilt_rate, slip, slip_rate, units] = initial;
  visit({quantities::in_unit(units.tilt, quantities::tilts), Source::tilt}, tilt);
  visit({quantities::in_unit(units.tilt_rate, quantities::tilt_rates), Source::tilt_rate}, tilt_rate);
  visit({quantities::in_unit(units.slip, quantities::slips), Source::slip}, slip);
  visit({quantities::in_unit(units.slip_rate, quantities::slip_rates), Source::slip_rate}, slip_rate);
}

/// Where a law or a standard deviation makes a scene random, as JSON pointer; absent if nothing does.
[[nodiscard]] std::optional<std::string_view> place_of_randomness(const Scene& scene);

}  // namespace rocking
