#include "analysis/tables.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "analysis/data_file.hpp"
#include "analysis/mode_figures.hpp"
#include "analysis/sweep_view.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr std::size_t most_modes = 5;

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

std::string csv_number(const std::optional<double>& number) { return number ? number_text(*number) : ""; }

/// Empty if there is no interval.
std::string end_of(const AnyShare& share, double stats::Interval::*end) {
  return share.interval ? number_text(*share.interval.*end) : "";
}

std::string csv_head(const RunReport& report) {
  std::string text;
  for (const std::string& pointer : report.swept) text += csv_field(pointer) + ',';
  return text + 'n';
}

/// The parameters and n of a condition.
std::string csv_start(const ConditionReport& condition) {
  std::string text;
  for (const Json& value : condition.parameters) {
    text += csv_field(value.is_string() ? value.get<std::string>() : value.dump()) + ',';
  }
  return text + std::to_string(condition.realisations);
}

/// The quantiles of a quantity in one unit.
std::string quantile_lines(const std::string& start, const QuantileReport& quantiles,
                           const std::vector<stats::QuantileEstimate>& levels) {
  std::string text;
  for (const stats::QuantileEstimate& quantile : levels) {
    text += start + ',' + std::to_string(quantiles.realisations) + ',' + std::to_string(quantiles.beyond) + ',' +
            number_text(quantile.level) + ',' + csv_number(quantile.value) + ',' + csv_number(quantile.low) + ',' +
            csv_number(quantile.high) + '\n';
  }
  return text;
}

/// Text for LaTeX; a symbol with a subscript is set in mathematics mode.
std::string latex_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\': result += "\\textbackslash{}"; break;
      case '~': result += "\\textasciitilde{}"; break;
      case '^': result += "\\textasciicircum{}"; break;
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}': result += std::string("\\") + c; break;
      default: result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return result;
}

std::string latex_symbol(const std::string& pointer) {
  static const std::map<std::string, std::string> symbols{
      {"/excitation/amplitude", "$A_h$"}, {"/excitation/frequency_ratio", "$\\Omega_h$"},
      {"/friction", "$\\mu_s/\\mu_k$"},   {"/friction/static", "$\\mu_s$"},
      {"/friction/kinetic", "$\\mu_k$"},  {"/restitution", "$e$"}};
  const auto found = symbols.find(pointer);
  return found == symbols.end() ? latex_text(axis_of_parameter(pointer).quantity) : found->second;
}

std::string latex_share(const AnyShare& share) {
  if (share.count == 0) return share.interval ? "$<$ " + upper_bound_text(share.interval->high) : "--";
  return per_cent(share.estimate) + (share.interval ? ' ' + per_cent(*share.interval) : "");
}

std::string latex_row(const RunReport& report, const ConditionReport& condition, const std::vector<ResponseMode>& modes,
                      bool with_others) {
  std::string text;
  for (std::size_t i = 0; i < condition.parameters.size(); ++i) {
    text += latex_text(short_value(report.swept[i], condition.parameters[i])) + " & ";
  }
  text += std::to_string(condition.realisations);
  std::uint64_t rest = condition.realisations;
  for (const ResponseMode& mode : modes) {
    const AnyShare share = share_of(condition, mode);
    rest -= share.count;
    text += " & " + latex_share(share);
  }
  if (with_others) {
    const double share = static_cast<double>(rest) / static_cast<double>(condition.realisations);
    text += " & " + (rest == 0 ? "--" : per_cent(share));
  }
  return text + " \\\\\n";
}

}  // namespace

std::string modes_csv(const RunReport& report) {
  std::string text = csv_head(report) + ",mode,count,estimate,low,high\n";
  const std::set<ResponseMode> listed = report.listed();
  for (const ConditionReport& condition : report.conditions) {
    for (const ResponseMode& mode : listed) {
      const AnyShare share = share_of(condition, mode);
      text += csv_start(condition) + ',' + csv_field(to_string(mode)) + ',' + std::to_string(share.count) + ',' +
              number_text(share.estimate) + ',' + end_of(share, &stats::Interval::low) + ',' +
              end_of(share, &stats::Interval::high) + '\n';
    }
  }
  return text;
}

std::string non_recurrence_csv(const RunReport& report) {
  std::string text =
      csv_head(report) + ",differ,low,high,entropy_nat,pairs,parted,lower_quartile,median,upper_quartile\n";
  for (const ConditionReport& condition : report.conditions) {
    text += csv_start(condition);
    if (!condition.difference) {
      text += ",,,,,,,,,\n";
      continue;
    }
    const Difference& found = *condition.difference;
    for (const double value : {found.differ, found.interval.low, found.interval.high, found.entropy}) {
      text += ',' + number_text(value);
    }
    const Divergence& divergence = found.by_friction;
    text += ',' + std::to_string(divergence.pairs) + ',' + std::to_string(divergence.diverged);
    for (const auto& value : {divergence.lower_quartile, divergence.median, divergence.upper_quartile}) {
      text += ',' + csv_number(value);
    }
    text += '\n';
  }
  return text;
}

std::string quantiles_csv(const RunReport& report) {
  std::string text = csv_head(report) + ",quantity,unit,of,beyond,level,value,low,high\n";
  for (const ConditionReport& condition : report.conditions) {
    for (const auto& [key, quantiles] : condition.quantiles) {
      const std::string start = csv_start(condition) + ',' + key;
      text += quantile_lines(start + (quantiles.levels_m.empty() ? ",1" : ",R"), quantiles, quantiles.levels);
      text += quantile_lines(start + ",m", quantiles, quantiles.levels_m);
    }
  }
  return text;
}

std::string modes_latex(const RunReport& report) {
  const std::vector<ResponseMode> modes = modes_to_show(report.occurring(), most_modes);
  const bool with_others = report.occurring().size() > modes.size();
  const std::size_t leading = report.swept.size() + 1;
  std::string text = "% Needs \\usepackage{booktabs}; of a long table, longtable.\n\\begin{table}\n  \\centering\n";
  text += "  \\caption{" + latex_text(report.title) + (report.title.empty() ? "" : " ") +
          (report.is_random() ? "Response modes in per cent of $n$ realisations, with " + latex_text(report.level()) +
                                    " simultaneous intervals for all modes of a condition; $<$: did not occur, upper "
                                    "end of the interval.}\n"
                              : "Response modes in per cent; nothing is random.}\n");
  text += "  \\begin{tabular}{" + std::string(leading + modes.size() + (with_others ? 1 : 0), 'r') +
          "}\n    \\toprule\n    ";
  for (const std::string& pointer : report.swept) text += latex_symbol(pointer) + " & ";
  text += "$n$";
  for (const ResponseMode& mode : modes) text += " & " + to_string(mode);
  text += std::string(with_others ? " & others" : "") + " \\\\\n    \\midrule\n";
  for (const ConditionReport& condition : report.conditions) {
    text += "    " + latex_row(report, condition, modes, with_others);
  }
  return text + "    \\bottomrule\n  \\end{tabular}\n\\end{table}\n";
}

}  // namespace rocking::analysis
