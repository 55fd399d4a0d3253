#include "rocking/output/run_table.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/look/table.hpp"
#include "rocking/output/findings.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/response_event_text.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

/// `95 %`; if the conditions have different confidences, words that say so.
std::string level_of(const Report& report) { return report.level("(at the confidence of each condition)"); }

/// A line where no condition has two responses; empty if one has, or nothing is random.
std::string alike_line(const Report& report) {
  double most = 0.0;
  for (const ReportedCondition& each : report.conditions) {
    const section::ResponseMode mode = most_frequent_in(each);
    const AnyShare share = share_of(each, mode);
    const std::uint64_t all = each.result.realisations;
    if (share.count < all || !share.interval || all < 2 || mode == section::ResponseMode{}) return "";
    most = std::max(most, 1.0 - share.interval->low);
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
    std::optional<BalanceAngles> balance;
    for (const ReportedCondition& each : report.conditions) balance = joined(balance, balance_of(each.asked.scene));
    text += "peak tilt: median and 95 % quantile of the largest tilt over psi of its side" +
            in_degrees({EventName::tilt, 1.0}, balance) + "; overturned counts as above every value (-)\n";
    if (table.find(peak_slip_heading) != std::string::npos) text += std::string(peak_slip_legend) + '\n';
  }
  return text;
}

/// More conditions than the terminal shows: a suite pooled over its records, and ranges of conditions.
std::string summary_of(const Report& report, std::size_t most) {
  const std::string pooled = pooled_summary(report, most);
  std::string text;
  if (!pooled.empty()) {
    text += "pooled over the records\n" + pooled +
            "overturned: mean over the records of their shares in per cent; of a record: smallest to largest share\n";
  }
  const auto lines = static_cast<std::size_t>(std::ranges::count(pooled, '\n'));
  const std::string ranges = run_summary(report, most);
  if (pooled.empty() || lines + static_cast<std::size_t>(std::ranges::count(ranges, '\n')) <= most) {
    text += (pooled.empty() ? "" : "\n") + ranges +
            "per cent: smallest to largest share in a condition; response: the most frequent one\n";
  }
  return text + "all " + std::to_string(report.conditions.size()) +
         " conditions with their intervals: --all, `rocking report DIR --format text,csv`, and the page\n";
}

/// The settling of responses, unless it and the lines before it are more than the terminal shows.
std::string settling_of(const Report& report, const TableLook& look, std::ptrdiff_t lines_before) {
  constexpr std::ptrdiff_t most_lines = 55;
  const std::string text = settling_text(report, look.width);
  const bool is_too_long = look.most_rows && lines_before + std::ranges::count(text, '\n') > most_lines;
  return is_too_long ? "when responses settle: --all, and the page\n" : text;
}

constexpr int digits = 3;

look::Cell quantile_cell(const Exponents& found, double level) {
  const auto [at, value, low, high] = quantile_at(found.quantiles.levels, level);
  if (!value) return {};
  return look::Number{.value = value, .form = digits, .interval = look::Ends(low, high)};
}

/// Overturning to the left and to the right in the conditions where it occurs; empty without any, and where no block has
/// unlike edges.
std::string side_table(const Report& report) {
  if (!has_unlike_edges(report)) return {};
  const auto overturns = [](const ReportedCondition& each) {
    return count_of(each, {.kind = section::ResponseKind::overturned}) > 0 && each.result.overturned_left &&
           each.result.overturned_right;
  };
  const auto share = [](auto part) {
    return [part](const ReportedCondition& each) {
      return share_cell(share_of(each, part(each.result)), each.result.realisations);
    };
  };
  ConditionColumns columns = condition_columns(report, look::Media::publications, look::Media::all);
  columns.push_back({{.title = "overturned"}, share([](const ConditionResult&) {
                       return section::ResponseMode{.kind = section::ResponseKind::overturned};
                     })});
  columns.push_back({{.title = "to the left"}, share([](const auto& result) { return *result.overturned_left; })});
  columns.push_back({{.title = "to the right"}, share([](const auto& result) { return *result.overturned_right; })});
  look::Table table = table_of(report, columns, overturns);
  table.title = "side of overturning, in per cent of n";
  return table.rows.empty() ? "" : to_terminal(table);
}

/// The largest Lyapunov exponents of the conditions whose classification needed some; empty without any.
std::string exponent_table(const Report& report) {
  ConditionColumns columns = condition_columns(report, look::Media::publications, look::Media::all);
  const auto add = [&columns](const char* title, auto cell_of) {
    columns.push_back({{.title = title}, [cell_of](const auto& each) { return cell_of(*each.result.exponents); }});
  };
  add("exponents", [](const Exponents& found) { return look::whole(found.quantiles.realisations); });
  add("median", [](const Exponents& found) { return quantile_cell(found, 0.5); });
  add("5 %", [](const Exponents& found) { return without_interval(quantile_cell(found, 0.05)); });
  add("95 %", [](const Exponents& found) { return without_interval(quantile_cell(found, 0.95)); });
  add("mean", [](const Exponents& found) { return look::number(found.mean, digits); });
  add("its error", [](const Exponents& found) { return look::number(found.standard_error, digits); });
  add("error of one", [](const Exponents& found) { return look::number(found.error_of_one, digits); });
  look::Table table =
      table_of(report, columns, [](const ReportedCondition& each) { return each.result.exponents.has_value(); });
  if (table.rows.empty()) return {};
  table.title = "\nlargest Lyapunov exponent per excitation period, of the realisations whose classification needed it";
  table.notes =
      "median with its interval, quantiles and mean over realisations; error of one: of a single exponent; above 0: "
      "neighbouring motions part\n\n";
  table.absent = "-";
  return to_terminal(table);
}

}  // namespace

std::string run_table(const Report& report, const TableLook& look) {
  std::string text = report.title().empty() ? "" : report.title() + "\n\n";
  const bool is_summary = look.most_rows && report.conditions.size() > *look.most_rows;
  if (is_summary) {
    text += summary_of(report, *look.most_rows);
  } else {
    const std::string table = mode_table(report, look);
    text += table + legend_of(report, table);
  }
  if (!look.most_rows) text += exponent_table(report);
  text += counted(report.conditions.size(), "condition") + ", " + counted(realisations_of(report), "realisation") +
          ", of which " + std::to_string(unresolved_responses(report).count) + " unresolved\n";
  text += settling_of(report, look, std::ranges::count(text, '\n'));
  text +=
      response_line(report) + overturning_line(report) + (is_summary ? "" : side_table(report)) + alike_line(report);
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
  if (const std::string floor = floor_in_words(report); !floor.empty()) text += "the block stands " + floor + '\n';
  return text + warning_lines(findings);
}

std::string tables_in_full(const Report& report, const TableLook& look) {
  const std::string settling = settling_text(report, look.width);
  return mode_table(report, look) + exponent_table(report) + (settling.empty() ? "" : '\n' + settling);
}

}  // namespace rocking
