#include "rocking/studies/orbits/study.hpp"

#include "rocking/output/provenance.hpp"

namespace rocking {
namespace {

/// Reports a place that is not in the list to which it leads.
void check_place(std::size_t at, std::size_t size, const ReadingPlace& place) {
  if (at >= size) place.reject(Json(at), "leads to none of the " + std::to_string(size) + " there");
}

void check_period(const Orbit& orbit, int period, const ReadingPlace& place) {
  if (static_cast<std::size_t>(period) == orbit.points.size() && orbit.period == period) return;
  place.at("points").reject(Json(orbit.points.size()), "differs in length from the period, " + std::to_string(period));
}

void check_condition_orbits(const OrbitsOfCondition& condition, const ReadingPlace& place) {
  const std::size_t size = condition.orbits.size();
  if (condition.run_on) check_place(*condition.run_on, size, place.at("run").at("orbit"));
  for (std::size_t i = 0; i < size; ++i) {
    const Orbit& orbit = condition.orbits[i];
    const ReadingPlace at = place.at("orbits").at(std::to_string(i));
    check_period(orbit, orbit.period, at);
    if (orbit.mirror) check_place(*orbit.mirror, size, at.at("mirror"));
  }
}

/// Reports a branch without points, and points that are not as long as its period.
void check_points(const std::vector<OrbitBranch>& list, const ReadingPlace& place) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const ReadingPlace points = place.at(std::to_string(i)).at("points");
    if (list[i].points.empty()) points.reject(Json::array(), "must not be empty");
    for (std::size_t j = 0; j < list[i].points.size(); ++j) {
      check_period(list[i].points[j].orbit, list[i].period, points.at(std::to_string(j)));
    }
  }
}

void check_branches(const OrbitStudy& study, const ReadingPlace& place) {
  const auto& [branches, bifurcations, is_complete] = study.branches->study;
  check_points(branches, place.at("branches"));
  for (std::size_t i = 0; i < branches.size(); ++i) {
    const ReadingPlace at = place.at("branches").at(std::to_string(i));
    if (branches[i].from) check_place(*branches[i].from, bifurcations.size(), at.at("from"));
  }
  for (std::size_t i = 0; i < bifurcations.size(); ++i) {
    const ReadingPlace at = place.at("bifurcations").at(std::to_string(i));
    check_place(bifurcations[i].branch, branches.size(), at.at("branch"));
    if (const auto& orbit = bifurcations[i].orbit) check_period(*orbit, orbit->period, at.at("orbit"));
  }
  for (std::size_t i = 0; i < study.conditions.size(); ++i) {
    if (swept_number(study.conditions[i], study.branches->pointer)) continue;
    place.at("conditions")
        .at(std::to_string(i))
        .at("parameters")
        .reject(Json(), "lacks a number for the parameter of the branches, " + study.branches->pointer);
  }
}

}  // namespace

void check_orbits_report(const OrbitsReport& report, const ReadingPlace& place) {
  check_input(report.input, place.at("input"));
  const OrbitStudy& study = report.study;
  for (std::size_t i = 0; i < study.conditions.size(); ++i) {
    check_condition_orbits(study.conditions[i], place.at("conditions").at(std::to_string(i)));
  }
  if (study.branches) check_branches(study, place);
}

}  // namespace rocking
