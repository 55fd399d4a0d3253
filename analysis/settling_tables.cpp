#include "analysis/tables.hpp"

#include <vector>

#include "analysis/data_file.hpp"
#include "analysis/table_text.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/long_run_table.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

std::string csv_whole(const std::optional<std::int64_t>& number) { return number ? std::to_string(*number) : ""; }

std::string csv_interval(const std::optional<stats::Interval>& interval) {
  return interval ? ',' + number_text(interval->low) + ',' + number_text(interval->high) : ",,";
}

std::string curve_lines(const std::string& start, const std::vector<stats::Incidence>& curve) {
  std::string text;
  for (const stats::Incidence& point : curve) {
    text += start + ',' + std::to_string(point.time) + ',' + number_text(point.estimate) +
            csv_interval(point.pointwise) + csv_interval(point.simultaneous) + '\n';
  }
  return text;
}

std::string latex_count(std::uint64_t count, const SettlingRow& row) {
  if (count > 0) return per_cent_of(count, row.realisations) + count_if_open(count, row.realisations);
  return "$<$ " + per_cent(bound_of_none(row.realisations, row.confidence));
}

std::string latex_probability(const std::optional<double>& probability) {
  return probability ? per_cent(*probability) : "--";
}

constexpr std::size_t most_long_run_columns = 5;

std::string latex_long_run(std::string text) {
  if (text.starts_with('<')) text.replace(0, 1, "$<$");
  return text == "." ? "--" : text;
}

/// `$>$ 1000 [740, --]`
std::string latex_period(std::string text) {
  if (text.starts_with('>')) text.replace(0, 1, "$>$");
  for (auto at = text.find(", -]"); at != std::string::npos; at = text.find(", -]")) text.replace(at, 4, ", --]");
  return text;
}

}  // namespace

std::string settling_csv(const Report& report) {
  if (!report.has_settling()) return "";
  const CsvStart start(report);
  std::string text =
      start.head() +
      ",unresolved_at_horizon,not_classified,lower_quartile,lower_quartile_low,lower_quartile_high,median,median_low,"
      "median_high,upper_quartile,upper_quartile_low,upper_quartile_high,99_percent,99_percent_low,99_percent_high,"
      "99_percent_basis,differ_at_horizon,differ_at_horizon_low,differ_at_horizon_high,differ,differ_low,differ_high\n";
  for (const ReportedCondition& condition : report.conditions) {
    const auto row = settling_row(report, condition);
    if (!row) continue;
    const SettlingResult& settling = *condition.result.settling;
    text +=
        start.of(condition) + ',' + std::to_string(row->unresolved_at_horizon) + ',' + std::to_string(row->censored);
    for (const stats::QuantileEstimate& quartile : settling.times.quartiles) {
      text += ',' + csv_number(quartile.value) + ',' + csv_number(quartile.low) + ',' + csv_number(quartile.high);
    }
    const stats::TimeToShare& found = row->all_but_one_per_cent;
    text += ',' + csv_whole(found.time) + ',' + csv_whole(found.low) + ',' + csv_whole(found.high) +
            (found.is_observed ? ",observed"
             : found.time      ? ",extrapolated"
                               : ",unknown");
    const auto& difference = condition.result.non_recurrence;
    text += ',' + csv_number(row->differ_at_horizon) + csv_interval(settling.differ_interval) + ',' +
            csv_number(row->differ_in_the_end) +
            csv_interval(difference ? std::optional(difference->differ_interval) : std::nullopt) + '\n';
  }
  return text;
}

std::string incidence_csv(const Report& report) {
  if (!report.has_settling()) return "";
  const CsvStart start(report);
  std::string text = start.head() + ",mode,period,estimate,low,high,band_low,band_high\n";
  for (const ReportedCondition& condition : report.conditions) {
    if (!condition.result.settling) continue;
    const std::string first = start.of(condition);
    for (const auto& [mode, curve] : condition.result.settling->incidence) {
      text += curve_lines(first + ',' + csv_field(to_string(mode)), curve);
    }
    text += curve_lines(first + ",any", condition.result.settling->times.any_mode);
    text += curve_lines(first + ",diverged", condition.result.settling->divergence);
  }
  return text;
}

