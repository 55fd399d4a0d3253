#include "rocking/studies/orbits/study.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr std::size_t most_named_modes = 8;
constexpr double most_tilt = 2.0;         ///< of an axis: some unstable orbits go far beyond the balance
constexpr double near_attractors = 0.25;  ///< of an unstable orbit that is shown, in the range of the attractors
constexpr double least_room = 0.05;

/// With the marker of each.
constexpr std::array<std::pair<BifurcationKind, int>, 6> markers{{{BifurcationKind::fold, 9},
                                                                  {BifurcationKind::period_doubling, 5},
                                                                  {BifurcationKind::symmetry_breaking, 13},
                                                                  {BifurcationKind::neimark_sacker, 7},
                                                                  {BifurcationKind::grazing, 2},
                                                                  {BifurcationKind::contact_change, 1}}};

std::string words_of(BifurcationKind kind) {
  if (kind == BifurcationKind::neimark_sacker) return "Neimark-Sacker";
  std::string words(to_string(kind));
  std::ranges::replace(words, '_', ' ');
  return words;
}

Column value_column(const std::string& pointer) { return {last_key(pointer), label_of(axis_of_parameter(pointer))}; }

bool is_stable(const Orbit& orbit) { return orbit.stability.is_stable(); }

ResponseMode mode_of(const Orbit& orbit) { return section::periodic(orbit.cycles, orbit.period); }

/// The lines of the orbits that belong to a table: one line for each point of the section, separated by empty rows. A line
/// goes on to the first point behind them.
Table line_table(const FoundBranches& found, const std::string& name,
                 const std::function<bool(const Orbit&)>& belongs) {
  Table table{.name = name,
              .columns = {value_column(found.pointer), {"tilt", "Θ at the strobe"}, {"branch", "its place"}}};
  double place = 0.0;
  for (const OrbitBranch& branch : found.study.branches) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(branch.period); ++k) {
      bool is_open = false;
      for (const BranchPoint& point : branch.points) {
        const bool is_of_table = belongs(point.orbit);
        const bool follows = is_open && !is_of_table;
        if (is_of_table || follows) table.rows.push_back({point.value, point.orbit.points[k].point.tilt, place});
        if (follows) table.rows.push_back({Cell{}, Cell{}, Cell{}});
        is_open = is_of_table;
      }
      if (is_open) table.rows.push_back({Cell{}, Cell{}, Cell{}});
    }
    ++place;
  }
  return table;
}

/// How many points the stable orbits of each mode have.
std::map<ResponseMode, std::size_t> stable_points(const FoundBranches& found) {
  std::map<ResponseMode, std::size_t> counts;
  for (const OrbitBranch& branch : found.study.branches) {
    for (const BranchPoint& point : branch.points) {
      if (is_stable(point.orbit)) ++counts[mode_of(point.orbit)];
    }
  }
  return counts;
}

/// Those with the most points, no two of them in one colour.
std::vector<ResponseMode> modes_to_name(const std::map<ResponseMode, std::size_t>& counts) {
  std::vector<ResponseMode> modes;
  for (const auto& [mode, count] : counts) modes.push_back(mode);
  std::ranges::stable_sort(modes, std::greater{}, [&counts](const ResponseMode& mode) { return counts.at(mode); });
  std::set<std::string> colours;
  std::erase_if(modes, [&colours](const ResponseMode& mode) {
    return colours.size() == most_named_modes || !colours.insert(style_of(mode).colour).second;
  });
  return modes;
}

Table bifurcation_table(const FoundBranches& found, BifurcationKind kind) {
  Table table{.name = words_of(kind),
              .columns = {value_column(found.pointer),
                          {"tilt", "Θ at the strobe"},
                          {"error", "error of the parameter"},
                          {"branch", "its place"}}};
  for (const Bifurcation& one : found.study.bifurcations) {
    if (one.kind != kind || !one.orbit) continue;
    for (const SectionState& state : one.orbit->points) {
      table.rows.push_back({one.value, state.point.tilt, one.error, one.branch});
    }
  }
  return table;
}

/// Orbits on which the runs ended.
Table run_table(const OrbitStudy& study) {
  const std::string& pointer = study.branches->pointer;
  Table table{.name = "ends of runs", .columns = {value_column(pointer), {"tilt", "Θ at the strobe"}}};
  for (const OrbitsOfCondition& condition : study.conditions) {
    const std::optional<double> value = swept_number(condition, pointer);
    if (!condition.run_on || !value) continue;
    for (const SectionState& state : condition.orbits[*condition.run_on].points) {
      table.rows.push_back({*value, state.point.tilt});
    }
  }
  return table;
}

constexpr const char* colour_of_unstable = "#707070";

