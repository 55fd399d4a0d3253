#include "rocking/output/run_table.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/look/table.hpp"
#include "rocking/output/findings.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// `95 %`; if the conditions have different confidences, words that say so.
std::string level_of(const Report& report) { return report.level("(at the confidence of each condition)"); }

/// The only response mode of a condition; null if realisations differ.
const TableEntry* only_mode(const TableRow& condition) {
  const auto only = std::ranges::find(condition.modes, condition.realisations, &TableEntry::count);
  return only == condition.modes.end() ? nullptr : &*only;
}

/// A line where no condition has two responses; empty if one has, or nothing is random.
std::string alike_line(const Report& report, const std::vector<TableRow>& rows) {
  double most = 0.0;
  for (const TableRow& row : rows) {
    const TableEntry* only = only_mode(row);
    if (only == nullptr || !only->interval || row.realisations < 2 || only->mode == section::ResponseMode{}) return "";
    most = std::max(most, 1.0 - only->interval->low);
  }
  return "in no condition did two realisations respond differently; another response than that of its condition has a "
         "probability\nof at most " +
         per_cent(most) + " % (" + level_of(report) +
         "): if that is enough, one realisation of each suffices for the response modes\n";
}

/// Whether a finding that needs no look is stated: the others are in report.json and on the page.
bool is_stated(const Finding& finding, const Report& report) {
  if (finding.name == late_settling_check) return finding.rating == Rating::note;
  return finding.name == tolerance_check && report.tolerance_sensitivity && finding.rating != Rating::look;
}

/// The legend of the table of every condition.
std::string legend_of(const Report& report, const std::string& table) {
  std::string text;
  if (report.is_random()) {
    text += "\nper cent of n realisations [simultaneous " + level_of(report) + " interval" +
            (report.conditions.front().asked.until ? ", valid whenever the run stops" : "") +
            "]; < x: did not occur, x is the upper end of its interval" + count_legend(report.most_realisations()) +
            '\n';
  } else {
    text += "\nnothing is random: one realisation is the response of its condition\n";
  }
  if (table.find(peak_tilt_heading) != std::string::npos) {
    text += std::string(peak_tilt_legend) + '\n';
    if (table.find(peak_slip_heading) != std::string::npos) text += std::string(peak_slip_legend) + '\n';
    if (has_unlike_edges(report))
      text += "Theta: tilt over psi of the side on which the block is, so that balance is 1 on both\n";
  }
  return text;
}

/// More conditions than the terminal shows: a suite pooled over its records, and ranges of conditions.
std::string summary_of(const std::vector<TableRow>& rows, std::size_t most) {
  const std::string pooled = pooled_summary(rows, most);
  std::string text;
  if (!pooled.empty()) {
    text += "pooled over the records\n" + pooled +
            "overturned: mean over the records of their shares in per cent; of a record: smallest to largest share\n";
  }
  const auto lines = static_cast<std::size_t>(std::ranges::count(pooled, '\n'));
  const std::string ranges = run_summary(rows, most);
  if (pooled.empty() || lines + static_cast<std::size_t>(std::ranges::count(ranges, '\n')) <= most) {
    text += (pooled.empty() ? "" : "\n") + ranges +
            "per cent: smallest to largest share in a condition; response: the most frequent one\n";
  }
  return text + "all " + std::to_string(rows.size()) +
         " conditions with their intervals: --all, `rocking report DIR --format text,csv`, and the page\n";
}

/// The settling of responses, unless it and the lines before it are more than the terminal shows.
std::string settling_of(const Report& report, const TableLook& look, std::ptrdiff_t lines_before) {
  constexpr std::ptrdiff_t most_lines = 55;
  const std::string text = settling_text(settling_rows(report), look.width);
  const bool is_too_long = look.most_rows && lines_before + std::ranges::count(text, '\n') > most_lines;
  return is_too_long ? "when responses settle: --all, and the page\n" : text;
}

constexpr int digits = 3;

