#include "analysis/tables.hpp"

#include <cstdint>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/data_file.hpp"
#include "analysis/run_figures.hpp"
#include "analysis/table_text.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr std::size_t most_modes = 5;

/// Empty if there is no interval.
std::string end_of(const AnyShare& share, double stats::Interval::*end) {
  return share.interval ? number_text(*share.interval.*end) : "";
}

/// The quantiles of a quantity in one unit.
std::string quantile_lines(const std::string& start, const Quantiles& quantiles,
                           const std::vector<stats::QuantileEstimate>& levels) {
  std::string text;
  for (const stats::QuantileEstimate& quantile : levels) {
    text += start + ',' + std::to_string(quantiles.realisations) + ',' + std::to_string(quantiles.beyond) + ',' +
            number_text(quantile.level) + ',' + csv_number(quantile.value) + ',' + csv_number(quantile.low) + ',' +
            csv_number(quantile.high) + '\n';
  }
  return text;
}

std::string latex_share(const AnyShare& share, std::uint64_t realisations) {
  if (share.count == 0) return share.interval ? "$<$ " + per_cent(share.interval->high) : "--";
  return per_cent(share.estimate) + (share.interval ? ' ' + per_cent(*share.interval) : "") +
         count_if_open(share.count, realisations);
}

/// `A_h 4.5 = 1.1 g, Omega_h 10 = 3.01 Hz`, with the symbols in mathematics mode.
std::string latex_shaking(std::string text) {
  const auto replace = [&text](std::string_view word, std::string_view symbol) {
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + symbol.size())) {
      text.replace(at, word.size(), symbol);
    }
  };
  replace("A_h", "$A_h$");
  replace("Omega_h", "$\\Omega_h$");
  replace("m/s^2", "m/s$^2$");
  return text;
}

/// The row after its parameters.
std::string latex_row(const ReportedCondition& condition, const std::vector<ResponseMode>& modes, bool with_others) {
  std::string text;
  text += std::to_string(condition.result.realisations);
  std::uint64_t rest = condition.result.realisations;
  for (const ResponseMode& mode : modes) {
    const AnyShare share = share_of(condition, mode);
    rest -= share.count;
    text += " & " + latex_share(share, condition.result.realisations);
  }
  if (with_others) {
    const std::uint64_t all = condition.result.realisations;
    text += " & " + (rest == 0 ? "--" : per_cent_of(rest, all) + count_if_open(rest, all));
  }
  return text + " \\\\\n";
}

using Files = std::map<std::string, std::string>;

void add_csv(Files& files, const Report& report) {
  files["modes.csv"] = modes_csv(report);
  files["non_recurrence.csv"] = non_recurrence_csv(report);
  files["quantiles.csv"] = quantiles_csv(report);
  if (!report.has_settling()) return;
  files["settling.csv"] = settling_csv(report);
  files["incidence.csv"] = incidence_csv(report);
  files["leaving.csv"] = leaving_csv(report);
  files["long_run_shares.csv"] = long_run_csv(report);
}

void add_latex(Files& files, const Report& report) {
  files["modes.tex"] = modes_latex(report);
  if (report.has_settling()) files["settling.tex"] = settling_latex(report);
  files["long_run_shares.tex"] = long_run_latex(report);
}

}  // namespace

std::string modes_csv(const Report& report) {
  const CsvStart start(report);
  std::string text = start.head() + ",mode,count,estimate,low,high\n";
  const std::set<ResponseMode> listed = report.listed();
  for (const ReportedCondition& condition : report.conditions) {
    for (const ResponseMode& mode : listed) {
      const AnyShare share = share_of(condition, mode);
      text += start.of(condition) + ',' + csv_field(to_string(mode)) + ',' + std::to_string(share.count) + ',' +
              number_text(share.estimate) + ',' + end_of(share, &stats::Interval::low) + ',' +
              end_of(share, &stats::Interval::high) + '\n';
    }
  }
  return text;
}

