#include "analysis/page/sections.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/tables.hpp"
#include "analysis/page/words.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/long_run_table.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr std::size_t most_long_run_modes = 5;

Cell text_cell(std::string text) { return Cell(std::move(text)); }

std::string share_of_row(std::uint64_t count, const SettlingRow& row) {
  if (count > 0) return per_cent_of(count, row.realisations) + count_if_open(count, row.realisations);
  return "< " + per_cent(bound_of_none(row.realisations, row.confidence));
}

std::string difference_text(const std::optional<double>& differ, const std::optional<stats::Interval>& interval) {
  if (!differ) return "none";
  return per_cent(*differ) + (interval ? ' ' + per_cent(*interval) : "");
}

std::string divergence_text(const SettlingResult& settling) {
  const auto& quartiles = settling.times.divergence_quartiles;
  const auto median = std::ranges::find(quartiles, 0.5, &stats::QuantileEstimate::level);
  if (median == quartiles.end()) return "none";
  std::string text = period_text(*median, std::nullopt);
  return text.starts_with('>') ? "beyond the horizon" + text.substr(text.find(" [")) : text;
}

/// The first columns of a table: the swept parameters, or the only condition.
void add_parameters(const Report& report, Table& table) {
  if (report.swept.empty()) table.columns.push_back({"condition", "condition"});
  for (const ParameterColumn& column : parameter_columns(report)) {
    table.columns.push_back({"parameter", label_of(column.axis)});
  }
}

std::vector<Cell> parameter_cells(const Report& report, std::size_t condition) {
  if (report.swept.empty()) return {text_cell("the only one")};
  std::vector<Cell> cells;
  for (const ParameterColumn& column : parameter_columns(report)) cells.push_back(text_cell(column.values[condition]));
  return cells;
}

Table settling_table(const Report& report) {
  Table table;
  add_parameters(report, table);
  for (const char* heading :
       {"unresolved at the fixed horizon [%]", "not classified in the end [%]", "median settling period",
        "99 % settled by period", "two runs differ at the fixed horizon [%]", "two runs differ in the end [%]",
        "median divergence time of two runs [periods]"}) {
    table.columns.push_back({"value", heading});
  }
  for (std::size_t i = 0; i < std::min(report.conditions.size(), most_rows + 1); ++i) {
    const auto row = settling_row(report, report.conditions[i]);
    if (!row) continue;
    const ReportedCondition& condition = report.conditions[i];
    std::vector<Cell> cells = parameter_cells(report, i);
    const auto interval = condition.result.non_recurrence
                              ? std::optional(condition.result.non_recurrence->differ_interval)
                              : std::nullopt;
    for (std::string text :
         {share_of_row(row->unresolved_at_horizon, *row), share_of_row(row->censored, *row),
          period_text(row->median, row->limit), horizon_text(row->all_but_one_per_cent),
          difference_text(row->differ_at_horizon, condition.result.settling->differ_interval),
          difference_text(row->differ_in_the_end, interval), divergence_text(*condition.result.settling)}) {
      cells.push_back(text_cell(std::move(text)));
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table leaving_table(const Report& report) {
  Table table;
  add_parameters(report, table);
  for (const char* heading : {"response mode", "left", "watched periods", "left per 1000 periods"}) {
    table.columns.push_back({"value", heading});
  }
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report, report.conditions[i]);
    if (!row) continue;
    for (const LeftMode& found : row->leaving) {
      std::vector<Cell> cells = parameter_cells(report, i);
      cells.push_back(text_cell(to_string(found.mode)));
      cells.emplace_back(static_cast<double>(found.left));
      cells.push_back(text_cell(std::to_string(found.watched_periods)));
      cells.push_back(text_cell(leaving_text(found)));
      table.rows.push_back(std::move(cells));
    }
  }
  return table;
}

std::string remedies_html(const Report& report) {
  std::string entries;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report, report.conditions[i]);
    if (!row) continue;
    const std::string remedy = limit_remedy(*row, name_of_condition(report, report.conditions[i]));
    if (!remedy.empty()) entries += "<li>" + with_symbols(remedy) + ".</li>\n";
  }
  return entries.empty() ? "" : "<p>The limit is too short:</p>\n<ul>\n" + entries + "</ul>\n";
}

