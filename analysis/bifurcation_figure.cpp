#include "analysis/bifurcation_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "analysis/output_file.hpp"
#include "analysis/palette.hpp"
#include "analysis/sweep_view.hpp"
#include "rocking/output/parameter_names.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

// At most one cell per pixel of the SVG: a picture that is scaled down drops cells, and with them thin branches.
constexpr std::size_t levels = 190;
constexpr std::size_t most_columns = 600;
constexpr std::size_t most_points = 12'000;

constexpr std::array<std::pair<std::string_view, std::string_view>, 3> branches{
    {{"initial", "each step from the initial state"},
     {"upwards", "upwards: each step from the end of the previous one"},
     {"downwards", "downwards: each step from the end of the previous one"}}};

struct Step {
  double value = 0.0;
  ResponseMode mode;
  std::vector<double> tilts;
};

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void include(double number) {
    low = std::min(low, number);
    high = std::max(high, number);
  }
  /// Index of the part that contains a number if the range is divided into `count` equal parts.
  [[nodiscard]] std::size_t part(double number, std::size_t count) const {
    if (!(high > low)) return 0;
    const double place = (number - low) / (high - low) * static_cast<double>(count);
    return std::min(static_cast<std::size_t>(std::max(place, 0.0)), count - 1);
  }
};

/// Steps of a diagram by branch, with their ranges.
struct Diagram {
  std::map<std::string, std::vector<Step>> branches;
  Range values, tilts;
  std::size_t different_values = 0;
};

Diagram diagram_from(const Json& json) {
  Diagram diagram;
  std::set<double> values;
  for (const Json& entry : json.at("steps")) {
    Step step;
    step.value = entry.at("value");
    step.mode = section::response_mode_named(entry.at("mode").get<std::string>()).value_or(ResponseMode{});
    for (const Json& point : entry.at("points")) {
      step.tilts.push_back(point.at(0));
      diagram.tilts.include(step.tilts.back());
    }
    diagram.values.include(step.value);
    values.insert(step.value);
    diagram.branches[entry.at("branch")].push_back(std::move(step));
  }
  diagram.different_values = values.size();
  return diagram;
}

/// By mode, the points that differ by more than a thousandth of the range, with the number of points near each.
std::map<ResponseMode, Table> point_tables(const Diagram& diagram, const std::vector<Step>& steps,
                                           const Column& value) {
  std::map<ResponseMode, Table> tables;
  for (const Step& step : steps) {
    std::map<std::size_t, std::pair<double, double>> cells;  // by level: one tilt in the cell, and the number of points
    for (const double tilt : step.tilts) {
      auto& [first, count] = cells.try_emplace(diagram.tilts.part(tilt, 1000), tilt, 0.0).first->second;
      ++count;
    }
    Table& table = tables[step.mode];
    table.name = to_string(step.mode);
    table.columns = {value, {"tilt", "Θ at the strobe"}, {"points", "number of points that are drawn as one"}};
    for (const auto& [level, cell] : cells) table.rows.push_back({step.value, cell.first, cell.second});
  }
  std::erase_if(tables, [](const auto& entry) { return entry.second.rows.empty(); });
  return tables;
}

Table image_table(const Diagram& diagram, const std::vector<Step>& steps, const std::string& name) {
  const std::size_t width = std::min(most_columns, diagram.different_values);
  const auto parts = static_cast<double>(width - 1);
  const double dx = (diagram.values.high - diagram.values.low) / parts;
  const double dy = (diagram.tilts.high - diagram.tilts.low) / static_cast<double>(levels);
  Table table{.name = name,
              .columns = {},
              .rows = std::vector<std::vector<Cell>>(levels, std::vector<Cell>(width, 0.0)),
              .grid = Table::Grid{.x = diagram.values.low, .dx = dx, .y = diagram.tilts.low + 0.5 * dy, .dy = dy},
              .only_drawn = true};
  for (const Step& step : steps) {
    const auto column = static_cast<std::size_t>(std::lround((step.value - diagram.values.low) / dx));
    for (const double tilt : step.tilts) {
      ++std::get<double>(table.rows[diagram.tilts.part(tilt, levels)][column]);
    }
  }
  return table;
}

std::size_t points_drawn(const Diagram& diagram) {
  std::size_t count = 0;
  for (const auto& [branch, steps] : diagram.branches) {
    for (const auto& [mode, table] : point_tables(diagram, steps, {})) count += table.rows.size();
  }
  return count;
}