std::string non_recurrence_csv(const Report& report) {
  const CsvStart start(report);
  std::string text =
      start.head() + ",differ,low,high,entropy_nat,pairs,diverged,lower_quartile,median,upper_quartile\n";
  for (const ReportedCondition& condition : report.conditions) {
    text += start.of(condition);
    if (!condition.result.non_recurrence) {
      text += ",,,,,,,,,\n";
      continue;
    }
    const NonRecurrence& found = *condition.result.non_recurrence;
    for (const double value : {found.differ, found.differ_interval.low, found.differ_interval.high, found.entropy}) {
      text += ',' + number_text(value);
    }
    const DivergenceTimes& divergence = found.friction;
    text += ',' + std::to_string(divergence.pairs) + ',' + std::to_string(divergence.diverged);
    for (const auto& value : {divergence.lower_quartile, divergence.median, divergence.upper_quartile}) {
      text += ',' + csv_number(value);
    }
    text += '\n';
  }
  return text;
}

std::string quantiles_csv(const Report& report) {
  const CsvStart start(report);
  std::string text = start.head() + ",quantity,unit,of,beyond,level,value,low,high\n";
  for (const ReportedCondition& condition : report.conditions) {
    const std::string first = start.of(condition);
    const PeakQuantiles& peaks = condition.result.peaks;
    for (const auto& [key, slip] :
         {std::pair(",final_slip", &peaks.final_slip), std::pair(",peak_slip", &peaks.slip)}) {
      if (!*slip) continue;
      const Quantiles& quantiles = (*slip)->over_half_diagonal;
      text += quantile_lines(first + key + ",R", quantiles, quantiles.levels);
      text += quantile_lines(first + key + ",m", quantiles, (*slip)->metres);
    }
    text += quantile_lines(first + ",peak_tilt,1", peaks.tilt, peaks.tilt.levels);
    text += quantile_lines(first + ",peak_tilt_rate,1", peaks.tilt_rate, peaks.tilt_rate.levels);
  }
  return text;
}

std::string modes_latex(const Report& report) {
  const std::vector<ResponseMode> modes = modes_to_show(report.occurring(), most_modes);
  const bool with_others = report.occurring().size() > modes.size();
  const std::vector<ParameterColumn> columns = parameter_columns(report);
  const std::string common = common_shaking(report.swept, shakings_of(report));
  const std::string proviso = end_proviso(settling_rows(report));
  const std::size_t leading = columns.size() + 1;
  std::string text = "% Needs \\usepackage{booktabs}; of a long table, longtable.\n\\begin{table}\n  \\centering\n";
  text += "  \\caption{" + latex_text(report.title()) + (report.title().empty() ? "" : " ") +
          (report.is_random() ? std::string("Response modes") + (report.has_settling() ? " in the end" : "") +
                                    " in per cent of $n$ realisations, with " + latex_text(report.level()) +
                                    " simultaneous intervals for all modes of a condition; $<$: did not occur, upper "
                                    "end of the interval" +
                                    count_legend(report.most_realisations()) + '.' +
                                    (proviso.empty() ? "" : " In the end " + latex_text(proviso) + '.')
                              : "Response modes in per cent; nothing is random.") +
          (common.empty() ? "" : " Shaking: " + latex_shaking(common) + '.') + "}\n";
  text += "  \\begin{tabular}{" + std::string(leading + modes.size() + (with_others ? 1 : 0), 'r') +
          "}\n    \\toprule\n    ";
  for (const ParameterColumn& column : columns) text += latex_symbol(column.pointer) + " & ";
  text += "$n$";
  for (const ResponseMode& mode : modes) text += " & " + to_string(mode);
  text += std::string(with_others ? " & others" : "") + " \\\\\n    \\midrule\n";
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    text += "    ";
    for (const ParameterColumn& column : columns) text += latex_text(column.values[i]) + " & ";
    text += latex_row(report.conditions[i], modes, with_others);
  }
  return text + "    \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

std::map<std::string, std::string> table_files(const Report& report, const std::set<std::string>& formats) {
  Files files;
  if (formats.contains("csv")) add_csv(files, report);
  if (formats.contains("latex")) add_latex(files, report);
  std::erase_if(files, [](const auto& file) { return file.second.empty(); });
  return files;
}

}  // namespace rocking::analysis
