#include "rocking/figures/figure.hpp"

#include <charconv>

#include <utility>

#include "rocking/base/error.hpp"

namespace rocking::analysis {

std::string label_of(const Axis& axis) {
  std::string label = axis.quantity;
  if (!axis.symbol.empty()) label += (label.empty() ? "" : " ") + axis.symbol;
  if (!axis.unit.empty()) label += " [" + axis.unit + ']';
  return label;
}

void add_layer(Table table, LayerKind kind, const Style& style, const std::string& legend, Figure& figure) {
  if (table.rows.empty()) return;
  for (Panel& panel : figure.panels) {
    panel.layers.push_back(
        {.kind = kind, .table = figure.tables.size(), .columns = {0, 1}, .style = style, .legend = legend});
  }
  figure.tables.push_back(std::move(table));
}

void add_drawn(Table table, Layer layer, Figure& figure) {
  if (table.rows.empty()) return;
  table.only_drawn = true;
  layer.table = figure.tables.size();
  figure.tables.push_back(std::move(table));
  figure.panels.back().layers.push_back(std::move(layer));
}

std::string number_text(double number) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, number);
  ROCKING_EXPECT(error == std::errc());
  static_cast<void>(error);
  return {text, end};
}

std::string cell_text(const Cell& cell) {
  if (const double* number = std::get_if<double>(&cell)) return number_text(*number);
  if (const std::string* text = std::get_if<std::string>(&cell)) return *text;
  return "NaN";
}

}  // namespace rocking::analysis