void add_points(const Diagram& diagram, const std::vector<Step>& steps, const Column& value, Figure& figure) {
  for (auto& [mode, table] : point_tables(diagram, steps, value)) {
    Style style = style_of(mode);
    if (mode.kind == section::ResponseKind::unresolved) style.colour = "#707070";
    style.size = 0.3;
    style.width = 0.8;
    figure.panels.back().layers.push_back({.kind = LayerKind::points,
                                           .table = figure.tables.size(),
                                           .columns = {0, 1},
                                           .style = style,
                                           .legend = to_string(mode)});
    figure.tables.push_back(std::move(table));
  }
}

/// Extends a range that consists of a single value or tilt.
void widen(Range& range) {
  const double room = range.high > range.low ? 0.0 : std::max(0.1, 0.1 * std::abs(range.low));
  range.low -= room;
  range.high += room;
}

Figure figure_of(Diagram diagram, Axis x, const std::string& pointer, const std::string& others) {
  Figure figure;
  figure.title = "Coexisting responses";
  figure.subtitle = others;
  figure.arrangement = Arrangement::stacked;
  const Column value{last_key(pointer), label_of(x)};
  if (!(diagram.tilts.low <= diagram.tilts.high)) diagram.tilts = {.low = 0.0, .high = 0.0};
  widen(diagram.tilts);
  const bool as_image = diagram.different_values > 1 && points_drawn(diagram) > most_points;
  widen(diagram.values);
  const double margin =
      0.5 * (diagram.values.high - diagram.values.low) / static_cast<double>(diagram.different_values);
  x.low = diagram.values.low - margin;
  x.high = diagram.values.high + margin;
  for (const auto& [branch, words] : branches) {
    const auto found = diagram.branches.find(std::string(branch));
    if (found == diagram.branches.end()) continue;
    figure.panels.push_back(
        {.title = std::string(words), .x = x, .y = {"tilt at the strobe", "Θ", ""}, .layers = {}, .height = 1.4});
    const double room = 0.03 * (diagram.tilts.high - diagram.tilts.low);
    figure.panels.back().y.low = diagram.tilts.low - room;
    figure.panels.back().y.high = diagram.tilts.high + room;
    if (as_image) {
      figure.panels.back().layers.push_back({.kind = LayerKind::image, .table = figure.tables.size(), .columns = {}});
      figure.tables.push_back(image_table(diagram, found->second, std::string(words)));
    } else {
      add_points(diagram, found->second, value, figure);
    }
  }
  figure.caption =
      as_image
          ? "Density of strobe points on a logarithmic scale: darker means more points; the lightest grey is a single "
            "point."
          : "Strobe points, in the style of their response mode; of points nearer to each other than a thousandth of "
            "the "
            "range, one is drawn.";
  return figure;
}

std::string others_in_words(const Json& others) {
  std::string words;
  for (const auto& [pointer, value] : others.items()) {
    words += (words.empty() ? "" : ", ") + axis_of_parameter(pointer).quantity + ' ' + short_value(pointer, value);
  }
  return words;
}

/// Names of the figures, as of the tables of points (output/write_bifurcation.hpp).
std::vector<std::string> names_of(const Json& diagrams) {
  if (diagrams.size() < 2) return std::vector<std::string>(diagrams.size(), "bifurcation");
  std::vector<std::vector<Parameter>> parts;
  for (const Json& diagram : diagrams) {
    auto& part = parts.emplace_back();
    for (const auto& [pointer, value] : diagram.at("others").items()) part.push_back({pointer, value.dump()});
  }
  std::vector<std::string> names = parameter_names(parts);
  for (std::string& name : names) name.insert(0, "bifurcation_");
  return names;
}

}  // namespace

std::vector<Figure> bifurcation_figures(const Json& output) {
  std::vector<Figure> figures;
  read_or_refuse(output, [&] {
    const std::string title = output.at("input").at("experiment").at("title");
    const std::vector<std::string> names = names_of(output.at("diagrams"));
    for (const Json& diagram : output.at("diagrams")) {
      const std::string others = others_in_words(diagram.at("others"));
      const std::string subtitle = title + (title.empty() || others.empty() ? "" : "; ") + others;
      const std::string pointer = output.at("parameter");
      Axis x = axis_of_parameter(pointer, shakings_in(diagram.at("steps")));
      figures.push_back(figure_of(diagram_from(diagram), std::move(x), pointer, subtitle));
      figures.back().name = names[figures.size() - 1];
    }
  });
  return figures;
}

}  // namespace rocking::analysis
