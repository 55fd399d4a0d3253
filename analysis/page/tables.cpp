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

/// Whether the two columns after this one are the ends of its interval: `low` and `high`, or `mode_low` and `mode_high`.
bool has_interval(const Table& table, std::size_t place) {
  if (place + 2 >= table.columns.size()) return false;
  const std::string& low = table.columns[place + 1].name;
  const std::string& high = table.columns[place + 2].name;
  return (low == "low" && high == "high") || (low.ends_with("_low") && high == low.substr(0, low.size() - 3) + "high");
}

/// The name of a column and, below it, that of its interval, whose lower end is the `lower end of its 95 % interval`.
std::string head_html(const Table& table, std::size_t place) {
  const Column& column = table.columns[place];
  const std::string name = column.is_verbatim ? escaped(column.meaning) : lowered(column.meaning);
  if (!has_interval(table, place)) return name;
  std::string interval = table.columns[place + 1].meaning;
  if (const auto its = interval.find(" its "); its != std::string::npos) interval.erase(0, its + 5);
  if (const auto unit = interval.find(" ["); unit != std::string::npos) interval.erase(unit);
  return name + " <span class=\"interval\">[" + escaped(interval) + "]</span>";
}

/// A value with the ends of its interval.
look::Cell look_of(const Cell& value, const Cell& low, const Cell& high) {
  const auto end = [](const Cell& cell) {
    const double* number = std::get_if<double>(&cell);
    return number == nullptr ? std::nullopt : std::optional(*number);
  };
  look::Number shown{.value = end(value), .form = 3};
  if (end(low) || end(high)) shown.interval = look::Ends(end(low), end(high));
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
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    shown.columns.push_back({.title = "", .html = head_html(table, i)});
    if (has_interval(table, i)) i += 2;
  }
  for (const std::vector<Cell>& cells : table.rows) {
    look::Row& row = shown.rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const bool with_interval = has_interval(table, i);
      row.push_back(with_interval ? look_of(cells[i], cells[i + 1], cells[i + 2]) : look_of(cells[i], i == 0));
      if (with_interval) i += 2;
    }
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
