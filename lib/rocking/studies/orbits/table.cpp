#include "rocking/studies/orbits/study.hpp"

#include <algorithm>

#include "rocking/output/parameter_text.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::number;
using look::whole;

constexpr std::size_t most_ranges = 30;     ///< of conditions with the same stable orbits, on one screen
constexpr std::size_t most_not_backed = 5;  ///< conditions that are listed there

/// As runs call it.
std::string mode_of(const Orbit& orbit) {
  const bool is_at_rest = orbit.points.front().contact == dynamics::ContactState::rest && orbit.cycles == 0;
  return is_at_rest ? "rest" : to_string(section::periodic(orbit.cycles, orbit.period));
}

/// Modulus of the largest multiplier.
look::Cell largest_multiplier(const Stability& stability) {
  if (stability.kind == OrbitKind::not_differentiable) return "-";
  return number(stability.multipliers.empty() ? 0.0 : std::abs(stability.multipliers.front()), 4);
}

std::string both(const std::array<BranchEnd, 2>& ends) {
  return std::string(to_string(ends[0])) + ", " + std::string(to_string(ends[1]));
}

/// A row for each orbit of a condition.
std::string orbits_of_conditions(const std::vector<OrbitsOfCondition>& conditions) {
  look::Table table = table_of(conditions.front().parameters, {"orbit", "contact", "kind", "multiplier", "tilt",
                                                               "tilt_rate", "found by", "mirror", "run"});
  for (const OrbitsOfCondition& condition : conditions) {
    for (std::size_t i = 0; i < condition.orbits.size(); ++i) {
      const Orbit& orbit = condition.orbits[i];
      const SectionState& start = orbit.points.front();
      table.rows.push_back(
          row_of(condition.parameters,
                 {mode_of(orbit), std::string(to_string(start.contact)), std::string(to_string(orbit.stability.kind)),
                  largest_multiplier(orbit.stability), number(start.point.tilt, 4), number(start.point.tilt_rate, 4),
                  std::string(to_string(orbit.found_by)),
                  orbit.is_symmetric ? "itself"
                  : orbit.mirror     ? "another"
                                     : "none",
                  condition.run_on == i ? "*" : ""}));
    }
  }
  table.notes = "tilt, tilt_rate: Theta and Theta', over psi of the side on which the block is\n";
  return to_terminal(table);
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
  look::Table table = table_of(conditions.front().parameters, {"stable orbits", "the run ended on"});
  for (const OrbitsOfCondition& condition : conditions) {
    table.rows.push_back(row_of(condition.parameters, {counted_names(modes_of_stable(condition)),
                                                       condition.run_on ? mode_of(condition.orbits[*condition.run_on])
                                                                        : to_string(condition.mode)}));
  }
  if (swept > 0) merge_rows(table, swept - 1, 1);
  table.rows.resize(std::min(table.rows.size(), most_ranges));
  return to_terminal(table);
}

std::string coexistence_in(const std::vector<OrbitsOfCondition>& conditions) {
  if (conditions.size() == 1)
    return "stable orbits that were found: " + counted_names(modes_of_stable(conditions[0])) + '\n';
  const auto several = static_cast<std::size_t>(std::ranges::count_if(
      conditions, [](const OrbitsOfCondition& condition) { return modes_of_stable(condition).size() > 1; }));
  return "several stable orbits coexist in " + std::to_string(several) + " of " +
         counted(conditions.size(), "condition") + '\n';
}

std::string branch_table(const FoundBranches& found) {
  const std::string parameter = last_key(found.pointer);
  look::Table table;
  add_columns(table, {"branch", "orbits", "symmetric", "points", parameter + " from", "to", "ends"});
  for (std::size_t i = 0; i < found.study.branches.size(); ++i) {
    const OrbitBranch& branch = found.study.branches[i];
    const auto [low, high] = std::ranges::minmax(branch.points, {}, &BranchPoint::value);
    table.rows.push_back({whole(i), to_string(section::periodic(cycles_of(branch), branch.period)),
                          branch.is_symmetric ? "yes" : "no", whole(branch.points.size()), number(low.value, 8),
                          number(high.value, 8), both(branch.ends)});
  }
  if (!found.study.is_complete) table.notes = "There are more: the largest number of branches was reached.\n";
  return '\n' + to_terminal(table);
}

std::string bifurcations_table(const FoundBranches& found) {
  if (found.study.bifurcations.empty()) return "";
  look::Table table;
  add_columns(table, {"bifurcation", "branch", last_key(found.pointer), "error", "orbit"});
  for (const Bifurcation& one : found.study.bifurcations) {
    table.rows.push_back({std::string(to_string(one.kind)), whole(one.branch), number(one.value, 12),
                          number(one.error, 1), one.orbit ? mode_of(*one.orbit) : "-"});
  }
  return '\n' + to_terminal(table);
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
    const std::string where = values_of(study.conditions[i].parameters);
    text += "  " + (where.empty() ? "the condition" : where) + ": " + to_string(study.conditions[i].mode) + '\n';
  }
  return text;
}

}  // namespace

std::string table_of(const OrbitStudy& study, Extent extent) {
  std::vector<std::string> tables;
  if (study.branches) tables = {branch_table(*study.branches), bifurcations_table(*study.branches)};
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
