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
#include "rocking/output/mode_table.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr std::size_t most_long_run_modes = 5;

std::string share_of_row(std::uint64_t count, const SettlingRow& row) {
  return plain_text(count > 0 ? part_cell(count, row.realisations)
                              : bound_cell(bound_of_none(row.realisations, row.confidence)));
}

std::string difference_text(const std::optional<double>& differ, const std::optional<stats::Interval>& interval) {
  if (!differ) return "none";
  return per_cent(*differ) + (interval ? ' ' + per_cent(*interval) : "");
}

std::string divergence_text(const SettlingResult& settling) {
  const auto& quartiles = settling.times.divergence_quartiles;
  const auto median = std::ranges::find(quartiles, 0.5, &stats::QuantileEstimate::level);
  if (median == quartiles.end()) return "none";
  std::string text = plain_text(period_cell(*median, std::nullopt));
  return text.starts_with('>') ? "beyond the horizon" + text.substr(text.find(" [")) : text;
}

/// A page has words in this table, whose intervals are not set apart.
look::Table settling_table(const Report& report) {
  const std::vector<ParameterColumn> parameters = parameter_columns(report);
  look::Table table = table_of_conditions(report, parameters);
  add_columns(table, {"unresolved at the fixed horizon [%]", "not classified in the end [%]", "median settling period",
                      "99 % settled by period", "two runs differ at the fixed horizon [%]",
                      "two runs differ in the end [%]", "median divergence time of two runs [periods]"});
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report.conditions[i]);
    if (!row) continue;
    const ConditionResult& result = report.conditions[i].result;
    const auto interval = result.non_recurrence ? std::optional(result.non_recurrence->differ_interval) : std::nullopt;
    look::Row& cells = table.rows.emplace_back(row_of_condition(report, parameters, i));
    append(cells, {share_of_row(row->unresolved_at_horizon, *row), share_of_row(row->censored, *row),
                   plain_text(period_cell(row->median, row->limit)), horizon_text(row->all_but_one_per_cent),
                   difference_text(row->differ_at_horizon, result.settling->differ_interval),
                   difference_text(row->differ_in_the_end, interval), divergence_text(*result.settling)});
  }
  return table;
}

look::Table leaving_table(const Report& report) {
  const std::vector<ParameterColumn> parameters = parameter_columns(report);
  look::Table table = table_of_conditions(report, parameters);
  add_columns(table, {"response mode", "left", "watched periods", "left per 1000 periods"});
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report.conditions[i]);
    if (!row) continue;
    for (const LeftMode& found : row->leaving) {
      append(table.rows.emplace_back(row_of_condition(report, parameters, i)),
             {to_string(found.mode), look::whole(found.left), look::whole(found.watched_periods), leaving_text(found)});
    }
  }
  return table;
}

std::string remedies_html(const Report& report) {
  std::string entries;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report.conditions[i]);
    if (!row) continue;
    const std::string remedy = limit_remedy(*row, name_of_condition(report, report.conditions[i]));
    if (!remedy.empty()) entries += "<li>" + with_symbols(remedy) + ".</li>\n";
  }
  return entries.empty() ? "" : "<p>The limit is too short:</p>\n<ul>\n" + entries + "</ul>\n";
}

std::string leaving_html(const Report& report) {
  const look::Table table = leaving_table(report);
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
  return text + table_html(table, "How often settled responses were left again, with exact " + report.level() +
                                      " intervals of the rate");
}

look::Table long_run_table(const Report& report, const std::vector<ResponseMode>& modes) {
  const std::vector<ParameterColumn> parameters = parameter_columns(report);
  look::Table table = table_of_conditions(report, parameters);
  add_columns(table, {"realisations with a long run", "windows of each"});
  for (const ResponseMode& mode : modes) add_columns(table, {to_string(mode) + " [%]"});
  add_columns(table, {"others [%]"});
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report.conditions[i]);
    if (!row || !row->long_runs) continue;
    look::Row& cells = table.rows.emplace_back(row_of_condition(report, parameters, i));
    append(cells, {look::whole(row->long_runs->realisations), look::whole(row->long_runs->windows)});
    for (const ResponseMode& mode : modes) cells.emplace_back(plain_text(long_run_cell(*row, mode)));
    cells.emplace_back(plain_text(other_long_run_shares(*row, modes)));
  }
  return table;
}

std::string long_run_html(const Report& report) {
  const std::vector<SettlingRow> rows = settling_rows(report);
  const std::vector<ResponseMode> modes = long_run_modes(rows, most_long_run_modes);
  if (modes.empty()) return "";
  return fmt::format("<p>{}.</p>\n", escaped(long_run_meaning)) +
         table_html(long_run_table(report, modes),
                    "Long-run shares of time: windows of long runs by response mode, in per cent [" + report.level() +
                        " interval, each mode alone]; <: no window, an upper bound");
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
         table_html(settling_table(report),
                    "When responses settled [" + report.level() +
                        " interval; -: open]; <: did not occur, the upper end of its interval; >: beyond the "
                        "observation" +
                        count_legend(report.most_realisations())) +
         leaving_html(report) + long_run_html(report) +
         "<p class=\"small\">The charts show the interval at each time; the picture for printing and the files of "
         "<code>rocking report DIR</code> also have the band for all times at once.</p>\n";
}

}  // namespace rocking::analysis
