#include "rocking/output/write_orbits.hpp"

#include <complex>
#include <cstddef>

#include "rocking/base/digest.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

Json point_json(const SectionState& state) {
  return Json::array({state.point.tilt, state.point.tilt_rate, state.point.slip_rate});
}

Json multipliers_json(const Stability& stability) {
  Json json = Json::array();
  for (const auto& multiplier : stability.multipliers) {
    json.push_back(Json::array({multiplier.real(), multiplier.imag()}));
  }
  return json;
}

bool is_known(const Stability& stability) { return stability.kind != OrbitKind::not_differentiable; }

Json orbit_json(const Orbit& orbit, std::size_t place) {
  const SectionState& start = orbit.points.front();
  Json json = Json::object();
  json["period"] = orbit.period;
  json["cycles"] = orbit.cycles;
  json["state"] = {
      {"tilt", start.point.tilt}, {"tilt_rate", start.point.tilt_rate}, {"slip_rate", start.point.slip_rate}};
  json["contact"] = to_string(start.contact);
  json["residual"] = orbit.residual;
  json["multipliers"] = multipliers_json(orbit.stability);
  json["stable"] = is_known(orbit.stability) ? Json(orbit.stability.is_stable()) : Json();
  json["kind"] = to_string(orbit.stability.kind);
  json["symmetric"] = orbit.mirror == place;
  json["mirror"] = orbit.mirror;
  json["found_by"] = to_string(orbit.found_by);
  Json& points = json["points"] = Json::array();
  for (const SectionState& state : orbit.points) points.push_back(point_json(state));
  return json;
}

Json run_json(const OrbitsOfCondition& found) {
  Json json = Json::object();
  json["termination"] = to_string(found.termination);
  json["mode"] = to_string(found.mode);
  json["orbit"] = found.run_on ? Json(*found.run_on) : Json();
  return json;
}

std::string condition_json(const OrbitsOfCondition& found, const Condition& condition) {
  std::string text = "\n    { \"parameters\": " + parameters_json(condition).dump();
  text += ",\n      \"run\": " + run_json(found).dump();
  text += ",\n      \"searches\": " + std::to_string(found.searches);
  text += ", \"converged\": " + std::to_string(found.converged) + ",\n      \"orbits\": [";
  for (std::size_t i = 0; i < found.orbits.size(); ++i) {
    text += (i == 0 ? "\n        " : ",\n        ") + orbit_json(found.orbits[i], i).dump();
  }
  return text + (found.orbits.empty() ? "] }" : "\n      ] }");
}

std::string mode_of(const Orbit& orbit) { return to_string(section::periodic(orbit.cycles, orbit.period)); }

/// Modulus of the largest multiplier.
std::string largest_multiplier(const Stability& stability) {
  if (!is_known(stability)) return "-";
  return significant(stability.multipliers.empty() ? 0.0 : std::abs(stability.multipliers.front()), 4);
}

}  // namespace

std::string orbits_text(const FoundOrbits& found) {
  const std::string& canonical = found.experiment->canonical_text;
  std::string text = "{\n  \"format\": " + Json(orbits_format).dump();
  text += ",\n  \"input\": { \"experiment\": " + canonical;
  text += ",\n    \"sha256\": " + Json(base::to_hex(base::sha256(canonical))).dump() + " }";
  text += ",\n  \"longest_period\": " + std::to_string(found.longest) + ",\n  \"conditions\": [";
  for (std::size_t i = 0; i < found.conditions.size(); ++i) {
    text += (i == 0 ? "" : ",") + condition_json(found.conditions[i], found.experiment->conditions[i]);
  }
  return text + "\n  ]\n}\n";
}

std::string orbits_table(const FoundOrbits& found) {
  TextRow heading;
  for (const Parameter& parameter : found.experiment->conditions.front().parameters) {
    heading.push_back(last_key(parameter.pointer));
  }
  for (const char* name :
       {"orbit", "contact", "kind", "multiplier", "tilt", "tilt_rate", "found by", "mirror", "run"}) {
    heading.emplace_back(name);
  }
  std::vector<TextRow> rows{heading};
  for (std::size_t c = 0; c < found.conditions.size(); ++c) {
    const OrbitsOfCondition& condition = found.conditions[c];
    for (std::size_t i = 0; i < condition.orbits.size(); ++i) {
      const Orbit& orbit = condition.orbits[i];
      const SectionState& start = orbit.points.front();
      TextRow row;
      for (const Parameter& parameter : found.experiment->conditions[c].parameters) {
        row.push_back(short_value(parameter));
      }
      row.insert(row.end(),
                 {mode_of(orbit), std::string(to_string(start.contact)), std::string(to_string(orbit.stability.kind)),
                  largest_multiplier(orbit.stability), significant(start.point.tilt, 4),
                  significant(start.point.tilt_rate, 4), std::string(to_string(orbit.found_by)),
                  orbit.mirror == i ? "itself" : "another", condition.run_on == i ? "*" : ""});
      rows.push_back(std::move(row));
    }
  }
  return aligned(rows) +
         "tilt, tilt_rate: where the argument of the excitation is 0; multiplier: modulus of the largest one; *: the "
         "run\nfrom the initial state ended on this orbit. Other orbits may exist: the search is from a finite grid.\n";
}

}  // namespace rocking
