#include "rocking/output/write_orbits.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <utility>

#include "rocking/base/digest.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/provenance_fields.hpp"
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

/// What does not depend on the list in which an orbit stands.
void add_orbit_json(const Orbit& orbit, Json& json) {
  const SectionState& start = orbit.points.front();
  json["period"] = orbit.period;
  json["cycles"] = orbit.cycles;
  json["state"] = {
      {"tilt", start.point.tilt}, {"tilt_rate", start.point.tilt_rate}, {"slip_rate", start.point.slip_rate}};
  json["contact"] = to_string(start.contact);
  json["residual"] = orbit.residual;
  json["multipliers"] = multipliers_json(orbit.stability);
  json["stable"] = is_known(orbit.stability) ? Json(orbit.stability.is_stable()) : Json();
  json["kind"] = to_string(orbit.stability.kind);
}

void add_points_json(const Orbit& orbit, Json& json) {
  json["found_by"] = to_string(orbit.found_by);
  Json& points = json["points"] = Json::array();
  for (const SectionState& state : orbit.points) points.push_back(point_json(state));
}

Json orbit_json(const Orbit& orbit, std::size_t place) {
  Json json = Json::object();
  add_orbit_json(orbit, json);
  json["symmetric"] = orbit.mirror == place;
  json["mirror"] = orbit.mirror;
  add_points_json(orbit, json);
  return json;
}

/// Absent keys: `mirror`, since a branch has no list of orbits.
Json branch_point_json(const BranchPoint& point, bool is_symmetric) {
  Json json = Json::object();
  json["value"] = point.value;
  add_orbit_json(point.orbit, json);
  json["symmetric"] = is_symmetric;
  add_points_json(point.orbit, json);
  return json;
}

std::string branch_text(const OrbitBranch& branch) {
  const Json head = {{"period", branch.period},
                     {"symmetric", branch.is_symmetric},
                     {"from", branch.from ? Json(*branch.from) : Json()},
                     {"ends", Json::array({to_string(branch.ends[0]), to_string(branch.ends[1])})}};
  std::string text = "\n    { " + head.dump().substr(1);
  text.pop_back();
  text += ",\n      \"points\": [";
  bool is_first = true;
  for (const BranchPoint& point : branch.points) {
    if (point.orbit.points.empty()) continue;
    text += (is_first ? "\n        " : ",\n        ") + branch_point_json(point, branch.is_symmetric).dump();
    is_first = false;
  }
  return text + "\n      ] }";
}

Json bifurcation_json(const Bifurcation& bifurcation, bool is_symmetric) {
  Json json = Json::object();
  json["kind"] = to_string(bifurcation.kind);
  json["value"] = bifurcation.value;
  json["error"] = bifurcation.error;
  json["branch"] = bifurcation.branch;
  json["orbit"] = bifurcation.orbit.points.empty()
                      ? Json()
                      : branch_point_json({.value = bifurcation.value, .orbit = bifurcation.orbit}, is_symmetric);
  return json;
}

std::string branches_text(const FoundBranches& found) {
  const BranchStudy& study = found.study;
  std::string text = ",\n  \"parameter\": " + Json(found.pointer).dump();
  text += ",\n  \"range\": " + Json::array({found.range.low, found.range.high}).dump();
  text += ",\n  \"most_points\": " + std::to_string(found.most_points);
  text += ",\n  \"complete\": " + Json(study.is_complete).dump() + ",\n  \"branches\": [";
  for (std::size_t i = 0; i < study.branches.size(); ++i) {
    text += (i == 0 ? "" : ",") + branch_text(study.branches[i]);
  }
  text += "\n  ],\n  \"bifurcations\": [";
  for (std::size_t i = 0; i < study.bifurcations.size(); ++i) {
    const Bifurcation& one = study.bifurcations[i];
    text += (i == 0 ? "\n    " : ",\n    ") + bifurcation_json(one, study.branches[one.branch].is_symmetric).dump();
  }
  return text + "\n  ]";
}

Json curve_point_json(const BifurcationPoint& point, bool is_symmetric) {
  Json json = Json::object();
  json["value"] = point.values[0];
  json["second_value"] = point.values[1];
  add_orbit_json(point.orbit, json);
  json["symmetric"] = is_symmetric;
  json["test"] = point.test;
  add_points_json(point.orbit, json);
  return json;
}

