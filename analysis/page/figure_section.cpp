#include "analysis/page/figure_section.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/tables.hpp"
#include "rocking/text/number_text.hpp"

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
  // Curves of several slices have the same column names; an interval stands before its own curve.
  for (std::size_t step = 1; step < panel.layers.size(); ++step) {
    const std::size_t other = (place + step) % panel.layers.size();
    if (is_curve(panel.layers[other]) && is_interval_of(figure, layer, panel.layers[other])) return other;
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
          {"colour", style.colour},       {"dash", style.dash},     {"marker", style.size > 0.0 ? style.marker : 0},
          {"hatch", style.hatch},         {"width", style.width},   {"opacity", style.opacity},
          {"columns", std::move(columns)}};
}

Json panel_json(const Figure& figure, const Panel& panel) {
  Json layers = Json::array();
  for (std::size_t i = 0; i < panel.layers.size(); ++i) layers.push_back(layer_json(figure, panel, i));
  return {{"title", panel.title},   {"x", axis_json(panel.x)}, {"y", axis_json(panel.y)},
          {"height", panel.height}, {"strip", panel.strip},    {"layers", std::move(layers)}};
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

constexpr std::size_t most_open_tables = 2;

/// Figures with more panels or curves are folded away.
constexpr std::size_t most_open_panels = 6;
constexpr std::size_t most_open_curves = 12;

/// Entries of the legend of the panel that has most of them.
std::size_t most_curves_of(const Figure& figure) {
  std::size_t curves = 0;
  for (const Panel& panel : figure.panels) {
    const auto named = std::ranges::count_if(panel.layers, [](const Layer& layer) { return !layer.legend.empty(); });
    curves = std::max(curves, static_cast<std::size_t>(named));
  }
  return curves;
}

/// The table with the names of categories in place of their positions along the axis.
Table with_names(Table table, const Axis& axis) {
  for (Row& row : table.rows) {
    const double* place = std::get_if<double>(&row.front());
    for (const Tick& tick : axis.ticks) {
      if (place != nullptr && *place == tick.place) {
        row.front() = tick.text;
        break;
      }
    }
  }
  return table;
}

/// A table with a column for each of many names, such as the records of a suite, with its rows as columns.
Table upright(const Table& table) {
  constexpr std::size_t most_columns = 8;
  const std::size_t columns = table.columns.size();
  if (columns <= std::max(most_columns, table.rows.size() + 1) || !table.columns.back().is_verbatim) return table;
  Table turned{.name = table.name, .columns = {{"name", "at each " + table.columns.front().meaning}}};
  for (const auto& row : table.rows) {
    const double* number = std::get_if<double>(&row.front());
    const std::string place = number != nullptr ? significant(*number, 6) : "";
    turned.columns.push_back({.name = place, .meaning = place, .is_verbatim = true});
  }
  for (std::size_t c = 1; c < columns; ++c) {
    Row& row = turned.rows.emplace_back(Row{table.columns[c].meaning});
    for (const auto& source : table.rows) row.push_back(source[c]);
  }
  return turned;
}

}  // namespace

std::string tables_html(const Report& report, const Figure& figure) {
  if (figure.name == "mode_probabilities") return mode_table_html(report);
  if (figure.name == "divergence_times") return data_table_html(side_by_side(figure.tables), figure.title);
  if (figure.name == "mode_bands") return report.most_realisations() == 1 ? mode_table_html(report) : "";  // not twice
  std::vector<std::string> tables;
  for (std::size_t i = 0; i < std::min(most_charts, figure.tables.size()); ++i) {
    const Table& table = figure.tables[i];
    if (!table.columns.empty() && !table.grid && !table.only_drawn) {
      tables.push_back(data_table_html(upright(with_names(table, figure.panels.front().x)), figure.title));
    }
  }
  std::string text, further;
  for (std::size_t i = 0; i < tables.size(); ++i) (i < most_open_tables ? text : further) += tables[i];
  return further.empty() ? text : text + folded("Further tables", further);
}

std::string figure_html(const DrawnFigure& drawn, const std::string& below) {
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
  return text + below + "</figure>\n";
}

std::string figure_with_tables_html(const Report& report, const DrawnFigure& drawn) {
  const Figure& figure = drawn.figure;
  std::string below;
  if (!figure.description.empty())
    below = fmt::format("<p class=\"description\">{}</p>\n", escaped(figure.description));
  const std::string tables = tables_html(report, figure);
  const bool is_open = tables.empty() || figure.name == "mode_probabilities";
  const std::string text = figure_html(drawn, below + (is_open ? tables : folded("Numbers", tables)));
  const std::size_t curves = most_curves_of(figure);
  if (figure.panels.size() > most_open_panels) {
    return folded(fmt::format("{} ({} charts)", escaped(figure.title), figure.panels.size()), text);
  }
  return curves > most_open_curves ? folded(fmt::format("{} ({} curves)", escaped(figure.title), curves), text) : text;
}

}  // namespace rocking::analysis
