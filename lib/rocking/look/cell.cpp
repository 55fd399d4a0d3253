#include <cmath>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/look/table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::look {
namespace {

std::string end_words(const std::optional<double>& end, Form form, const std::string& open) {
  if (!end) return open;
  return std::isfinite(*end) ? in_form(*end, form) : "unbounded";
}

}  // namespace

std::string in_form(double value, Form form) {
  switch (form.kind) {
    case Form::Kind::significant: break;
    case Form::Kind::fixed: return fixed_point(value, form.digits);
    case Form::Kind::per_cent: return per_cent(value, form.digits);
    case Form::Kind::rate: return rate_text(value);
  }
  return significant(value, form.digits);
}

std::string interval_words(const Number& number, const std::string& open) {
  if (!number.interval) return "";
  return '[' + end_words(number.interval->low, number.form, open) + ", " +
         end_words(number.interval->high, number.form, open) + ']';
}

Cell number(const std::optional<double>& value, Form form, std::string after) {
  return value ? Cell(Number{.value = value, .form = form, .after = std::move(after)}) : Cell();
}

Cell number(double value, const std::optional<stats::Interval>& interval, Form form, std::string after) {
  return Number{.value = value, .form = form, .interval = interval, .after = std::move(after)};
}

Cell interval(const std::optional<stats::Interval>& ends, Form form) {
  return ends ? Cell(interval_words({.value = {}, .form = form, .interval = Ends(*ends)}, "-")) : Cell();
}

Cell whole(std::uint64_t count) { return Number{.value = static_cast<double>(count), .form = decimals(0)}; }

void add_columns(Table& table, const std::vector<std::string>& titles) {
  for (const std::string& title : titles) table.columns.push_back({.title = title});
}

void append(Row& row, const Row& cells) { row.insert(row.end(), cells.begin(), cells.end()); }

Table part_in(Media medium, const Table& table) {
  Table part{
      .title = table.title, .rows = std::vector<Row>(table.rows.size()), .notes = table.notes, .absent = table.absent};
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (!is_shown_in(medium, table.columns[i].media)) continue;
    part.columns.push_back(table.columns[i]);
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
      ROCKING_EXPECT(table.rows[r].size() == table.columns.size());
      part.rows[r].push_back(table.rows[r][i]);
    }
  }
  return part;
}

Table narrowed(Table table, std::size_t width) {
  table = part_in(Media::terminal, table);
  while (table.columns.size() > 1 && width_of(table) > width) {
    table.columns.pop_back();
    for (Row& row : table.rows) row.pop_back();
  }
  return table;
}

Cell without_interval(Cell cell) {
  if (auto* number = std::get_if<Number>(&cell)) number->interval.reset();
  return cell;
}

std::string plain_text(const Cell& cell, const std::string& absent) {
  if (const std::string* words = std::get_if<std::string>(&cell)) return *words;
  const Number* number = std::get_if<Number>(&cell);
  if (number == nullptr) return absent;
  const std::string ends = interval_words(*number, "-");
  return (number->bound == '\0' ? "" : std::string{number->bound, ' '}) +
         (number->value ? in_form(*number->value, number->form) : absent) + (ends.empty() ? "" : ' ' + ends) +
         number->after;
}

void merge_rows(Table& table, std::size_t first, std::size_t count) {
  const auto differ_only_there = [&](const Row& a, const Row& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      if ((i < first || i >= first + count) && plain_text(a[i]) != plain_text(b[i])) return false;
    }
    return true;
  };
  std::vector<Row> merged;
  for (std::size_t from = 0, to = 0; from < table.rows.size(); from = ++to) {
    while (to + 1 < table.rows.size() && differ_only_there(table.rows[from], table.rows[to + 1])) ++to;
    Row& row = merged.emplace_back(table.rows[from]);
    for (std::size_t i = first; i < first + count && to > from; ++i) {
      row[i] = plain_text(row[i], table.absent) + " to " + plain_text(table.rows[to][i], table.absent);
    }
  }
  table.rows = std::move(merged);
}

}  // namespace rocking::look
