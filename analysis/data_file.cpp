#include "analysis/figure_scripts.hpp"

#include <algorithm>

#include "analysis/gnuplot_text.hpp"

namespace rocking::analysis {
namespace {

/// One line, without characters that would end a quoted text.
std::string harmless(const std::string& text) {
  std::string line = printable(text);
  std::replace(line.begin(), line.end(), '"', '\'');
  return line;
}

std::string field(const Cell& cell) {
  if (std::holds_alternative<std::string>(cell)) return '"' + harmless(std::get<std::string>(cell)) + '"';
  return cell_text(cell);
}

std::string header_of(const Table& table) {
  std::string text = "# " + harmless(table.name) + '\n';
  if (table.grid) {
    const Table::Grid& grid = *table.grid;
    text += "# column i: x = " + number_text(grid.x) + " + i " + number_text(grid.dx);
    text += "; line j: y = " + number_text(grid.y) + " + j " + number_text(grid.dy) + "; both count from 0\n";
    return text;
  }
  std::string names = "#";
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    text += "# " + std::to_string(i + 1) + ' ' + harmless(table.columns[i].name) + ": " +
            harmless(table.columns[i].meaning) + '\n';
    names += (i == 0 ? " " : "\t") + harmless(table.columns[i].name);
  }
  return text + names + '\n';
}

}  // namespace

std::string data_text(const Figure& figure) {
  std::string text = "# " + harmless(figure.title) + '\n';
  for (const std::string& line : {figure.subtitle, figure.caption}) {
    if (!line.empty()) text += "# " + harmless(line) + '\n';
  }
  for (std::size_t i = 0; i < figure.tables.size(); ++i) {
    const Table& table = figure.tables[i];
    text += (i == 0 ? "" : "\n\n") + header_of(table);
    if (table.rows.empty()) text += "NaN\n";  // so that gnuplot counts it as a block
    for (const auto& row : table.rows) {
      for (std::size_t j = 0; j < row.size(); ++j) text += (j == 0 ? "" : "\t") + field(row[j]);
      text += '\n';
    }
  }
  return text;
}

}  // namespace rocking::analysis
