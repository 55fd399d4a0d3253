#include "rocking/figures/figure.hpp"

#include <algorithm>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"

namespace rocking::analysis {

std::string label_of(const Axis& axis) {
  std::string label = axis.quantity;
  if (!axis.symbol.empty()) label += (label.empty() ? "" : " ") + axis.symbol;
  if (!axis.unit.empty()) label += " [" + axis.unit + ']';
  return label;
}

std::vector<std::size_t> first_columns(LayerKind kind) {
  switch (kind) {
    case LayerKind::image: return {};
    case LayerKind::line:
    case LayerKind::points:
    case LayerKind::steps:
    case LayerKind::spans:
    case LayerKind::polygon: return {0, 1};
    case LayerKind::ribbon:
    case LayerKind::texts: return {0, 1, 2};
    case LayerKind::boxes:
    case LayerKind::error_bars:
    case LayerKind::arrows: return {0, 1, 2, 3};
  }
  return {};
}

std::vector<std::size_t> places_of(const Table& table, const std::vector<std::string>& names) {
  std::vector<std::size_t> places;
  for (const std::string& name : names) {
    const auto found = std::ranges::find(table.columns, name, &Column::name);
    ROCKING_EXPECT(found != table.columns.end());
    places.push_back(static_cast<std::size_t>(found - table.columns.begin()));
  }
  return places;
}

void draw(Layer layer, const std::vector<std::string>& columns, Figure& figure, std::optional<std::size_t> panel) {
  layer.columns = columns.empty() ? first_columns(layer.kind) : places_of(figure.tables.at(layer.table), columns);
  figure.panels.at(panel.value_or(figure.panels.size() - 1)).layers.push_back(std::move(layer));
}

void draw(Table table, Layer layer, const std::vector<std::string>& columns, Figure& figure) {
  layer.table = figure.tables.size();
  figure.tables.push_back(std::move(table));
  draw(std::move(layer), columns, figure);
}

void add_layer(Table table, LayerKind kind, const Style& style, const std::string& legend, Figure& figure) {
  if (table.rows.empty()) return;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    draw({.kind = kind, .table = figure.tables.size(), .style = style, .legend = legend}, {}, figure, i);
  }
  figure.tables.push_back(std::move(table));
}

void add_drawn(Table table, Layer layer, Figure& figure) {
  if (table.rows.empty()) return;
  table.only_drawn = true;
  draw(std::move(table), std::move(layer), {}, figure);
}

void add_estimate(Table& table, const Column& estimate, const std::string& unit) {
  table.columns.push_back(estimate);
  table.columns.push_back({estimate.name + "_low", "lower end of its " + estimate.interval + unit});
  table.columns.push_back({estimate.name + "_high", "upper end of it" + unit});
}

Table drawn_part(const Table& whole, const std::string& what, const std::vector<std::string>& columns) {
  Table part{.name = what + whole.name, .columns = {}, .only_drawn = true};
  part.rows.resize(whole.rows.size());
  for (const std::size_t place : places_of(whole, columns)) {
    part.columns.push_back(whole.columns[place]);
    for (std::size_t i = 0; i < whole.rows.size(); ++i) part.rows[i].push_back(whole.rows[i][place]);
  }
  return part;
}

std::string number_text(double number) { return base::shortest(number); }

std::string cell_text(const Cell& cell) {
  if (const double* number = std::get_if<double>(&cell)) return number_text(*number);
  if (const std::string* text = std::get_if<std::string>(&cell)) return *text;
  return "NaN";
}

}  // namespace rocking::analysis