void add_unstable(const FoundBranches& found, Figure& figure) {
  const auto is_unstable = [](const Orbit& orbit) { return !is_stable(orbit); };
  add_layer(line_table(found, "unstable orbits", is_unstable), LayerKind::line,
            {.colour = colour_of_unstable, .dash = 2, .marker = 0, .width = 1.0}, "unstable orbit", figure);
}

void add_bifurcations(const FoundBranches& found, Figure& figure) {
  for (const auto& [kind, marker] : markers) {
    add_layer(bifurcation_table(found, kind), LayerKind::points, {.colour = "#000000", .marker = marker, .size = 0.9},
              words_of(kind), figure);
  }
}

/// A layer for each of these modes, and one for all others.
void add_stable_by_mode(const FoundBranches& found, Figure& figure) {
  const auto counts = stable_points(found);
  const std::vector<ResponseMode> named = modes_to_name(counts);
  const std::size_t others = counts.size() - named.size();
  const auto is_other = [&named](const Orbit& orbit) {
    return is_stable(orbit) && std::ranges::find(named, mode_of(orbit)) == named.end();
  };
  Style style{.colour = "#404040", .marker = 0, .width = 1.8};
  add_layer(line_table(found, "stable orbits of other modes", is_other), LayerKind::line, style,
            "stable, " + counted(others, "other mode"), figure);
  for (const ResponseMode& mode : named) {
    style.colour = style_of(mode).colour;
    const auto has_mode = [&mode](const Orbit& orbit) { return is_stable(orbit) && mode_of(orbit) == mode; };
    const std::string name = to_string(mode);
    add_layer(line_table(found, "stable orbits " + name, has_mode), LayerKind::line, style, "stable " + name, figure);
  }
}

/// Tilts at the section of the orbits that are not far beyond the balance, or of the stable ones.
std::set<double> tilts_of(const FoundBranches& found, bool only_stable) {
  std::set<double> tilts;
  for (const OrbitBranch& branch : found.study.branches) {
    for (const BranchPoint& point : branch.points) {
      for (const SectionState& state : point.orbit.points) {
        const bool is_shown = only_stable ? is_stable(point.orbit) : std::abs(state.point.tilt) < most_tilt;
        if (is_shown) tilts.insert(state.point.tilt);
      }
    }
  }
  return tilts;
}

/// Limits the axis to the stable orbits, the ends of runs, and the unstable orbits near them; of a study without either
/// of the first two, to all orbits that are not far beyond the balance.
void set_tilt_range(const FoundBranches& found, const Table& ends, Axis& axis) {
  std::set<double> attracting = tilts_of(found, true);
  for (const auto& row : ends.rows) attracting.insert(std::get<double>(row.at(1)));
  std::set<double> shown = tilts_of(found, false);
  shown.insert(attracting.begin(), attracting.end());
  if (shown.empty()) return;
  if (!attracting.empty()) {
    const double near = std::max(near_attractors * (*attracting.rbegin() - *attracting.begin()), least_room);
    shown.erase(shown.begin(), shown.lower_bound(*attracting.begin() - near));
    shown.erase(shown.upper_bound(*attracting.rbegin() + near), shown.end());
  }
  const double room = std::max(0.05 * (*shown.rbegin() - *shown.begin()), 0.01);
  axis.low = *shown.begin() - room;
  axis.high = *shown.rbegin() + room;
}

}  // namespace

Figure branch_figure(const OrbitsReport& report) {
  const FoundBranches& found = *report.study.branches;
  Figure figure{.name = "branches",
                .title = "Periodic orbits",
                .subtitle = report.input.title(),
                .arrangement = Arrangement::stacked};
  figure.panels.push_back({.x = axis_of_parameter(found.pointer), .y = {"tilt at the strobe", "Θ", ""}, .height = 1.6});
  figure.panels.back().x.low = found.range.low;
  figure.panels.back().x.high = found.range.high;
  const Table ends = run_table(report.study);
  set_tilt_range(found, ends, figure.panels.back().y);
  add_unstable(found, figure);
  add_stable_by_mode(found, figure);
  add_layer(ends, LayerKind::points, {.colour = "#000000", .marker = 6, .width = 0.8, .size = 0.5}, "end of a run",
            figure);
  add_bifurcations(found, figure);
  figure.caption =
      "Solid: stable orbits; dashed: unstable ones; markers: bifurcations. Of two orbits that are mirror images of "
      "each other one is drawn. The axis shows the range of the stable orbits and of the ends of runs, and what is "
      "near it; the data have all orbits.";
  return figure;
}

void draw_branches_over(const OrbitStudy& study, Figure& figure) {
  add_unstable(*study.branches, figure);
  add_layer(line_table(*study.branches, "stable orbits", is_stable), LayerKind::line,
            {.colour = "#404040", .marker = 0, .width = 1.2}, "stable orbit", figure);
  add_bifurcations(*study.branches, figure);
  figure.caption += " Solid lines: stable orbits; dashed: unstable ones; markers: bifurcations.";
}

}  // namespace rocking::analysis
