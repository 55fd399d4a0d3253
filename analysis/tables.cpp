#include "analysis/tables.hpp"

#include <cstdint>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/run_figures.hpp"
#include "analysis/table_text.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/look/markup.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr std::size_t most_modes = 5;

/// A quantity in one unit.
struct QuantileRows {
  const char* key;
  const char* unit;
  const Quantiles& quantiles;
  const std::vector<stats::QuantileEstimate>& levels;
};

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
  look::Table table = start.table({{"mode"}, {"count"}, {.title = "estimate", .has_interval = true}});
  const std::set<ResponseMode> listed = report.listed();
  for (const ReportedCondition& condition : report.conditions) {
    for (const ResponseMode& mode : listed) {
      const AnyShare share = share_of(condition, mode);
      table.rows.push_back(
          start.row(condition, {to_string(mode), look::whole(share.count), exact(share.estimate, share.interval)}));
    }
  }
  return to_csv(table);
}

std::string non_recurrence_csv(const Report& report) {
  const CsvStart start(report);
  look::Table table = start.table({{.title = "differ", .has_interval = true},
                                   {"entropy_nat"},
                                   {"pairs"},
                                   {"diverged"},
                                   {"lower_quartile"},
                                   {"median"},
                                   {"upper_quartile"}});
  for (const ReportedCondition& condition : report.conditions) {
    look::Row row(7);
    if (condition.result.non_recurrence) {
      const NonRecurrence& found = *condition.result.non_recurrence;
      const DivergenceTimes& times = found.friction;
      row = {exact(found.differ, found.differ_interval),
             exact(found.entropy),
             look::whole(times.pairs),
             look::whole(times.diverged),
             exact(times.lower_quartile),
             exact(times.median),
             exact(times.upper_quartile)};
    }
    table.rows.push_back(start.row(condition, row));
  }
  return to_csv(table);
}

std::string quantiles_csv(const Report& report) {
  const CsvStart start(report);
  look::Table table =
      start.table({{"quantity"}, {"unit"}, {"of"}, {"beyond"}, {"level"}, {.title = "value", .has_interval = true}});
  for (const ReportedCondition& condition : report.conditions) {
    const PeakQuantiles& peaks = condition.result.peaks;
    std::vector<QuantileRows> quantities;
    for (const auto& [key, slip] : {std::pair("final_slip", &peaks.final_slip), std::pair("peak_slip", &peaks.slip)}) {
      if (!*slip) continue;
      const Quantiles& quantiles = (*slip)->over_half_diagonal;
      quantities.push_back({key, "R", quantiles, quantiles.levels});
      quantities.push_back({key, "m", quantiles, (*slip)->metres});
    }
    quantities.push_back({"peak_tilt", "1", peaks.tilt, peaks.tilt.levels});
    quantities.push_back({"peak_tilt_rate", "1", peaks.tilt_rate, peaks.tilt_rate.levels});
    for (const auto& [key, unit, quantiles, levels] : quantities) {
      for (const stats::QuantileEstimate& found : levels) {
        table.rows.push_back(
            start.row(condition, {key, unit, look::whole(quantiles.realisations), look::whole(quantiles.beyond),
                                  exact(found.level), exact(found.value, look::Ends(found.low, found.high))}));
      }
    }
  }
  return to_csv(table);
}

std::string modes_latex(const Report& report) {
  const std::vector<ResponseMode> modes = modes_to_show(report.occurring(), most_modes);
  const bool with_others = report.occurring().size() > modes.size();
  const std::vector<ParameterColumn> parameters = parameter_columns(report);
  look::Table table = table_of(parameters, {"n"});
  table.columns.back().latex = "$n$";
  for (const ResponseMode& mode : modes) add_columns(table, {to_string(mode)});
  if (with_others) add_columns(table, {"others"});
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const std::uint64_t all = report.conditions[i].result.realisations;
    look::Row& row = table.rows.emplace_back(row_of(parameters, i, {look::whole(all)}));
    std::uint64_t rest = all;
    for (const ResponseMode& mode : modes) {
      const AnyShare share = share_of(report.conditions[i], mode);
      rest -= share.count;
      row.push_back(share_cell(share, all));
    }
    if (with_others) row.push_back(part_cell(rest, all));
  }
  const std::string common = common_shaking(report.swept, shakings_of(report));
  const std::string proviso = end_proviso(settling_rows(report));
  const std::string meaning =
      report.is_random()
          ? std::string("Response modes") + (report.has_settling() ? " in the end" : "") +
                " in per cent of $n$ realisations, with " + look::latex_text(report.level()) +
                " simultaneous intervals for all modes of a condition; $<$: did not occur, upper end of the interval" +
                count_legend(report.most_realisations()) + '.' +
                (proviso.empty() ? "" : " In the end " + look::latex_text(proviso) + '.')
          : "Response modes in per cent; nothing is random.";
  return latex_of(table, report, meaning + (common.empty() ? "" : " Shaking: " + latex_shaking(common) + '.'));
}

std::map<std::string, std::string> table_files(const Report& report, const std::set<std::string>& formats) {
  Files files;
  if (formats.contains("csv")) add_csv(files, report);
  if (formats.contains("latex")) add_latex(files, report);
  std::erase_if(files, [](const auto& file) { return file.second.empty(); });
  return files;
}

}  // namespace rocking::analysis
