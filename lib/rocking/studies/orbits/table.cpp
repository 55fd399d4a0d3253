#include "rocking/studies/orbits/table.hpp"

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

constexpr std::size_t most_ranges = 30;     ///< of conditions with the same stable orbits, on one screen
constexpr std::size_t most_not_backed = 5;  ///< conditions that are listed there

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

std::vector<std::string> modes_of_stable(const OrbitsOfCondition& condition) {
  std::vector<std::string> modes;
  for (const Orbit& orbit : condition.orbits) {
    if (orbit.stability.is_stable()) modes.push_back(mode_of(orbit));
  }
  std::ranges::sort(modes);
  return modes;
}

/// The same names once each, with how often: `2 x (1,5), (1,1)`.
std::string counted_names(const std::vector<std::string>& sorted) {
  std::string text;
  for (auto at = sorted.begin(); at != sorted.end();) {
    const auto next = std::ranges::upper_bound(at, sorted.end(), *at);
    text += (text.empty() ? "" : ", ") + (next - at > 1 ? std::to_string(next - at) + " x " : std::string()) + *at;
    at = next;
  }
  return text.empty() ? "none found" : text;
}

/// A row for each range of conditions with the same stable orbits.
std::string stable_orbits(const std::vector<OrbitsOfCondition>& conditions) {
  const std::size_t swept = conditions.front().parameters.size();
  std::vector<TextRow> rows(1);
  for (const Parameter& parameter : conditions.front().parameters) rows[0].push_back(last_key(parameter.pointer));
  rows[0].insert(rows[0].end(), {"stable orbits", "the run ended on"});
  for (const OrbitsOfCondition& condition : conditions) {
    TextRow& row = rows.emplace_back();
    for (const Parameter& parameter : condition.parameters) row.push_back(short_value(parameter));
    row.insert(row.end(),
               {counted_names(modes_of_stable(condition)),
                condition.run_on ? mode_of(condition.orbits[*condition.run_on]) : to_string(condition.mode)});
  }
  if (swept > 0) rows = merged_rows(rows, swept - 1, 1);
  rows.resize(std::min(rows.size(), most_ranges + 1));
  return aligned(rows);
}

std::string coexistence_in(const std::vector<OrbitsOfCondition>& conditions) {
  const auto several = static_cast<std::size_t>(std::ranges::count_if(
      conditions, [](const OrbitsOfCondition& condition) { return modes_of_stable(condition).size() > 1; }));
  return "several stable orbits coexist in " + std::to_string(several) + " of " +
         counted(conditions.size(), "condition") + '\n';
}

std::string branch_table(const FoundBranches& found) {
  const std::string parameter = last_key(found.pointer);
  std::vector<TextRow> rows{{"branch", "orbits", "symmetric", "points", parameter + " from", "to", "ends"}};
  for (std::size_t i = 0; i < found.study.branches.size(); ++i) {
    const OrbitBranch& branch = found.study.branches[i];
    const auto [low, high] = std::ranges::minmax(branch.points, {}, &BranchPoint::value);
    rows.push_back({std::to_string(i), mode_of(branch.points.front().orbit), branch.is_symmetric ? "yes" : "no",
                    std::to_string(branch.points.size()), significant(low.value, 8), significant(high.value, 8),
                    both(branch.ends)});
  }
  return '\n' + aligned(rows) +
         (found.study.is_complete ? "" : "There are more: the largest number of branches was reached.\n");
}

std::string bifurcations_table(const FoundBranches& found) {
  if (found.study.bifurcations.empty()) return "";
  std::vector<TextRow> rows{{"bifurcation", "branch", last_key(found.pointer), "error", "orbit"}};
  for (const Bifurcation& one : found.study.bifurcations) {
    rows.push_back({std::string(to_string(one.kind)), std::to_string(one.branch), significant(one.value, 12),
                    significant(one.error, 1), one.orbit ? mode_of(*one.orbit) : "-"});
  }
  return '\n' + aligned(rows);
}

/// A row for each curve.
std::string curves_table(const FoundCurves& found, const FoundBranches& branches) {
  if (found.curves.empty()) return "\nNo fold, period doubling or loss of symmetry to follow.\n";
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
  return '\n' + aligned(rows);
}

/// How many response modes (m,n) are backed by an orbit, and the conditions of those that are not.
std::string labels_note(const OrbitStudy& study, Extent extent) {
  const OrbitLabels labels = labels_of(study);
  if (labels.periodic == 0) return "";
  std::string text = std::to_string(labels.certified) + " of " + std::to_string(labels.periodic) +
                     " responses (m,n) of runs are backed by a stable orbit of this m and n, found by Newton's method";
  if (labels.not_certified.empty()) return text + "\n";
  text += "; not:\n";
  for (std::size_t k = 0; k < labels.not_certified.size(); ++k) {
    if (extent == Extent::one_screen && k == most_not_backed) {
      return text + "  and " + std::to_string(labels.not_certified.size() - k) + " more\n";
    }
    const std::size_t i = labels.not_certified[k];
    std::string where;
    for (const Parameter& parameter : study.conditions[i].parameters) {
      where += (where.empty() ? "" : ", ") + last_key(parameter.pointer) + ' ' + short_value(parameter);
    }
    text += "  " + (where.empty() ? "the condition" : where) + ": " + to_string(study.conditions[i].mode) + '\n';
  }
  return text;
}

}  // namespace

std::string table_of(const OrbitStudy& study, Extent extent) {
  std::vector<std::string> tables;
  if (study.branches) tables = {branch_table(*study.branches), bifurcations_table(*study.branches)};
  if (study.curves) tables.push_back(curves_table(*study.curves, *study.branches));
  const std::string answer = coexistence_in(study.conditions) + labels_note(study, extent) +
                             "other orbits may exist: the search is from a finite grid\n\n";
  std::string whole = answer + orbits_of_conditions(study.conditions);
  for (const std::string& table : tables) whole += table;
  whole +=
      "\ntilt, tilt_rate: where the argument of the excitation is 0; multiplier: modulus of the largest one; *: the "
      "run\nfrom the initial state ended on this orbit\n";
  if (is_printed_whole(whole, extent)) return whole;
  std::string text = answer + stable_orbits(study.conditions);
  for (const std::string& table : tables) {
    if (is_printed_whole(text + table, extent)) text += table;
  }
  return text + "\nmore rows: --all, and orbits.json\n";
}

}  // namespace rocking