std::string curve_text(const BifurcationCurve& curve) {
  const Json head = {{"bifurcation", curve.bifurcation},
                     {"kind", to_string(curve.kind)},
                     {"period", curve.orbits.period},
                     {"symmetric", curve.orbits.is_symmetric},
                     {"ends", Json::array({to_string(curve.ends[0]), to_string(curve.ends[1])})}};
  std::string text = "\n    { " + head.dump().substr(1);
  text.pop_back();
  text += ",\n      \"points\": [";
  bool is_first = true;
  for (const BifurcationPoint& point : curve.points) {
    if (point.orbit.points.empty()) continue;
    text += (is_first ? "\n        " : ",\n        ") + curve_point_json(point, curve.orbits.is_symmetric).dump();
    is_first = false;
  }
  return text + "\n      ] }";
}

std::string curves_text(const FoundCurves& found) {
  std::string text = ",\n  \"second_parameter\": " + Json(found.pointers).dump();
  text += ",\n  \"second_value\": " + Json(found.value).dump();
  text += ",\n  \"second_range\": " + Json::array({found.range.low, found.range.high}).dump();
  text += ",\n  \"most_curve_points\": " + std::to_string(found.most_points) + ",\n  \"curves\": [";
  for (std::size_t i = 0; i < found.curves.size(); ++i) text += (i == 0 ? "" : ",") + curve_text(found.curves[i]);
  return text + "\n  ]";
}

/// Whether the run is (m,n), and whether a stable orbit with the same m and n, on which it ended, backs that.
struct Label {
  bool is_periodic = false;
  bool is_certified = false;
};

Label label_of(const OrbitsOfCondition& found) {
  Label label{.is_periodic = found.mode.kind == section::ResponseKind::periodic};
  if (!label.is_periodic || !found.run_on) return label;
  const Orbit& orbit = found.orbits[*found.run_on];
  label.is_certified = orbit.stability.is_stable() && section::periodic(orbit.cycles, orbit.period) == found.mode;
  return label;
}

Json run_json(const OrbitsOfCondition& found) {
  Json json = Json::object();
  json["termination"] = to_string(found.termination);
  json["mode"] = to_string(found.mode);
  json["orbit"] = found.run_on ? Json(*found.run_on) : Json();
  const Label label = label_of(found);
  json["certified"] = label.is_periodic ? Json(label.is_certified) : Json();
  return json;
}

/// How many (m,n) are certified, and the conditions of those that are not.
Json labels_json(const std::vector<OrbitsOfCondition>& conditions) {
  std::size_t periodic = 0;
  std::size_t certified = 0;
  Json others = Json::array();
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const Label label = label_of(conditions[i]);
    periodic += label.is_periodic ? 1 : 0;
    certified += label.is_certified ? 1 : 0;
    if (label.is_periodic && !label.is_certified) others.push_back(i);
  }
  Json json = Json::object();
  json["periodic"] = periodic;
  json["certified"] = certified;
  json["not_certified"] = std::move(others);
  return json;
}

