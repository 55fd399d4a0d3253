#include "rocking/studies/bifurcation/study.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "rocking/figures/palette.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/parameter_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

// At most one cell per pixel of the SVG: a picture that is scaled down drops cells, and with them thin branches.
constexpr std::size_t tilt_levels = 190;
constexpr std::size_t most_columns = 600;
constexpr std::size_t most_points = 12'000;
constexpr std::size_t few_points = 300;  // of a mode: drawn larger, to be seen on the line of a branch

std::string_view in_words(DiagramBranch branch) {
  switch (branch) {
    case DiagramBranch::initial: return "each step from the initial state";
    case DiagramBranch::upwards: return "upwards: each step from the end of the previous one";
    case DiagramBranch::downwards: return "downwards: each step from the end of the previous one";
  }
  return "";
}

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

using Steps = std::vector<const ReportedStep*>;

/// Steps of a diagram by branch, with their ranges.
struct DrawnDiagram {
  std::map<DiagramBranch, Steps> branches;
  Range values, tilts;
  std::size_t different_values = 0;
};

DrawnDiagram drawn(const ReportedDiagram& reported) {
  DrawnDiagram diagram;
  std::set<double> values;
  for (const ReportedStep& step : reported.steps) {
    for (const section::StrobePoint& point : step.step.points) diagram.tilts.include(point.tilt);
    diagram.values.include(step.value);
    values.insert(step.value);
    diagram.branches[step.branch].push_back(&step);
  }
  diagram.different_values = values.size();
  return diagram;
}

/// By mode, the points that differ by more than a thousandth of the range, with the number of points near each.
std::map<ResponseMode, Table> point_tables(const DrawnDiagram& diagram, const Steps& steps, const Column& value) {
  std::map<ResponseMode, Table> tables;
  for (const ReportedStep* step : steps) {
    std::map<std::size_t, std::pair<double, double>> cells;  // by level: one tilt in the cell, and the number of points
    for (const section::StrobePoint& point : step->step.points) {
      auto& [first, count] = cells.try_emplace(diagram.tilts.part(point.tilt, 1000), point.tilt, 0.0).first->second;
      ++count;
    }
    const ResponseMode& mode = step->step.classification.mode;
    Table& table = tables[mode];
    table.name = to_string(mode);
    table.columns = {value, {"tilt", "Θ at the strobe"}, {"points", "number of points that are drawn as one"}};
    for (const auto& [level, cell] : cells) table.rows.push_back({step->value, cell.first, cell.second});
  }
  std::erase_if(tables, [](const auto& entry) { return entry.second.rows.empty(); });
  return tables;
}

Table image_table(const DrawnDiagram& diagram, const Steps& steps, const std::string& name) {
  const std::size_t width = std::min(most_columns, diagram.different_values);
  const auto parts = static_cast<double>(width - 1);
  const double dx = (diagram.values.high - diagram.values.low) / parts;
  const double dy = (diagram.tilts.high - diagram.tilts.low) / static_cast<double>(tilt_levels);
  Table table{.name = name,
              .columns = {},
              .rows = std::vector<Row>(tilt_levels, Row(width, 0.0)),
              .grid = Table::Grid{.x = diagram.values.low, .dx = dx, .y = diagram.tilts.low + 0.5 * dy, .dy = dy},
              .only_drawn = true};
  for (const ReportedStep* step : steps) {
    const auto column = static_cast<std::size_t>(std::lround((step->value - diagram.values.low) / dx));
    for (const section::StrobePoint& point : step->step.points) {
      ++std::get<double>(table.rows[diagram.tilts.part(point.tilt, tilt_levels)][column]);
    }
  }
  return table;
}

std::size_t points_drawn(const DrawnDiagram& diagram) {
  std::size_t count = 0;
  for (const auto& [branch, steps] : diagram.branches) {
    for (const auto& [mode, table] : point_tables(diagram, steps, {})) count += table.rows.size();
  }
  return count;
}

