#include <algorithm>
#include <cmath>
#include <utility>

#include "rocking/base/number_text.hpp"
#include "rocking/look/table.hpp"

namespace rocking::look {
namespace {

std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string digits_of(const std::optional<double>& number, Form form) {
  if (number && !std::isfinite(*number)) return "unbounded";
  const bool is_whole = form.kind == Form::Kind::fixed && form.digits == 0;
  return !number ? "" : is_whole ? in_form(*number, form) : base::shortest(*number);
}

std::string fields_of(const Cell& cell, bool has_interval) {
  if (const std::string* words = std::get_if<std::string>(&cell)) return field(*words);
  const Number* number = std::get_if<Number>(&cell);
  if (number == nullptr) return has_interval ? ",," : "";
  const std::string value = digits_of(number->value, number->form);
  if (!has_interval) return value;
  const Ends ends = number->interval.value_or(Ends({}, {}));
  return value + ',' + digits_of(ends.low, number->form) + ',' + digits_of(ends.high, number->form);
}

}  // namespace

std::string csv_line(const std::vector<Column>& columns, const Row& row) {
  std::string line;
  bool is_first = true;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!is_shown_in(Media::csv, columns[i].media)) continue;
    line += (std::exchange(is_first, false) ? "" : ",") + fields_of(row[i], columns[i].has_interval);
  }
  return line + '\n';
}

std::string to_csv(const Table& all) {
  const Table table = part_in(Media::csv, all);
  const bool are_several = std::ranges::count(table.columns, true, &Column::has_interval) > 1;
  std::string text;
  for (const Column& column : table.columns) {
    const std::string start = are_several ? column.title + '_' : "";
    text += (text.empty() ? "" : ",") + field(column.title);
    if (column.has_interval) text += ',' + field(start + "low") + ',' + field(start + "high");
  }
  text += '\n';
  for (const Row& row : table.rows) text += csv_line(table.columns, row);
  return text;
}

}  // namespace rocking::look
