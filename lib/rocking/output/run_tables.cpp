#include "rocking/output/run_tables.hpp"

#include <limits>
#include <string_view>
#include <utility>

#include "rocking/look/markup.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::Media;
using section::ResponseMode;

constexpr std::size_t most_modes_in_latex = 5;

/// A number for CSV.
look::Cell exact(const std::optional<double>& number, const std::optional<look::Ends>& interval = std::nullopt) {
  return look::Number{.value = number, .form = 17, .interval = interval};
}

RunTable csv_table(std::string name, const ConditionTable& table) {
  return {.name = std::move(name), .caption = "", .table = table.table(), .media = Media::csv};
}

RunTable share_table(const Report& report) {
  ConditionTable table(report, {{"mode"}, {"count"}, {.title = "estimate", .has_interval = true}});
  for (const ReportedCondition& condition : report.conditions) {
    for (const ResponseMode& mode : report.listed()) {
      const AnyShare share = share_of(condition, mode);
      table.add(condition, {to_string(mode), look::whole(share.count), exact(share.estimate, share.interval)});
    }
  }
  return csv_table("modes", table);
}

RunTable non_recurrence_table(const Report& report) {
  ConditionTable table(report, {{.title = "differ", .has_interval = true},
                                {"entropy_nat"},
                                {"pairs"},
                                {"diverged"},
                                {"lower_quartile"},
                                {"median"},
                                {"upper_quartile"}});
  for (const ReportedCondition& condition : report.conditions) {
    look::Row row(7);
    if (const auto& found = condition.result.non_recurrence) {
      const DivergenceTimes& times = found->friction;
      row = {exact(found->differ, found->differ_interval),
             exact(found->entropy),
             look::whole(times.pairs),
             look::whole(times.diverged),
             exact(times.lower_quartile),
             exact(times.median),
             exact(times.upper_quartile)};
    }
    table.add(condition, row);
  }
  return csv_table("non_recurrence", table);
}

RunTable quantile_table(const Report& report) {
  ConditionTable table(
      report, {{"quantity"}, {"unit"}, {"of"}, {"beyond"}, {"level"}, {.title = "value", .has_interval = true}});
  for (const ReportedCondition& condition : report.conditions) {
    const PeakQuantiles& peaks = condition.result.peaks;
    const auto add = [&](const char* key, const char* unit, const Quantiles& of,
                         const std::vector<stats::QuantileEstimate>& levels) {
      for (const stats::QuantileEstimate& found : levels) {
        table.add(condition, {key, unit, look::whole(of.realisations), look::whole(of.beyond), exact(found.level),
                              exact(found.value, look::Ends(found.low, found.high))});
      }
    };
    for (const auto& [key, slip] : {std::pair("final_slip", &peaks.final_slip), std::pair("peak_slip", &peaks.slip)}) {
      if (!*slip) continue;
      add(key, "R", (*slip)->over_half_diagonal, (*slip)->over_half_diagonal.levels);
      add(key, "m", (*slip)->over_half_diagonal, (*slip)->metres);
    }
    add("peak_tilt", "1", peaks.tilt, peaks.tilt.levels);
    add("peak_tilt_rate", "1", peaks.tilt_rate, peaks.tilt_rate.levels);
  }
  return csv_table("quantiles", table);
}

/// Too long for a table.
std::string incidence_csv(const Report& report) {
  if (!report.has_settling()) return "";
  const ConditionTable start(
      report, {{"mode"}, {"period"}, {.title = "estimate", .has_interval = true}, {"band_low"}, {"band_high"}});
  std::string text = to_csv(start.table());
  for (const ReportedCondition& condition : report.conditions) {
    if (!condition.result.settling) continue;
    const SettlingResult& settling = *condition.result.settling;
    const auto add = [&](const std::string& name, const std::vector<stats::Incidence>& curve) {
      for (const stats::Incidence& point : curve) {
        text += csv_line(start.table().columns,
                         start.row(condition, {name, std::to_string(point.time), exact(point.estimate, point.pointwise),
                                               exact(point.simultaneous.low), exact(point.simultaneous.high)}));
      }
    };
    for (const auto& [mode, curve] : settling.incidence) add(to_string(mode), curve);
    add("any", settling.times.any_mode);
    add("diverged", settling.divergence);
  }
  return text;
}

/// `A_h 4.5 = 1.1 g, Omega_h 10 = 3.01 Hz`, with the symbols in mathematics mode.
std::string latex_shaking(std::string text) {
  for (const auto& [word, symbol] : {std::pair<std::string_view, std::string_view>("A_h", "$A_h$"),
                                     {"Omega_h", "$\\Omega_h$"},
                                     {"m/s^2", "m/s$^2$"}}) {
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + symbol.size())) {
      text.replace(at, word.size(), symbol);
    }
  }
  return text;
}

std::string latex_of(const RunTable& table, const Report& report) {
  const std::string common = common_shaking(report.swept, shakings_of(report));
  return to_latex(
      table.table,
      look::latex_caption(report.title(), look::latex_text(table.caption) + '.' +
                                              (common.empty() ? "" : " Shaking: " + latex_shaking(common) + '.')));
}

}  // namespace

RunTable response_table(const Report& report, Media medium) {
  const bool is_random = report.is_random();
  const std::size_t most = medium == Media::latex ? most_modes_in_latex : std::numeric_limits<std::size_t>::max();
  ConditionColumns columns =
      condition_columns(report, Media::publications, is_random ? Media::publications : Media::csv);
  for (ConditionColumn& column : mode_columns(report, most)) columns.push_back(std::move(column));
  const std::string proviso = end_proviso(report);
  return {.name = "modes",
          .caption = !is_random ? "Response of each condition. Nothing is random: one realisation is the response"
                                : std::string("Response modes") + (report.has_settling() ? " in the end" : "") +
                                      " in per cent of the n realisations [" + report.level() +
                                      " interval, simultaneous for all modes of a condition]; < x: did not occur, x is "
                                      "the upper end of its interval" +
                                      count_legend(report.most_realisations()) +
                                      (proviso.empty() ? "" : ". In the end " + proviso),
          .table = table_of(report, columns),
          .media = medium};
}

std::vector<RunTable> tables_of(const Report& report) {
  std::vector<RunTable> tables{response_table(report, Media::latex),
                               response_table(report, Media::page),
                               share_table(report),
                               non_recurrence_table(report),
                               quantile_table(report),
                               settling_table(report),
                               leaving_table(report),
                               long_run_table(report),
                               long_run_share_table(report)};
  std::erase_if(tables, [](const RunTable& each) { return each.table.rows.empty(); });
  return tables;
}

std::map<std::string, std::string> table_files(const Report& report, const std::set<std::string>& formats) {
  std::map<std::string, std::string> files;
  for (const RunTable& each : tables_of(report)) {
    if (formats.contains("csv") && is_shown_in(Media::csv, each.media)) files[each.name + ".csv"] = to_csv(each.table);
    if (formats.contains("latex") && is_shown_in(Media::latex, each.media)) {
      files[each.name + ".tex"] = latex_of(each, report);
    }
  }
  if (formats.contains("csv") && report.has_settling()) files["incidence.csv"] = incidence_csv(report);
  return files;
}

}  // namespace rocking
