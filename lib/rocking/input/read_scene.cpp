#include "rocking/input/read_scene.hpp"

#include <array>
#include <string>
#include <string_view>
#include <variant>

#include "rocking/input/read_excitation.hpp"
#include "rocking/input/read_fluctuation.hpp"
#include "rocking/input/read_quantity.hpp"
#include "rocking/scene/defaults.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

using dynamics::ImpactSlipRule;
using dynamics::SlideInertia;

// In the order of the enumerators.
constexpr std::array<std::string_view, 3> formulation_names{"consistent", "as-printed", "as-plotted"};
constexpr std::array<std::string_view, 2> slide_inertia_names{"centroidal", "edge"};
constexpr std::array<std::string_view, 2> impact_slip_rule_names{"absolute", "signed"};
constexpr std::string_view jy25 = "jy25";

SceneBlock read_block(ObjectReader& in) {
  SceneBlock block;
  in.object("block", [&](ObjectReader& keys) {
    read_value(keys, "width_m", rules::length, block.width);
    read_value(keys, "height_m", rules::length, block.height);
    read_value(keys, "gravity_m_s2", rules::gravity.with_default(block.gravity), block.gravity);
  });
  return block;
}

Restitution read_restitution(ObjectReader& in, bool jy25_by_default) {
  const Json* found = in.value("restitution");
  if (found == nullptr ? jy25_by_default : *found == jy25) {
    in.write("restitution", jy25);
    return Jy25Restitution{};
  }
  if (found != nullptr && found->is_object()) {
    RateRatio ratio;
    in.object("restitution",
              [&ratio](ObjectReader& keys) { ratio.value = keys.number("rate_ratio", rules::rate_ratio); });
    return ratio;
  }
  if (found != nullptr && found->is_string()) {
    in.reject("restitution", std::string(rules::restitution.demand),
              "write a number, \"jy25\" for 1 - 1.5 sin^2(psi), or {\"rate_ratio\": 0.93} for a measured ratio of the "
              "tilt rates");
    return Scene{}.restitution;
  }
  const double standard = std::get<double>(Scene{}.restitution);
  return in.number("restitution", rules::restitution.with_default(standard));
}

void read_formulation(ObjectReader& in, Scene& scene, DefaultSpelling spelling) {
  constexpr auto by_default = static_cast<std::size_t>(Formulation::consistent);
  const auto formulation = static_cast<Formulation>(in.choice("formulation", formulation_names, by_default));
  const FormulationOptions options = options_of(formulation);
  scene.slide_inertia = options.slide_inertia;
  scene.impact_slip_rule = options.impact_slip_rule;
  const auto write_out = [&in, spelling](std::string_view key) {
    return in.has(key) || spelling == DefaultSpelling::all;
  };
  if (write_out("slide_inertia")) {
    const auto standard = static_cast<std::size_t>(options.slide_inertia);
    scene.slide_inertia = static_cast<SlideInertia>(in.choice("slide_inertia", slide_inertia_names, standard));
  }
  if (write_out("restitution")) {
    scene.restitution = read_restitution(in, options.is_jy25);
  } else if (options.is_jy25) {
    scene.restitution = Jy25Restitution{};
  }
  if (write_out("impact_slip_rule")) {
    const auto standard = static_cast<std::size_t>(options.impact_slip_rule);
    scene.impact_slip_rule =
        static_cast<ImpactSlipRule>(in.choice("impact_slip_rule", impact_slip_rule_names, standard));
  }
}

std::optional<Friction> read_friction(ObjectReader& in) {
  if (!in.has("friction")) return std::nullopt;
  Friction friction;
  in.object("friction", [&](ObjectReader& keys) {
    friction.static_coefficient = keys.number("static", rules::friction_coefficient);
    friction.kinetic_coefficient = keys.number("kinetic", rules::friction_coefficient);
  });
  return friction;
}

NumberRule initial_rule(const Quantity& standard) { return rules::initial_value.with_default(mean_of(standard)); }

InitialState read_initial(ObjectReader& in, bool slides) {
  InitialState initial;
  in.object("initial", [&](ObjectReader& keys) {
    read_value(keys, "tilt", initial_rule(initial.tilt), initial.tilt);
    read_value(keys, "tilt_rate", initial_rule(initial.tilt_rate), initial.tilt_rate);
    if (!slides && !keys.has("slip_rate")) return;
    read_value(keys, "slip_rate", initial_rule(initial.slip_rate), initial.slip_rate);
  });
  return initial;
}

}  // namespace

Scene read_scene(ObjectReader& in, const SceneReading& reading) {
  Scene scene;
  scene.block = read_block(in);
  read_formulation(in, scene, reading.options);
  scene.excitation = read_excitation(in, mean_block(scene), reading);
  scene.friction = read_friction(in);
  read_fluctuation(in, scene);
  scene.initial = read_initial(in, scene.friction.has_value());
  return scene;
}

}  // namespace rocking
