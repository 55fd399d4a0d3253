#include "rocking/output/orbits_table.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include "rocking/output/mode_table.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

std::string mode_of(const Orbit& orbit) { return to_string(section::periodic(orbit.cycles, orbit.period)); }

/// Modulus of the largest multiplier.
std::string largest_multiplier(const Stability& stability) {
  if (stability.kind == OrbitKind::not_differentiable) return "-";
  return significant(stability.multipliers.empty() ? 0.0 : std::abs(stability.multipliers.front()), 4);
}

std::string both(const std::array<BranchEnd, 2>& ends) {
  return std::string(to_string(ends[0])) + ", " + std::string(to_string(ends[1]));
}

/// A row for each orbit of a condition.
std::string orbits_of_conditions(const std::vector<OrbitsOfCondition>& conditions) {
  std::vector<TextRow> rows(1);
  for (const Parameter& parameter : conditions.front().parameters) rows[0].push_back(last_key(parameter.pointer));
  for (const char* name :
       {"orbit", "contact", "kind", "multiplier", "tilt", "tilt_rate", "found by", "mirror", "run"}) {
    rows[0].emplace_back(name);
  }
  for (const OrbitsOfCondition& condition : conditions) {
    for (std::size_t i = 0; i < condition.orbits.size(); ++i) {
      const Orbit& orbit = condition.orbits[i];
      const SectionState& start = orbit.points.front();
      TextRow& row = rows.emplace_back();
      for (const Parameter& parameter : condition.parameters) row.push_back(short_value(parameter));
      row.insert(row.end(),
                 {mode_of(orbit), std::string(to_string(start.contact)), std::string(to_string(orbit.stability.kind)),
                  largest_multiplier(orbit.stability), significant(start.point.tilt, 4),
                  significant(start.point.tilt_rate, 4), std::string(to_string(orbit.found_by)),
                  orbit.is_symmetric ? "itself" : "another", condition.run_on == i ? "*" : ""});
    }
  }
  return aligned(rows);
}

/// A row for each branch and one for each bifurcation.
std::string branches_table(const FoundBranches& found) {
  const BranchStudy& study = found.study;
  const std::string parameter = last_key(found.pointer);
  std::vector<TextRow> branches{{"branch", "orbits", "symmetric", "points", parameter + " from", "to", "ends"}};
  for (std::size_t i = 0; i < study.branches.size(); ++i) {
    const OrbitBranch& branch = study.branches[i];
    const auto [low, high] = std::ranges::minmax(branch.points, {}, &BranchPoint::value);
    branches.push_back({std::to_string(i), mode_of(branch.points.front().orbit), branch.is_symmetric ? "yes" : "no",
                        std::to_string(branch.points.size()), significant(low.value, 8), significant(high.value, 8),
                        both(branch.ends)});
  }
  std::vector<TextRow> bifurcations{{"bifurcation", "branch", parameter, "error", "orbit"}};
  for (const Bifurcation& one : study.bifurcations) {
    bifurcations.push_back({std::string(to_string(one.kind)), std::to_string(one.branch), significant(one.value, 12),
                            significant(one.error, 1), one.orbit ? mode_of(*one.orbit) : "-"});
  }
  std::string text = '\n' + aligned(branches);
  if (!study.is_complete) text += "There are more: the largest number of branches was reached.\n";
  if (!study.bifurcations.empty()) text += '\n' + aligned(bifurcations);
  return text + '\n';
}

/// A row for each curve.
std::string curves_table(const FoundCurves& found, const FoundBranches& branches) {
  if (found.curves.empty()) return "No fold, period doubling or loss of symmetry to follow.\n\n";
  const std::string first = last_key(branches.pointer);
  const std::string second = last_key(found.pointers.front());
  std::vector<TextRow> rows{
      {"curve", "branch", "orbits", "points", first + " from", "to", second + " from", "to", "ends"}};
  for (const BifurcationCurve& curve : found.curves) {
    const auto [low, high] = std::ranges::minmax(curve.points, {}, &BifurcationPoint::value);
    const auto [lower, higher] = std::ranges::minmax(curve.points, {}, &BifurcationPoint::second_value);
    rows.push_back({std::string(to_string(curve.kind)),
                    std::to_string(branches.study.bifurcations[curve.bifurcation].branch),
                    mode_of(curve.points.front().orbit), std::to_string(curve.points.size()), significant(low.value, 8),
                    significant(high.value, 8), significant(lower.second_value, 8), significant(higher.second_value, 8),
                    both(curve.ends)});
  }
  return aligned(rows) + '\n';
}

/// How many response modes (m,n) are backed by an orbit, and the conditions of those that are not.
std::string labels_note(const OrbitStudy& study) {
  const OrbitLabels labels = labels_of(study);
  if (labels.periodic == 0) return "";
  std::string text = std::to_string(labels.certified) + " of " + std::to_string(labels.periodic) +
                     " responses (m,n) of runs are backed by a stable orbit of this m and n, found by Newton's method";
  if (labels.not_certified.empty()) return text + "\n";
  text += "; not:\n";
  for (const std::size_t i : labels.not_certified) {
    std::string where;
    for (const Parameter& parameter : study.conditions[i].parameters) {
      where += (where.empty() ? "" : ", ") + last_key(parameter.pointer) + ' ' + short_value(parameter);
    }
    text += "  " + (where.empty() ? "the condition" : where) + ": " + to_string(study.conditions[i].mode) + '\n';
  }
  return text;
}

}  // namespace

std::string table_of(const OrbitStudy& study) {
  std::string text = orbits_of_conditions(study.conditions);
  if (study.branches) text += branches_table(*study.branches);
  if (study.curves) text += curves_table(*study.curves, *study.branches);
  return text +
         "tilt, tilt_rate: where the argument of the excitation is 0; multiplier: modulus of the largest one; *: the "
         "run\nfrom the initial state ended on this orbit. Other orbits may exist: the search is from a finite "
         "grid.\n" +
         labels_note(study);
}

}  // namespace rocking
