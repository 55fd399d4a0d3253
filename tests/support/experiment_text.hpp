#pragma once

#include <string>

#include "rocking/text/json.hpp"

namespace rocking::support {

/// The experiment file that the documents give as an example.
inline Json example_experiment() {
  return Json::parse(R"({
    "format": "rocking.experiment/1",
    "title": "Does the same shaking give the same rocking?",
    "block": { "width_m": 1.0, "height_m": 4.0, "gravity_m_s2": 9.81 },
    "formulation": "consistent",
    "excitation": { "kind": "harmonic", "amplitude": 4.2, "frequency_ratio": 10.0, "phase_rad": 0.0 },
    "friction": { "static": 0.35, "kinetic": 0.30 },
    "fluctuation": { "friction": { "sigma": 0.03, "refreshes_per_period": 200 } },
    "initial": { "tilt": 0.0, "tilt_rate": 0.0 },
    "horizon": { "transient_periods": 500, "sampled_periods": 120 },
    "accuracy": { "tolerance": 1e-10 },
    "sweep": [ { "parameter": "/excitation/amplitude", "from": 3.0, "to": 5.0, "step": 0.1 } ],
    "realisations": 200,
    "confidence": 0.95,
    "seed": "0x2012" })");
}

/// The smallest valid experiment file.
inline Json least_experiment() {
  return Json::parse(R"({
    "format": "rocking.experiment/1",
    "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "amplitude": 4.2, "frequency_ratio": 10.0 } })");
}

/// `document` with the JSON text `value` at `pointer`.
inline Json with(Json document, const std::string& pointer, const std::string& value) {
  document[Json::json_pointer(pointer)] = Json::parse(value);
  return document;
}

/// `document` without the key `key`.
inline Json without(Json document, const std::string& key) {
  document.erase(key);
  return document;
}

}  // namespace rocking::support