void add_points(const DrawnDiagram& diagram, const Steps& steps, const Column& value, Figure& figure) {
  for (auto& [mode, table] : point_tables(diagram, steps, value)) {
    Style style = style_of(mode);
    if (mode.kind == section::ResponseKind::unresolved) style.colour = "#707070";
    style.size = table.rows.size() < few_points ? 0.6 : 0.3;
    style.width = 0.8;
    draw(std::move(table), {.kind = LayerKind::points, .style = style, .legend = to_string(mode)}, {}, figure);
  }
}

/// Extends a range that consists of a single value or tilt.
void widen(Range& range) {
  const double room = range.high > range.low ? 0.0 : std::max(0.1, 0.1 * std::abs(range.low));
  range.low -= room;
  range.high += room;
}

Figure figure_of(DrawnDiagram diagram, Axis x, const std::string& pointer, const std::string& others) {
  Figure figure{.title = "Coexisting responses", .subtitle = others, .arrangement = Arrangement::stacked};
  const Column value{last_key(pointer), label_of(x)};
  if (!(diagram.tilts.low <= diagram.tilts.high)) diagram.tilts = {.low = 0.0, .high = 0.0};
  widen(diagram.tilts);
  const bool as_image = diagram.different_values > 1 && points_drawn(diagram) > most_points;
  widen(diagram.values);
  const double margin =
      0.5 * (diagram.values.high - diagram.values.low) / static_cast<double>(diagram.different_values);
  x.low = diagram.values.low - margin;
  x.high = diagram.values.high + margin;
  for (const auto& [branch, steps] : diagram.branches) {
    const std::string words(in_words(branch));
    figure.panels.push_back({.title = words, .x = x, .y = {"tilt at the strobe", "Θ", ""}, .height = 1.4});
    const double room = 0.03 * (diagram.tilts.high - diagram.tilts.low);
    figure.panels.back().y.low = diagram.tilts.low - room;
    figure.panels.back().y.high = diagram.tilts.high + room;
    if (as_image) {
      add_drawn(image_table(diagram, steps, words), {.kind = LayerKind::image}, figure);
    } else {
      add_points(diagram, steps, value, figure);
    }
  }
  figure.caption = as_image ? "Density of strobe points on a logarithmic scale: darker means more points; the lightest "
                              "grey is a single point."
                            : "Strobe points, in the style of their response mode; of points nearer to each other than "
                              "a thousandth of the range, one is drawn.";
  return figure;
}

/// Names of the figures, by the parameters that are fixed in each diagram: `bifurcation_static_0.35`.
std::vector<std::string> names_of(const std::vector<ReportedDiagram>& diagrams) {
  if (diagrams.size() < 2) return std::vector<std::string>(diagrams.size(), "bifurcation");
  std::vector<std::vector<Parameter>> others;
  for (const ReportedDiagram& diagram : diagrams) others.push_back(diagram.others);
  std::vector<std::string> names = parameter_names(others);
  for (std::string& name : names) name.insert(0, "bifurcation_");
  return names;
}

}  // namespace

std::vector<Figure> bifurcation_figures(const BifurcationReport& report) {
  std::vector<Figure> figures;
  const std::string title = report.input.title();
  const std::vector<std::string> names = names_of(report.diagrams);
  for (const ReportedDiagram& diagram : report.diagrams) {
    const std::string others = values_in_words(diagram.others);
    const std::string subtitle = title + (title.empty() || others.empty() ? "" : "; ") + others;
    std::vector<std::optional<Shaking>> shakings;
    for (const ReportedStep& step : diagram.steps) shakings.push_back(step.shaking);
    Axis x = axis_of_parameter(report.parameter, shakings);
    figures.push_back(figure_of(drawn(diagram), std::move(x), report.parameter, subtitle));
    figures.back().name = names[figures.size() - 1];
  }
  return figures;
}

}  // namespace rocking::analysis