std::string condition_json(const OrbitsOfCondition& found, const Condition& condition) {
  std::string text = "\n    { \"parameters\": " + type_of<std::vector<Parameter>>().json(&condition.parameters).dump();
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

/// A row for each branch and one for each bifurcation; empty without branches.
std::string branches_table(const FoundOrbits& found) {
  if (!found.branches) return "";
  const BranchStudy& study = found.branches->study;
  const std::string parameter = last_key(found.branches->pointer);
  std::vector<TextRow> branches{{"branch", "orbits", "symmetric", "points", parameter + " from", "to", "ends"}};
  for (std::size_t i = 0; i < study.branches.size(); ++i) {
    const OrbitBranch& branch = study.branches[i];
    const auto [low, high] = std::ranges::minmax(branch.points, {}, &BranchPoint::value);
    branches.push_back({std::to_string(i), mode_of(branch.points.front().orbit), branch.is_symmetric ? "yes" : "no",
                        std::to_string(branch.points.size()), significant(low.value, 8), significant(high.value, 8),
                        std::string(to_string(branch.ends[0])) + ", " + std::string(to_string(branch.ends[1]))});
  }
  std::vector<TextRow> bifurcations{{"bifurcation", "branch", parameter, "error", "orbit"}};
  for (const Bifurcation& one : study.bifurcations) {
    bifurcations.push_back({std::string(to_string(one.kind)), std::to_string(one.branch), significant(one.value, 12),
                            significant(one.error, 1), one.orbit.points.empty() ? "-" : mode_of(one.orbit)});
  }
  std::string text = '\n' + aligned(branches);
  if (!study.is_complete) text += "There are more: the largest number of branches was reached.\n";
  if (!study.bifurcations.empty()) text += '\n' + aligned(bifurcations);
  return text + '\n';
}

/// A row for each curve; empty without curves.
std::string curves_table(const FoundOrbits& found) {
  if (!found.curves) return "";
  if (found.curves->curves.empty()) return "No fold, period doubling or loss of symmetry to follow.\n\n";
  const std::string first = last_key(found.branches->pointer);
  const std::string second = last_key(found.curves->pointers.front());
  std::vector<TextRow> rows{
      {"curve", "branch", "orbits", "points", first + " from", "to", second + " from", "to", "ends"}};
  for (const BifurcationCurve& curve : found.curves->curves) {
    const auto value = [](std::size_t k) { return [k](const BifurcationPoint& point) { return point.values[k]; }; };
    const auto [low, high] = std::ranges::minmax(curve.points, {}, value(0));
    const auto [lower, higher] = std::ranges::minmax(curve.points, {}, value(1));
    rows.push_back({std::string(to_string(curve.kind)),
                    std::to_string(found.branches->study.bifurcations[curve.bifurcation].branch),
                    mode_of(curve.points.front().orbit), std::to_string(curve.points.size()),
                    significant(low.values[0], 8), significant(high.values[0], 8), significant(lower.values[1], 8),
                    significant(higher.values[1], 8),
                    std::string(to_string(curve.ends[0])) + ", " + std::string(to_string(curve.ends[1]))});
  }
  return aligned(rows) + '\n';
}

/// How many response modes (m,n) are backed by an orbit, and the conditions of those that are not.
std::string labels_note(const FoundOrbits& found) {
  const Json labels = labels_json(found.conditions);
  const auto periodic = labels["periodic"].get<std::size_t>();
  if (periodic == 0) return "";
  std::string text = std::to_string(labels["certified"].get<std::size_t>()) + " of " + std::to_string(periodic) +
                     " responses (m,n) of runs are backed by a stable orbit of this m and n, found by Newton's method";
  const std::size_t conditions = labels["not_certified"].size();
  if (conditions == 0) return text + "\n";
  text += "; not:\n";
  for (const Json& index : labels["not_certified"]) {
    const auto i = index.get<std::size_t>();
    std::string where;
    for (const Parameter& parameter : found.experiment->conditions[i].parameters) {
      where += (where.empty() ? "" : ", ") + last_key(parameter.pointer) + ' ' + short_value(parameter);
    }
    text += "  " + (where.empty() ? "the condition" : where) + ": " + to_string(found.conditions[i].mode) + '\n';
  }
  return text;
}

}  // namespace

std::string orbits_text(const FoundOrbits& found) {
  const std::string& canonical = found.experiment->canonical_text;
  std::string text = "{\n  \"format\": " + Json(orbits_format).dump();
  text += ",\n  \"input\": { \"experiment\": " + canonical;
  text += ",\n    \"sha256\": " + Json(base::to_hex(base::sha256(canonical))).dump() + " }";
  text += ",\n  \"longest_period\": " + std::to_string(found.longest);
  text += ",\n  \"labels\": " + labels_json(found.conditions).dump() + ",\n  \"conditions\": [";
  for (std::size_t i = 0; i < found.conditions.size(); ++i) {
    text += (i == 0 ? "" : ",") + condition_json(found.conditions[i], found.experiment->conditions[i]);
  }
  text += "\n  ]";
  if (found.branches) text += branches_text(*found.branches);
  if (found.curves) text += curves_text(*found.curves);
  return text + "\n}\n";
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
  return aligned(rows) + branches_table(found) + curves_table(found) +
         "tilt, tilt_rate: where the argument of the excitation is 0; multiplier: modulus of the largest one; *: the "
         "run\nfrom the initial state ended on this orbit. Other orbits may exist: the search is from a finite "
         "grid.\n" +
         labels_note(found);
}

}  // namespace rocking
