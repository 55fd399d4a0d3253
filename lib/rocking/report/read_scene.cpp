#include "rocking/report/read_scene.hpp"

#include <array>
#include <string>
#include <string_view>

#include "rocking/report/read_quantity.hpp"
#include "rocking/report/rules.hpp"

namespace rocking::report {
namespace {

using dynamics::ImpactSlipRule;
using dynamics::SlideInertia;

constexpr std::array<std::string_view, 3> formulation_names{"consistent", "as-printed", "as-plotted"};
constexpr std::array<std::string_view, 2> slide_inertia_names{"centroidal", "edge"};
constexpr std::array<std::string_view, 2> impact_slip_rule_names{"absolute", "signed"};
constexpr std::string_view jy25 = "jy25";

// What a formulation stands for: indices into the names above.
struct Options {
  SlideInertia slide_inertia;
  bool jy25_restitution;
  ImpactSlipRule impact_slip_rule;
};
constexpr std::array<Options, 3> formulations{{
    {SlideInertia::centroidal, false, ImpactSlipRule::absolute},
    {SlideInertia::edge, true, ImpactSlipRule::signed_ratio},
    {SlideInertia::edge, false, ImpactSlipRule::signed_ratio},
}};

dynamics::Block read_block(ObjectReader& in) {
  dynamics::Block block;
  in.object("block", [&](ObjectReader& keys) {
    block.width = keys.number("width_m", rules::length);
    block.height = keys.number("height_m", rules::length);
    block.gravity = keys.number("gravity_m_s2", rules::gravity);
  });
  return block;
}

/// Jeong & Yang (2012) Eq. 25, e = 1 - (3/2) sin^2(psi): Housner's ratio of rates, put in the place of the restitution.
double jy25_restitution(const dynamics::Block& block) {
  if (!(block.width > 0.0 && block.height > 0.0)) return 0.0;  // already reported
  const double sine = dynamics::geometry_of(block).sine;
  return 1.0 - 1.5 * sine * sine;
}

double read_restitution(ObjectReader& in, const dynamics::Block& block, bool jy25_by_default) {
  const Json* found = in.value("restitution");
  if (found == nullptr ? jy25_by_default : *found == jy25) {
    in.write("restitution", jy25);
    return jy25_restitution(block);
  }
  if (found != nullptr && found->is_string()) {
    in.reject("restitution", std::string(rules::restitution.demand),
              "write a number, or \"jy25\" for 1 - 1.5 sin^2(psi)");
    return 0.0;
  }
  NumberRule rule = rules::restitution;
  rule.standard = 0.0;
  return in.number("restitution", rule);
}

void read_formulation(ObjectReader& in, experiment::Scene& scene, DefaultSpelling spelling) {
  const Options options = formulations[in.choice("formulation", formulation_names, 0)];
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
    scene.restitution = read_restitution(in, scene.block, options.jy25_restitution);
  } else {
    scene.restitution = options.jy25_restitution ? jy25_restitution(scene.block) : 0.0;
  }
  if (write_out("impact_slip_rule")) {
    const auto standard = static_cast<std::size_t>(options.impact_slip_rule);
    scene.impact_slip_rule =
        static_cast<ImpactSlipRule>(in.choice("impact_slip_rule", impact_slip_rule_names, standard));
  }
}

std::optional<experiment::Friction> read_friction(ObjectReader& in) {
  if (!in.has("friction")) return std::nullopt;
  experiment::Friction friction;
  in.object("friction", [&](ObjectReader& keys) {
    friction.static_coefficient = keys.number("static", rules::friction_coefficient);
    friction.kinetic_coefficient = keys.number("kinetic", rules::friction_coefficient);
  });
  return friction;
}

experiment::InitialState read_initial(ObjectReader& in, bool slides) {
  experiment::InitialState initial;
  in.object("initial", [&](ObjectReader& keys) {
    initial.tilt = read_quantity(keys, "tilt", rules::initial_value);
    initial.tilt_rate = read_quantity(keys, "tilt_rate", rules::initial_value);
    if (slides || keys.has("slip_rate")) initial.slip_rate = read_quantity(keys, "slip_rate", rules::initial_value);
  });
  return initial;
}

}  // namespace

experiment::Scene read_scene(ObjectReader& in, const SceneReading& reading) {
  experiment::Scene scene;
  scene.block = read_block(in);
  read_formulation(in, scene, reading.options);
  scene.excitation = read_excitation(in, scene.block, reading);
  scene.friction = read_friction(in);
  read_fluctuation(in, scene);
  scene.initial = read_initial(in, scene.friction.has_value());
  return scene;
}

}  // namespace rocking::report