look::Cell quantile_at(const Exponents& found, double level, bool with_interval) {
  const auto quantile = std::ranges::find(found.quantiles.levels, level, &stats::QuantileEstimate::level);
  if (quantile == found.quantiles.levels.end() || !quantile->value) return {};
  if (!with_interval) return look::number(quantile->value, digits);
  return look::Number{.value = quantile->value, .form = digits, .interval = look::Ends(quantile->low, quantile->high)};
}

}  // namespace

std::string run_table(const Report& report, const TableLook& look) {
  std::string text = report.title().empty() ? "" : report.title() + "\n\n";
  const std::vector<TableRow> rows = table_rows(report);
  const bool is_summary = look.most_rows && rows.size() > *look.most_rows;
  if (is_summary) {
    text += summary_of(rows, *look.most_rows);
  } else {
    const std::string table = mode_table(rows, look);
    text += table + legend_of(report, table);
  }
  if (!look.most_rows) text += exponent_table(report);
  text += counted(report.conditions.size(), "condition") + ", " + counted(realisations_of(report), "realisation") +
          ", of which " + std::to_string(unresolved_responses(report).count) + " unresolved\n";
  text += settling_of(report, look, std::ranges::count(text, '\n'));
  text += overturning_line(rows) + (is_summary ? "" : side_table(report)) + alike_line(report, rows);
  const std::vector<Finding> findings = findings_of(report);
  for (const Finding& each : findings) {
    if (is_stated(each, report)) text += each.name + ": " + in_words(each) + '\n';
  }
  const auto is_number = [](const ReportedCondition& condition) {
    return !std::holds_alternative<Jy25Restitution>(condition.asked.scene.restitution);
  };
  if (std::ranges::any_of(report.conditions, is_number) &&
      std::ranges::find(findings, "restitution", &Finding::name) == findings.end()) {
    text += "impacts: " + impacts_text(report) + '\n';
  }
  for (const std::string& line : ground_motion_lines(report.ground_motions)) text += line + '\n';
  return text + warning_lines(findings);
}

std::string side_table(const Report& report) {
  if (!has_unlike_edges(report)) return {};
  look::Table table;
  for (const std::string& pointer : report.swept) add_columns(table, {last_key(pointer)});
  add_columns(table, {"n", "overturned", "to the left", "to the right"});
  for (const ReportedCondition& condition : report.conditions) {
    const AnyShare both = share_of(condition, section::ResponseMode{.kind = section::ResponseKind::overturned});
    const auto& [left, right] = std::tie(condition.result.overturned_left, condition.result.overturned_right);
    if (both.count == 0 || !left || !right) continue;
    const std::uint64_t n = condition.result.realisations;
    table.rows.push_back(row_of(condition.asked.parameters,
                                {look::whole(n), share_cell(both, n), share_cell(share_of(condition, *left), n),
                                 share_cell(share_of(condition, *right), n)}));
  }
  if (table.rows.empty()) return {};
  table.title = "side of overturning, in per cent of n";
  return to_terminal(table);
}

std::string exponent_table(const Report& report) {
  look::Table table;
  for (const std::string& pointer : report.swept) add_columns(table, {last_key(pointer)});
  add_columns(table, {"n", "exponents", "median", "5 %", "95 %", "mean", "its error", "error of one"});
  for (const ReportedCondition& condition : report.conditions) {
    if (!condition.result.exponents) continue;
    const Exponents& found = *condition.result.exponents;
    table.rows.push_back(
        row_of(condition.asked.parameters,
               {look::whole(condition.result.realisations), look::whole(found.quantiles.realisations),
                quantile_at(found, 0.5, true), quantile_at(found, 0.05, false), quantile_at(found, 0.95, false),
                look::number(found.mean, digits), look::number(found.standard_error, digits),
                look::number(found.error_of_one, digits)}));
  }
  if (table.rows.empty()) return {};
  table.title = "\nlargest Lyapunov exponent per excitation period, of the realisations whose classification needed it";
  table.notes =
      "median with its interval, quantiles and mean over realisations; error of one: of a single exponent; above 0: "
      "neighbouring motions part\n\n";
  table.absent = "-";
  return to_terminal(table);
}

}  // namespace rocking
