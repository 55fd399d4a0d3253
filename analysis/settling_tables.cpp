#include "analysis/tables.hpp"

#include <vector>

#include "analysis/table_text.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/look/markup.hpp"
#include "rocking/output/long_run_table.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

std::optional<double> real(const std::optional<std::int64_t>& number) {
  return number ? std::optional(static_cast<double>(*number)) : std::nullopt;
}

look::Cell count_cell(std::uint64_t count, const SettlingRow& row) {
  return count > 0 ? part_cell(count, row.realisations) : bound_cell(bound_of_none(row.realisations, row.confidence));
}

constexpr std::size_t most_long_run_columns = 5;

}  // namespace

std::string settling_csv(const Report& report) {
  if (!report.has_settling()) return "";
  const CsvStart start(report);
  look::Table table = start.table({{"unresolved_at_horizon"}, {"not_classified"}});
  for (const char* title : {"lower_quartile", "median", "upper_quartile", "99_percent"}) {
    table.columns.push_back({.title = title, .has_interval = true});
  }
  add_columns(table, {"99_percent_basis"});
  for (const char* title : {"differ_at_horizon", "differ"}) {
    table.columns.push_back({.title = title, .has_interval = true});
  }
  for (const ReportedCondition& condition : report.conditions) {
    const auto row = settling_row(condition);
    if (!row) continue;
    const SettlingResult& settling = *condition.result.settling;
    look::Row cells{look::whole(row->unresolved_at_horizon), look::whole(row->censored)};
    for (const stats::QuantileEstimate& quartile : settling.times.quartiles) {
      cells.push_back(exact(quartile.value, look::Ends(quartile.low, quartile.high)));
    }
    const stats::TimeToShare& found = row->all_but_one_per_cent;
    const auto& difference = condition.result.non_recurrence;
    append(cells,
           {look::Number{.value = real(found.time),
                         .form = look::decimals(0),
                         .interval = look::Ends(real(found.low), real(found.high))},
            found.is_observed ? "observed"
            : found.time      ? "extrapolated"
                              : "unknown",
            exact(row->differ_at_horizon, settling.differ_interval),
            exact(row->differ_in_the_end, difference ? std::optional(difference->differ_interval) : std::nullopt)});
    table.rows.push_back(start.row(condition, cells));
  }
  return to_csv(table);
}

std::string incidence_csv(const Report& report) {
  if (!report.has_settling()) return "";
  const CsvStart start(report);
  const look::Table table =
      start.table({{"mode"}, {"period"}, {.title = "estimate", .has_interval = true}, {"band_low"}, {"band_high"}});
  std::string text = to_csv(table);
  for (const ReportedCondition& condition : report.conditions) {
    if (!condition.result.settling) continue;
    const auto add = [&](const std::string& name, const std::vector<stats::Incidence>& curve) {
      for (const stats::Incidence& point : curve) {
        text += csv_line(table.columns,
                         start.row(condition, {name, std::to_string(point.time), exact(point.estimate, point.pointwise),
                                               exact(point.simultaneous.low), exact(point.simultaneous.high)}));
      }
    };
    for (const auto& [mode, curve] : condition.result.settling->incidence) add(to_string(mode), curve);
    add("any", condition.result.settling->times.any_mode);
    add("diverged", condition.result.settling->divergence);
  }
  return text;
}

std::string leaving_csv(const Report& report) {
  if (!report.has_settling()) return "";
  const CsvStart start(report);
  look::Table table =
      start.table({{"mode"}, {"left"}, {"watched_periods"}, {.title = "per_1000_periods", .has_interval = true}});
  for (const ReportedCondition& condition : report.conditions) {
    const auto row = settling_row(condition);
    if (!row) continue;
    for (const LeftMode& found : row->leaving) {
      const double rate = 1000.0 * static_cast<double>(found.left) / static_cast<double>(found.watched_periods);
      table.rows.push_back(
          start.row(condition, {to_string(found.mode), look::whole(found.left), look::whole(found.watched_periods),
                                exact(rate, found.per_1000_periods)}));
    }
  }
  return to_csv(table);
}

std::string settling_latex(const Report& report) {
  if (!report.has_settling()) return "";
  const std::vector<ParameterColumn> parameters = parameter_columns(report);
  look::Table table = table_of(parameters, {"n", "unresolved", "in the end", "settled by", "differ", "in the end"});
  table.columns[parameters.size()].latex = "$n$";
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report.conditions[i]);
    if (!row) continue;
    table.rows.push_back(row_of(
        parameters, i,
        {look::whole(row->realisations), count_cell(row->unresolved_at_horizon, *row), count_cell(row->censored, *row),
         period_cell(row->median, row->limit), look::number(row->differ_at_horizon, look::percentage()),
         look::number(row->differ_in_the_end, look::percentage())}));
  }
  const std::string proviso = end_proviso(settling_rows(report));
  return latex_of(
      table, report,
      "Realisations in per cent that are unresolved at the fixed horizon and in the end, median settling period with "
      "its " +
          look::latex_text(report.level()) +
          " interval (--: open), and probability in per cent that two runs differ in response mode at the fixed "
          "horizon "
          "and in the end; $<$: did not occur, upper end of the interval" +
          count_legend(report.most_realisations()) + '.' +
          (proviso.empty() ? "" : " In the end " + look::latex_text(proviso) + '.'));
}

std::string long_run_csv(const Report& report) {
  const CsvStart start(report);
  look::Table table = start.table({{"mode"}, {"long_runs"}, {"windows"}, {.title = "share", .has_interval = true}});
  for (const ReportedCondition& condition : report.conditions) {
    const auto row = settling_row(condition);
    if (!row || !row->long_runs) continue;
    const LongRunRow& runs = *row->long_runs;
    for (const LongRunShare& found : runs.shares) {
      table.rows.push_back(start.row(condition, {to_string(found.mode), look::whole(runs.realisations),
                                                 look::whole(runs.windows), exact(found.share, found.interval)}));
    }
  }
  return table.rows.empty() ? "" : to_csv(table);
}

std::string long_run_latex(const Report& report) {
  const auto modes = long_run_modes(settling_rows(report), most_long_run_columns);
  if (modes.empty()) return "";
  const std::vector<ParameterColumn> parameters = parameter_columns(report);
  look::Table table = table_of(parameters, {"long runs"});
  for (const section::ResponseMode& mode : modes) add_columns(table, {to_string(mode)});
  add_columns(table, {"others"});
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report.conditions[i]);
    if (!row || !row->long_runs) continue;
    look::Row& cells = table.rows.emplace_back(row_of(parameters, i, {look::whole(row->long_runs->realisations)}));
    for (const section::ResponseMode& mode : modes) cells.push_back(long_run_cell(*row, mode));
    cells.push_back(other_long_run_shares(*row, modes));
  }
  return latex_of(
      table, report,
      "Long-run shares of time: windows of realisations with a long run by response mode, in per cent, with " +
          look::latex_text(report.level()) + " intervals of each mode alone; $<$: no window, upper bound. " +
          long_run_meaning + ".");
}

}  // namespace rocking::analysis