std::string leaving_csv(const Report& report) {
  if (!report.has_settling()) return "";
  const CsvStart start(report);
  std::string text = start.head() + ",mode,left,watched_periods,per_1000_periods,low,high\n";
  for (const ReportedCondition& condition : report.conditions) {
    const auto row = settling_row(report, condition);
    if (!row) continue;
    for (const LeftMode& found : row->leaving) {
      text += start.of(condition) + ',' + csv_field(to_string(found.mode)) + ',' + std::to_string(found.left) + ',' +
              std::to_string(found.watched_periods) + ',' +
              number_text(1000.0 * static_cast<double>(found.left) / static_cast<double>(found.watched_periods)) +
              csv_interval(found.per_1000_periods) + '\n';
    }
  }
  return text;
}

std::string settling_latex(const Report& report) {
  if (!report.has_settling()) return "";
  const std::vector<ParameterColumn> columns = parameter_columns(report);
  const std::string proviso = end_proviso(settling_rows(report));
  std::string text = "% Needs \\usepackage{booktabs}; of a long table, longtable.\n\\begin{table}\n  \\centering\n";
  text +=
      "  \\caption{" + latex_text(report.title()) + (report.title().empty() ? "" : " ") +
      "Realisations in per cent that are unresolved at the fixed horizon and in the end, median settling period "
      "with its " +
      latex_text(report.level()) +
      " interval (--: open), and probability in per cent that two runs differ in response mode at the fixed horizon "
      "and in the end; $<$: did not occur, upper end of the interval" +
      count_legend(report.most_realisations()) + '.' +
      (proviso.empty() ? "" : " In the end " + latex_text(proviso) + '.') + "}\n";
  text += "  \\begin{tabular}{" + std::string(columns.size() + 6, 'r') + "}\n    \\toprule\n    ";
  for (const ParameterColumn& column : columns) text += latex_symbol(column.pointer) + " & ";
  text += "$n$ & unresolved & in the end & settled by & differ & in the end \\\\\n    \\midrule\n";
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report, report.conditions[i]);
    if (!row) continue;
    text += "    ";
    for (const ParameterColumn& column : columns) text += latex_text(column.values[i]) + " & ";
    text += std::to_string(row->realisations) + " & " + latex_count(row->unresolved_at_horizon, *row) + " & " +
            latex_count(row->censored, *row) + " & " + latex_period(period_text(row->median, row->limit)) + " & " +
            latex_probability(row->differ_at_horizon) + " & " + latex_probability(row->differ_in_the_end) + " \\\\\n";
  }
  return text + "    \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

std::string long_run_csv(const Report& report) {
  const CsvStart start(report);
  std::string lines;
  for (const ReportedCondition& condition : report.conditions) {
    const auto row = settling_row(report, condition);
    if (!row || !row->long_runs) continue;
    const LongRunRow& runs = *row->long_runs;
    for (const LongRunShare& found : runs.shares) {
      lines += start.of(condition) + ',' + csv_field(to_string(found.mode)) + ',' + std::to_string(runs.realisations) +
               ',' + std::to_string(runs.windows) + ',' + number_text(found.share) + csv_interval(found.interval) +
               '\n';
    }
  }
  return lines.empty() ? "" : start.head() + ",mode,long_runs,windows,share,low,high\n" + lines;
}

std::string long_run_latex(const Report& report) {
  const auto modes = long_run_modes(settling_rows(report), most_long_run_columns);
  if (modes.empty()) return "";
  const std::vector<ParameterColumn> columns = parameter_columns(report);
  std::string text = "% Needs \\usepackage{booktabs}; of a long table, longtable.\n\\begin{table}\n  \\centering\n";
  text += "  \\caption{" + latex_text(report.title()) + (report.title().empty() ? "" : " ") +
          "Long-run shares of time: windows of realisations with a long run by response mode, in per cent, with " +
          latex_text(report.level()) + " intervals of each mode alone; $<$: no window, upper bound. " +
          long_run_meaning + ".}\n";
  text += "  \\begin{tabular}{" + std::string(columns.size() + modes.size() + 2, 'r') + "}\n    \\toprule\n    ";
  for (const ParameterColumn& column : columns) text += latex_symbol(column.pointer) + " & ";
  text += "long runs";
  for (const section::ResponseMode& mode : modes) text += " & " + to_string(mode);
  text += " & others \\\\\n    \\midrule\n";
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto row = settling_row(report, report.conditions[i]);
    if (!row || !row->long_runs) continue;
    text += "    ";
    for (const ParameterColumn& column : columns) text += latex_text(column.values[i]) + " & ";
    text += std::to_string(row->long_runs->realisations);
    for (const section::ResponseMode& mode : modes) text += " & " + latex_long_run(long_run_cell(*row, mode));
    text += " & " + latex_long_run(other_long_run_shares(*row, modes)) + " \\\\\n";
  }
  return text + "    \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

}  // namespace rocking::analysis
