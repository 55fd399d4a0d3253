#include "analysis/branch_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/sweep_view.hpp"
#include "rocking/output/parameter_names.hpp"

namespace rocking::analysis {
namespace {

constexpr double most_tilt = 2.0;  ///< of an axis: some unstable orbits go far beyond the balance

/// With the marker of each.
constexpr std::array<std::pair<BifurcationKind, int>, 5> markers{{{BifurcationKind::fold, 9},
                                                                  {BifurcationKind::period_doubling, 5},
                                                                  {BifurcationKind::symmetry_breaking, 13},
                                                                  {BifurcationKind::grazing, 2},
                                                                  {BifurcationKind::contact_change, 1}}};

std::string words_of(BifurcationKind kind) {
  std::string words(to_string(kind));
  std::ranges::replace(words, '_', ' ');
  return words;
}

Column value_column(const std::string& pointer) { return {last_key(pointer), label_of(axis_of_parameter(pointer))}; }

/// The lines of all orbits that are stable, or of all that are not: one line for each point of the section, separated by
/// empty rows. A line goes on to the first point behind a change of stability.
Table line_table(const FoundBranches& found, bool stable) {
  Table table{.name = stable ? "stable orbits" : "unstable orbits",
              .columns = {value_column(found.pointer), {"tilt", "Θ at the strobe"}, {"branch", "its place"}},
              .rows = {}};
  double place = 0.0;
  for (const OrbitBranch& branch : found.study.branches) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(branch.period); ++k) {
      bool is_open = false;
      for (const BranchPoint& point : branch.points) {
        const bool belongs = point.orbit.stability.is_stable() == stable;
        const bool follows = is_open && !belongs;
        if (belongs || follows) table.rows.push_back({point.value, point.orbit.points[k].point.tilt, place});
        if (follows) table.rows.push_back({Cell{}, Cell{}, Cell{}});
        is_open = belongs;
      }
      if (is_open) table.rows.push_back({Cell{}, Cell{}, Cell{}});
    }
    ++place;
  }
  return table;
}

Table bifurcation_table(const FoundBranches& found, BifurcationKind kind) {
  Table table{.name = words_of(kind),
              .columns = {value_column(found.pointer),
                          {"tilt", "Θ at the strobe"},
                          {"error", "error of the parameter"},
                          {"branch", "its place"}},
              .rows = {}};
  for (const Bifurcation& one : found.study.bifurcations) {
    if (one.kind != kind || !one.orbit) continue;
    for (const SectionState& state : one.orbit->points) {
      table.rows.push_back({one.value, state.point.tilt, one.error, static_cast<double>(one.branch)});
    }
  }
  return table;
}

/// Orbits on which the runs ended.
Table run_table(const OrbitStudy& study) {
  const std::string& pointer = study.branches->pointer;
  Table table{.name = "ends of runs", .columns = {value_column(pointer), {"tilt", "Θ at the strobe"}}, .rows = {}};
  for (const OrbitsOfCondition& condition : study.conditions) {
    const std::optional<double> value = swept_number(condition, pointer);
    if (!condition.run_on || !value) continue;
    for (const SectionState& state : condition.orbits[*condition.run_on].points) {
      table.rows.push_back({*value, state.point.tilt});
    }
  }
  return table;
}

void add_branches(const FoundBranches& found, Figure& figure) {
  add_layer(line_table(found, false), LayerKind::line, {.colour = "#b03a2e", .dash = 2, .marker = 0, .width = 1.2},
            "unstable orbit", figure);
  add_layer(line_table(found, true), LayerKind::line, {.colour = "#1f4e79", .dash = 1, .marker = 0, .width = 1.8},
            "stable orbit", figure);
  for (const auto& [kind, marker] : markers) {
    add_layer(bifurcation_table(found, kind), LayerKind::points, {.colour = "#000000", .marker = marker, .size = 0.9},
              words_of(kind), figure);
  }
}

/// Limits the axis to the orbits that are not far beyond the balance.
void set_tilt_range(const std::vector<Table>& tables, Axis& axis) {
  double low = 0.0;
  double high = 0.0;
  for (const Table& table : tables) {
    for (const auto& row : table.rows) {
      if (const double* tilt = std::get_if<double>(&row.at(1)); tilt && std::abs(*tilt) < most_tilt) {
        low = std::min(low, *tilt);
        high = std::max(high, *tilt);
      }
    }
  }
  const double room = std::max(0.05 * (high - low), 0.01);
  axis.low = low - room;
  axis.high = high + room;
}

}  // namespace

Figure branch_figure(const OrbitsReport& report) {
  const FoundBranches& found = *report.study.branches;
  Figure figure;
  figure.name = "branches";
  figure.title = "Periodic orbits";
  figure.subtitle = report.input.title();
  figure.arrangement = Arrangement::stacked;
  figure.panels.push_back({.title = "",
                           .x = axis_of_parameter(found.pointer),
                           .y = {"tilt at the strobe", "Θ", ""},
                           .layers = {},
                           .height = 1.6});
  figure.panels.back().x.low = found.range.low;
  figure.panels.back().x.high = found.range.high;
  add_layer(run_table(report.study), LayerKind::points, {.colour = "#808080", .marker = 7, .size = 0.5}, "end of a run",
            figure);
  add_branches(found, figure);
  set_tilt_range(figure.tables, figure.panels.back().y);
  figure.caption =
      "Solid: stable orbits; dashed: unstable ones; markers: bifurcations. Of two orbits that are mirror images of "
      "each other one is drawn.";
  return figure;
}

void draw_branches_over(const OrbitStudy& study, Figure& figure) {
  add_branches(*study.branches, figure);
  figure.caption += " Solid lines: stable orbits; dashed: unstable ones; markers: bifurcations.";
}

}  // namespace rocking::analysis
