#include "analysis/page/tables.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/words.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

struct PageCell {
  std::string html;
  std::optional<double> value;  ///< by which it is sorted, if that is not the number with which its text begins
};

struct PageTable {
  std::string label;                        ///< plain text, escaped
  std::string caption;                      ///< HTML
  std::vector<std::string> head;            ///< HTML
  std::vector<std::vector<PageCell>> rows;  ///< the first cell of a row is its heading
  std::size_t all_rows = 0;                 ///< including omitted ones
};

constexpr int digits_with_interval = 4;

PageCell cell_of(std::string html) { return {.html = std::move(html), .value = {}}; }

/// The script of the page makes the buttons; without it there are none.
std::string html_of(const PageTable& table) {
  std::string text = fmt::format(
      "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><table class=\"sortable\">"
      "<caption><span>{}</span></caption>\n<thead><tr>",
      table.label, table.caption);
  for (const std::string& cell : table.head) text += fmt::format("<th scope=\"col\">{}</th>", cell);
  text += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    text += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string value = row[i].value ? fmt::format(" data-value=\"{}\"", *row[i].value) : "";
      text += i == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", value, row[i].html)
                     : fmt::format("<td{}>{}</td>", value, row[i].html);
    }
    text += "</tr>\n";
  }
  text += "</tbody></table></div>\n";
  if (table.all_rows > table.rows.size()) {
    text += fmt::format(
        "<p class=\"limit\">The first {} of {} rows. <code>rocking report DIR --format csv</code> writes "
        "all of them.</p>\n",
        table.rows.size(), table.all_rows);
  }
  return text;
}

PageCell mode_cell(const ReportedCondition& condition, const section::ResponseMode& mode) {
  const AnyShare share = share_of(condition, mode);
  if (share.count == 0) {
    if (!share.interval) return {.html = "0", .value = {}};
    return {.html = "<span class=\"none\">&lt; " + per_cent(share.interval->high) + "</span>", .value = 0.0};
  }
  const std::string estimate = per_cent(share.estimate);
  if (!share.interval) return {.html = estimate, .value = {}};
  return {.html = fmt::format("{} <span class=\"interval\">{}</span>{}", estimate, per_cent(*share.interval),
                              count_if_open(share.count, condition.result.realisations)),
          .value = {}};
}

/// The response of a condition that is not random.
std::string response_of(const ReportedCondition& condition) {
  for (const auto& [mode, probability] : condition.result.modes) {
    if (probability.counts.successes > 0) return escaped(to_string(mode));
  }
  return "<span class=\"none\">none</span>";
}

std::string column_name(const Axis& axis) {
  return escaped(axis.quantity) + (axis.symbol.empty() ? "" : ' ' + symbol_html(axis.symbol)) +
         (axis.unit.empty() ? "" : " [" + with_symbols(axis.unit) + ']');
}

std::string cell_html(const Cell& cell, int digits = 5) {
  if (const double* number = std::get_if<double>(&cell)) return significant(*number, digits);
  if (const std::string* text = std::get_if<std::string>(&cell)) return escaped(*text);
  return "<span class=\"none\">none</span>";
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

std::string interval_html(const Cell& low, const Cell& high) {
  const auto is_open = [](const Cell& cell) { return std::holds_alternative<std::monostate>(cell); };
  if (is_open(low) && is_open(high)) return "";
  return fmt::format(" <span class=\"interval\">[{}, {}]</span>",
                     is_open(low) ? "open" : cell_html(low, digits_with_interval),
                     is_open(high) ? "open" : cell_html(high, digits_with_interval));
}

}  // namespace

std::string mode_table_html(const Report& report) {
  PageTable table;
  table.label = "Table: response modes";
  table.caption = "Response of each condition. Nothing is random: one realisation is the response";
  const bool random = report.is_random();
  if (random) {
    table.caption = fmt::format(
        "Response modes{} in per cent of the realisations [{} interval, simultaneous for all modes of a condition]; "
        "&lt; "
        "<i>x</i>: did not occur, <i>x</i> is the upper end of its interval{}",
        report.has_settling() ? " in the end" : "", escaped(report.level()), count_legend(report.most_realisations()));
  }
  if (report.swept.empty()) table.head.emplace_back("condition");
  const std::vector<ParameterColumn> columns = parameter_columns(report);
  for (const ParameterColumn& column : columns) table.head.push_back(column_name(column.axis));
  const auto modes = report.occurring();
  if (random) {
    table.head.emplace_back("<i>n</i>");
    for (const auto& [mode, count] : modes) table.head.push_back(escaped(to_string(mode)));
  } else {
    table.head.emplace_back("response");
  }
  table.all_rows = report.conditions.size();
  for (std::size_t i = 0; i < std::min(most_rows, report.conditions.size()); ++i) {
    const ReportedCondition& condition = report.conditions[i];
    std::vector<PageCell> row;
    if (report.swept.empty()) row.push_back(cell_of("the only one"));
    for (const ParameterColumn& column : columns) row.push_back(cell_of(escaped(column.values[i])));
    if (random) {
      row.push_back(cell_of(std::to_string(condition.result.realisations)));
      for (const auto& [mode, count] : modes) row.push_back(mode_cell(condition, mode));
    } else {
      row.push_back(cell_of(response_of(condition)));
    }
    table.rows.push_back(std::move(row));
  }
  return html_of(table);
}

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
  PageTable shown;
  shown.label = "Table: " + escaped(title) + (table.name.empty() ? "" : " (" + escaped(table.name) + ')');
  shown.caption = escaped(title) + (table.name.empty() ? "" : " (" + with_symbols(table.name) + ')');
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    shown.head.push_back(head_html(table, i));
    if (has_interval(table, i)) i += 2;
  }
  shown.all_rows = table.rows.size();
  for (std::size_t r = 0; r < std::min(most_rows, table.rows.size()); ++r) {
    const std::vector<Cell>& cells = table.rows[r];
    std::vector<PageCell> row;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      row.push_back(cell_of(cell_html(cells[i], has_interval(table, i) ? digits_with_interval : 5)));
      if (!has_interval(table, i)) continue;
      row.back().html += interval_html(cells[i + 1], cells[i + 2]);
      i += 2;
    }
    shown.rows.push_back(std::move(row));
  }
  return html_of(shown);
}

}  // namespace rocking::analysis
