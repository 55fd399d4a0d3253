#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "rocking/scene/experiment.hpp"
#include "support/excitation.hpp"

/// The reference trajectories of tests/reference as conditions.
namespace rocking::tests {

inline const std::filesystem::path reference_folder = std::filesystem::path(ROCKING_SOURCE_DIR) / "tests" / "reference";

inline nlohmann::json load_reference(const std::string& name) {
  std::ifstream stream(reference_folder / (name + ".json"));
  return nlohmann::json::parse(stream);
}

/// Numbers are given as exact decimals in strings.
inline double reference_number(const nlohmann::json& text) {
  const auto value = text.get<std::string>();
  return value == "pi/2" ? 0x1.921fb54442d18p+0 : std::stod(value);
}

inline Condition condition_of_reference(const nlohmann::json& reference) {
  const auto number = reference_number;
  const nlohmann::json& params = reference["params"];
  const nlohmann::json& initial = reference["initial"];
  Condition condition;
  Scene& scene = condition.scene;
  scene.block = {.width = number(params["B"]), .height = number(params["H"]), .gravity = number(params["g"])};
  support::harmonic(scene).amplitude = number(params["A_h"]);
  support::harmonic(scene).frequency_ratio = number(params["Omega"]);
  support::harmonic(scene).phase = number(params["Phi"]);
  scene.restitution = number(params["e"]);
  if (params["sliding"].get<bool>()) {
    scene.friction =
        Friction{.static_coefficient = number(params["mu_s"]), .kinetic_coefficient = number(params["mu_k"])};
  }
  if (params["inertia"] != "centroidal_gamma_3") scene.slide_inertia = dynamics::SlideInertia::edge;
  if (params["impact_rule"] != "physical_abs") scene.impact_slip_rule = dynamics::ImpactSlipRule::signed_ratio;
  scene.initial = {.tilt = number(initial["Theta"]),
                   .tilt_rate = number(initial["dTheta_dtau"]),
                   .slip_rate = number(initial["dX_dtau"])};
  return condition;
}

inline std::vector<std::string> reference_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(reference_folder)) {
    const std::string stem = entry.path().stem().string();
    if (entry.path().extension() == ".json" && stem != "attainable") names.push_back(stem);
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace rocking::tests
