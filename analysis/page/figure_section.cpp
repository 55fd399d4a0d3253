#include "analysis/page/figure_section.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/tables.hpp"

namespace rocking::analysis {
namespace {

std::string_view name_of(LayerKind kind) {
  switch (kind) {
    case LayerKind::boxes: return "boxes";
    case LayerKind::line: return "line";
    case LayerKind::ribbon: return "ribbon";
    case LayerKind::points: return "points";
    case LayerKind::error_bars: return "error_bars";
    case LayerKind::steps: return "steps";
    case LayerKind::image: return "image";
    case LayerKind::spans: return "spans";
    case LayerKind::arrows: return "arrows";
    case LayerKind::polygon: return "polygon";
    case LayerKind::texts: return "texts";
  }
  return "";
}

/// Whether the script of the page can draw the panel; otherwise there is the picture only.
bool can_be_charted(const Panel& panel) {
  constexpr std::array known{LayerKind::boxes,      LayerKind::line,  LayerKind::ribbon, LayerKind::points,
                             LayerKind::error_bars, LayerKind::steps, LayerKind::spans};
  const auto is_known = [&](const Layer& layer) { return std::ranges::find(known, layer.kind) != known.end(); };
  return !panel.to_scale && std::ranges::all_of(panel.layers, is_known);
}

Json cell_json(const Cell& cell) {
  if (const double* number = std::get_if<double>(&cell)) return *number;
  return {};
}

Json number_or_null(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

Json axis_json(const Axis& axis) {
  Json ticks = Json::array();
  for (const Tick& tick : axis.ticks) ticks.push_back({tick.place, tick.text});
  return {{"quantity", axis.quantity},
          {"symbol", axis.symbol},
          {"unit", axis.unit},
          {"low", number_or_null(axis.low)},
          {"high", number_or_null(axis.high)},
          {"ticks", std::move(ticks)},
          {"logarithmic", axis.logarithmic}};
}

bool is_curve(const Layer& layer) {
  return layer.kind == LayerKind::line || layer.kind == LayerKind::points || layer.kind == LayerKind::steps;
}

const Column& column_of(const Figure& figure, const Layer& layer, std::size_t place) {
  return figure.tables[layer.table].columns[layer.columns[place]];
}

/// Whether a ribbon or error bars are the interval of a curve: its lower end has the column name `mode_low` if the
/// column of the curve has the name `mode`, or it is the column after that of the curve.
bool is_interval_of(const Figure& figure, const Layer& layer, const Layer& curve) {
  const std::size_t place = layer.columns.size() - 2;
  if (column_of(figure, curve, 1).name + "_low" == column_of(figure, layer, place).name) return true;
  return curve.table == layer.table && curve.columns[1] + 1 == layer.columns[place];
}

/// The place of the curve whose interval the layer is; otherwise the place of the layer itself.
std::size_t group_of(const Figure& figure, const Panel& panel, std::size_t place) {
  const Layer& layer = panel.layers[place];
  if (layer.kind != LayerKind::ribbon && layer.kind != LayerKind::error_bars) return place;
  for (std::size_t i = 0; i < panel.layers.size(); ++i) {
    if (is_curve(panel.layers[i]) && is_interval_of(figure, layer, panel.layers[i])) return i;
  }
  return place;
}

Json layer_json(const Figure& figure, const Panel& panel, std::size_t place) {
  const Layer& layer = panel.layers[place];
  Json columns = Json::array();
  for (const std::size_t column : layer.columns) {
    Json numbers = Json::array();
    for (const auto& row : figure.tables[layer.table].rows) numbers.push_back(cell_json(row[column]));
    columns.push_back(std::move(numbers));
  }
  const Style& style = layer.style;
  return {{"kind", name_of(layer.kind)},  {"legend", layer.legend}, {"group", group_of(figure, panel, place)},
          {"colour", style.colour},       {"dash", style.dash},     {"marker", style.marker},
          {"hatch", style.hatch},         {"width", style.width},   {"opacity", style.opacity},
          {"columns", std::move(columns)}};
}

Json panel_json(const Figure& figure, const Panel& panel) {
  Json layers = Json::array();
  for (std::size_t i = 0; i < panel.layers.size(); ++i) layers.push_back(layer_json(figure, panel, i));
  return {{"title", panel.title}, {"x", axis_json(panel.x)}, {"y", axis_json(panel.y)}, {"layers", std::move(layers)}};
}

std::string charts_html(const Figure& figure) {
  const std::size_t shown = std::min(most_charts, figure.panels.size());
  Json panels = Json::array();
  for (std::size_t i = 0; i < shown; ++i) panels.push_back(panel_json(figure, figure.panels[i]));
  std::string text = fmt::format(
      "<div class=\"charts\" data-figure=\"{0}\"></div>\n<script type=\"application/json\" "
      "id=\"data-{0}\">{1}</script>\n",
      escaped(figure.name), json_for_script({{"name", figure.name}, {"panels", panels}}));
  if (figure.panels.size() > shown) {
    text += fmt::format("<p class=\"limit charts-only\">The first {} of {} panels.</p>\n", shown, figure.panels.size());
  }
  return text;
}

std::string picture_html(const DrawnFigure& drawn, bool charted) {
  if (drawn.svg.empty()) return "<p class=\"limit\">There is no picture for printing: gnuplot could not draw it.</p>\n";
  if (drawn.svg.size() > most_picture_bytes) {
    return "<p class=\"limit\">The picture is too large for a page: <code>rocking report DIR --format gnuplot</code> "
           "draws it.</p>\n";
  }
  const Figure& figure = drawn.figure;
  const std::string words = figure.description.empty() ? figure.title + ". " + figure.caption : figure.description;
  return fmt::format("<img class=\"picture{}\" alt=\"{}\" src=\"{}\">\n", charted ? " instead" : "", escaped(words),
                     data_address("svg+xml", drawn.svg));
}

std::string tables_html(const Report& report, const Figure& figure) {
  const bool has_probabilities = std::ranges::any_of(
      report.conditions, [](const ReportedCondition& condition) { return condition.result.realisations > 1; });
  if (figure.name == "mode_probabilities") return mode_table_html(report);
  if (figure.name == "mode_bands") return has_probabilities ? "" : mode_table_html(report);  // not twice
  if (figure.name == "divergence_times") return data_table_html(side_by_side(figure.tables), figure.title);
  std::string text;
  for (std::size_t i = 0; i < std::min(most_charts, figure.tables.size()); ++i) {
    const Table& table = figure.tables[i];
    if (!table.columns.empty() && !table.grid && !table.only_drawn) text += data_table_html(table, figure.title);
  }
  return text;
}

}  // namespace

std::string figure_html(const Report& report, const DrawnFigure& drawn) {
  const Figure& figure = drawn.figure;
  std::size_t rows = 0;
  for (const Table& table : figure.tables) rows += table.rows.size();
  const bool charted = rows <= most_charted_rows && std::ranges::all_of(figure.panels, can_be_charted);
  const std::string name = escaped(figure.name);
  std::string text = fmt::format("<figure id=\"{0}\" aria-labelledby=\"title-{0}\">\n<h3 id=\"title-{0}\">{1}</h3>\n",
                                 name, escaped(figure.title));
  if (charted) text += charts_html(figure);
  text += picture_html(drawn, charted);
  text += fmt::format("<figcaption>{}</figcaption>\n", lowered(figure.caption));
  if (!figure.description.empty()) {
    text += fmt::format("<p class=\"description\">{}</p>\n", escaped(figure.description));
  }
  return text + tables_html(report, figure) + "</figure>\n";
}

}  // namespace rocking::analysis
