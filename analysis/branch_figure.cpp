#include "analysis/branch_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/output_file.hpp"
#include "analysis/sweep_view.hpp"
#include "rocking/output/parameter_names.hpp"

namespace rocking::analysis {
namespace {

constexpr double most_tilt = 2.0;  ///< of an axis: some unstable orbits go far beyond the balance

/// The kinds of bifurcation as in the file, with the marker of each.
constexpr std::array<std::pair<std::string_view, int>, 5> markers{
    {{"fold", 9}, {"period_doubling", 5}, {"symmetry_breaking", 13}, {"grazing", 2}, {"contact_change", 1}}};

std::string in_words(std::string_view kind) {
  std::string words(kind);
  std::ranges::replace(words, '_', ' ');
  return words;
}

bool is_stable(const Json& point) { return point.at("stable").is_boolean() && point.at("stable").get<bool>(); }

Column value_column(const std::string& pointer) { return {last_key(pointer), label_of(axis_of_parameter(pointer))}; }

/// The lines of all orbits that are stable, or of all that are not: one line for each point of the section, separated by
/// empty rows. A line goes on to the first point behind a change of stability.
Table line_table(const Json& output, bool stable) {
  Table table{.name = stable ? "stable orbits" : "unstable orbits",
              .columns = {value_column(output.at("parameter")), {"tilt", "Θ at the strobe"}, {"branch", "its place"}},
              .rows = {}};
  double place = 0.0;
  for (const Json& branch : output.at("branches")) {
    const Json& points = branch.at("points");
    const auto period = branch.at("period").get<std::size_t>();
    for (std::size_t k = 0; k < period; ++k) {
      bool is_open = false;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const bool belongs = is_stable(points[i]) == stable;
        const bool follows = is_open && !belongs;
        if (belongs || follows) {
          table.rows.push_back(
              {points[i].at("value").get<double>(), points[i].at("points").at(k).at(0).get<double>(), place});
        }
        if (follows) table.rows.push_back({Cell{}, Cell{}, Cell{}});
        is_open = belongs;
      }
      if (is_open) table.rows.push_back({Cell{}, Cell{}, Cell{}});
    }
    ++place;
  }
  return table;
}

Table bifurcation_table(const Json& output, std::string_view kind) {
  Table table{.name = in_words(kind),
              .columns = {value_column(output.at("parameter")),
                          {"tilt", "Θ at the strobe"},
                          {"error", "error of the parameter"},
                          {"branch", "its place"}},
              .rows = {}};
  for (const Json& one : output.at("bifurcations")) {
    if (one.at("kind").get<std::string>() != kind || one.at("orbit").is_null()) continue;
    for (const Json& point : one.at("orbit").at("points")) {
      table.rows.push_back({one.at("value").get<double>(), point.at(0).get<double>(), one.at("error").get<double>(),
                            one.at("branch").get<double>()});
    }
  }
  return table;
}

/// Orbits on which the runs ended.
Table run_table(const Json& output) {
  const std::string pointer = output.at("parameter");
  Table table{.name = "ends of runs", .columns = {value_column(pointer), {"tilt", "Θ at the strobe"}}, .rows = {}};
  for (const Json& condition : output.at("conditions")) {
    const Json& place = condition.at("run").at("orbit");
    if (place.is_null()) continue;
    for (const Json& point : condition.at("orbits").at(place.get<std::size_t>()).at("points")) {
      table.rows.push_back({condition.at("parameters").at(pointer).get<double>(), point.at(0).get<double>()});
    }
  }
  return table;
}

/// Adds a table to a figure and a layer of it to each of the panels.
void add_layer(Table table, LayerKind kind, const Style& style, const std::string& legend, Figure& figure) {
  if (table.rows.empty()) return;
  for (Panel& panel : figure.panels) {
    panel.layers.push_back(
        {.kind = kind, .table = figure.tables.size(), .columns = {0, 1}, .style = style, .legend = legend});
  }
  figure.tables.push_back(std::move(table));
}

void add_branches(const Json& output, Figure& figure) {
  add_layer(line_table(output, false), LayerKind::line, {.colour = "#b03a2e", .dash = 2, .marker = 0, .width = 1.2},
            "unstable orbit", figure);
  add_layer(line_table(output, true), LayerKind::line, {.colour = "#1f4e79", .dash = 1, .marker = 0, .width = 1.8},
            "stable orbit", figure);
  for (const auto& [kind, marker] : markers) {
    add_layer(bifurcation_table(output, kind), LayerKind::points, {.colour = "#000000", .marker = marker, .size = 0.9},
              in_words(kind), figure);
  }
}

}  // namespace

bool has_branches(const Json& output) { return output.contains("branches"); }

Figure branch_figure(const Json& output) {
  Figure figure;
  read_or_refuse(output, [&] {
    figure.name = "branches";
    figure.title = "Periodic orbits";
    figure.subtitle = output.at("input").at("experiment").at("title");
    figure.arrangement = Arrangement::stacked;
    figure.panels.push_back({.title = "",
                             .x = axis_of_parameter(output.at("parameter")),
                             .y = {"tilt at the strobe", "Θ", ""},
                             .layers = {},
                             .height = 1.6});
    figure.panels.back().x.low = output.at("range").at(0);
    figure.panels.back().x.high = output.at("range").at(1);
    add_layer(run_table(output), LayerKind::points, {.colour = "#808080", .marker = 7, .size = 0.5}, "end of a run",
              figure);
    add_branches(output, figure);
    double low = 0.0;
    double high = 0.0;
    for (const Table& table : figure.tables) {
      for (const auto& row : table.rows) {
        if (const double* tilt = std::get_if<double>(&row.at(1)); tilt && std::abs(*tilt) < most_tilt) {
          low = std::min(low, *tilt);
          high = std::max(high, *tilt);
        }
      }
    }
    const double room = std::max(0.05 * (high - low), 0.01);
    figure.panels.back().y.low = low - room;
    figure.panels.back().y.high = high + room;
    figure.caption =
        "Solid: stable orbits; dashed: unstable ones; markers: bifurcations. Of two orbits that are mirror images of "
        "each other one is drawn.";
  });
  return figure;
}

void draw_branches_over(const Json& output, Figure& figure) {
  read_or_refuse(output, [&] { add_branches(output, figure); });
  figure.caption += " Solid lines: stable orbits; dashed: unstable ones; markers: bifurcations.";
}

}  // namespace rocking::analysis
