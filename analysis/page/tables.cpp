#include "analysis/page/tables.hpp"

#include <cmath>
#include <map>
#include <vector>

#include "analysis/page/html.hpp"

namespace rocking::analysis {
namespace {

/// Counts and places along the sweep in full, estimates in three digits.
look::Form form_of(double number, bool is_place) {
  if (number == std::trunc(number) || std::abs(number) >= 1000.0) return look::decimals(0);
  return is_place ? 6 : 3;
}

look::Cell look_of(const Cell& cell, bool is_place) {
  if (const double* number = std::get_if<double>(&cell)) return look::number(*number, form_of(*number, is_place));
  if (const std::string* text = std::get_if<std::string>(&cell)) return *text;
  return {};
}

/// The name of a column and, below it, that of its interval.
std::string head_html(const Column& column) {
  const std::string name = column.is_verbatim ? escaped(column.meaning) : lowered(column.meaning);
  return name + (column.interval.empty() ? "" : " <span class=\"interval\">[" + escaped(column.interval) + "]</span>");
}

/// A value with the ends of its interval.
look::Cell look_of(const Cell& value, const Cell& low, const Cell& high) {
  const auto number = [](const Cell& cell) {
    const double* found = std::get_if<double>(&cell);
    return found == nullptr ? std::nullopt : std::optional(*found);
  };
  look::Number shown{.value = number(value), .form = 3};
  if (number(low) || number(high)) shown.interval = look::Ends(number(low), number(high));
  return shown;
}

}  // namespace

Table side_by_side(const std::vector<Table>& tables) {
  Table joined{.name = "", .columns = {tables.front().columns.front()}, .rows = {}};
  std::map<double, std::vector<Cell>> levels;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    joined.columns.push_back({.name = tables[i].name, .meaning = tables[i].name, .is_verbatim = true});
    for (const auto& row : tables[i].rows) {
      std::vector<Cell>& cells = levels[std::get<double>(row[0])];
      cells.resize(tables.size());
      cells[i] = row[1];
    }
  }
  std::vector<Cell> held(tables.size());
  for (const auto& [place, cells] : levels) {
    std::vector<Cell> row{place};
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (!std::holds_alternative<std::monostate>(cells[i])) held[i] = cells[i];
      row.push_back(held[i]);
    }
    joined.rows.push_back(std::move(row));
  }
  return joined;
}

std::string data_table_html(const Table& table, const std::string& title) {
  look::Table shown;
  shown.rows.resize(table.rows.size());
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    const Column& column = table.columns[i];
    shown.columns.push_back({.title = "", .html = head_html(column)});
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      const Row& cells = table.rows[r];
      shown.rows[r].push_back(column.interval.empty() ? look_of(cells[i], i == 0)
                                                      : look_of(cells[i], cells[i + 1], cells[i + 2]));
    }
    if (!column.interval.empty()) i += 2;
  }
  return to_html(shown,
                 {.label = "Table: " + escaped(title) + (table.name.empty() ? "" : " (" + escaped(table.name) + ')'),
                  .html = escaped(title) + (table.name.empty() ? "" : " (" + with_symbols(table.name) + ')')},
                 most_rows);
}

std::string table_html(const RunTable& table, const std::string& label) {
  if (table.table.rows.empty()) return "";
  return to_html(table.table, {.label = "Table: " + escaped(label), .html = escaped(table.caption)}, most_rows);
}

std::string mode_table_html(const Report& report) {
  return table_html(response_table(report, look::Media::page), "response modes");
}

}  // namespace rocking::analysis