std::string leaving_html(const Report& report) {
  const Table table = leaving_table(report);
  if (table.rows.empty()) {
    return "<p>Settled responses were not watched, so that it is not known how often they are left again. "
           "<code>watch_windows</code> of <code>until_classified</code> watches them.</p>\n";
  }
  std::uint64_t left = 0;
  bool often = false;
  const std::vector<SettlingRow> rows = settling_rows(report);
  for (const SettlingRow& row : rows) {
    for (const LeftMode& found : row.leaving) {
      left += found.left;
      often = often || may_be_left(found);
    }
  }
  std::string text = left == 0 ? "<p>No settled response was left in " + none_left_text(rows) + ".</p>\n"
                               : fmt::format("<p>Settled responses were left {} while they were watched.{}</p>\n",
                                             counted(left, "time"),
                                             often ? " Where the rate is not small, the label of a response is that of "
                                                     "a window of periods, not of all time."
                                                   : "");
  return text + data_table_html(table, "How often settled responses were left again, with exact " + report.level() +
                                           " intervals of the rate");
}

Table long_run_table(const Report& report, const std::vector<ResponseMode>& modes) {
  Table table;
  add_parameters(report, table);
  table.columns.push_back({"value", "realisations with a long run"});
  table.columns.push_back({"value", "windows of each"});
  for (const ResponseMode& mode : modes) table.columns.push_back({"value", to_string(mode) + " [%]"});
  table.columns.push_back({"value", "others [%]"});
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report, report.conditions[i]);
    if (!row || !row->long_runs) continue;
    std::vector<Cell> cells = parameter_cells(report, i);
    cells.emplace_back(static_cast<double>(row->long_runs->realisations));
    cells.emplace_back(static_cast<double>(row->long_runs->windows));
    for (const ResponseMode& mode : modes) cells.push_back(text_cell(long_run_cell(*row, mode)));
    cells.push_back(text_cell(other_long_run_shares(*row, modes)));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

std::string long_run_html(const Report& report) {
  const std::vector<SettlingRow> rows = settling_rows(report);
  const std::vector<ResponseMode> modes = long_run_modes(rows, most_long_run_modes);
  if (modes.empty()) return "";
  return fmt::format("<p>{}.</p>\n", escaped(long_run_meaning)) +
         data_table_html(long_run_table(report, modes),
                         "Long-run shares of time: windows of long runs by response mode, in per cent [" +
                             report.level() + " interval, each mode alone]; <: no window, an upper bound");
}

}  // namespace

std::string settling_html(const Report& report) {
  const std::vector<SettlingRow> rows = settling_rows(report);
  if (rows.empty()) return "";
  std::uint64_t realisations = 0;
  std::uint64_t unresolved = 0;
  std::uint64_t censored = 0;
  for (const SettlingRow& row : rows) {
    realisations += row.realisations;
    unresolved += row.unresolved_at_horizon;
    censored += row.censored;
  }
  const auto& first = rows.front();
  const bool one_limit =
      first.limit && std::ranges::all_of(rows, [&](const SettlingRow& row) { return row.limit == first.limit; });
  const std::string limit = one_limit ? fmt::format("{} periods", *first.limit) : "its limit";
  const std::string proviso = end_proviso(rows);
  return fmt::format(
             "<p>All shares on this page are those in the end. A realisation that is unresolved at the fixed horizon "
             "goes on until its response is classified, for up to {}. {} of {} were unresolved at the fixed horizon; "
             "<strong>{}</strong> were not classified in the end.{}</p>\n",
             limit, unresolved, counted(realisations, "realisation"), censored,
             proviso.empty() ? "" : " In the end " + escaped(proviso) + '.') +
         remedies_html(report) +
         data_table_html(settling_table(report),
                         "When responses settled [" + report.level() +
                             " interval; -: open]; <: did not occur, the upper end of its interval; >: beyond the "
                             "observation" +
                             count_legend(report.most_realisations())) +
         leaving_html(report) + long_run_html(report) +
         "<p class=\"small\">The charts show the interval at each time; the picture for printing and the files of "
         "<code>rocking report DIR</code> also have the band for all times at once.</p>\n";
}

}  // namespace rocking::analysis
