#include "rocking/studies/fragility/study.hpp"

#include <set>

#include "rocking/output/findings.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::number;
using look::percentage;

using stats::FragilityOutcome;

/// Largest number of realisations of a level.
template <class Levels>
std::uint64_t most_realisations(const Levels& levels) {
  std::uint64_t most = 0;
  for (const auto& level : levels) most = std::max(most, level.overturned.trials);
  return most;
}

/// What is printed of each curve.
struct Content {
  RecordTable records = RecordTable::omitted;
  Extent extent = Extent::all;
};

/// What the tables of a report have, for the legends below them.
struct Shown {
  bool has_curve = false, has_isotonic = false, has_suite = false;
  std::uint64_t most = 0;  ///< realisations of a level
};

std::string legends(const Shown& shown) {
  std::string text;
  if (shown.has_curve) {
    text +=
        "per cent of n realisations [exact interval of each level alone]; fitted: lognormal function of maximum "
        "likelihood with its\nband; realisations with the same index use common random numbers at all levels; "
        "intervals treat them as one\ncluster" +
        count_legend(shown.most) + '\n';
  }
  if (shown.has_isotonic) {
    text += "isotonic: most likely probabilities that do not decrease; their band covers all levels at once\n";
  }
  if (shown.has_suite) {
    text +=
        "per cent: mean over the records of their shares; fitted: lognormal law with scatter between and within "
        "records;\nisotonic: the nearest shares that do not decrease; bands by bootstrap over records; the probability "
        "is that of\na record like those of the suite" +
        count_legend(shown.most) + '\n';
  }
  return text;
}

std::string table_of(const ReportedCurve& reported, const Content& content, Shown& shown) {
  shown.has_curve = true;
  shown.has_isotonic = shown.has_isotonic || reported.curve.outcome == FragilityOutcome::rejected;
  return curve_table(reported.curve, content.extent);
}

std::string table_of(const ReportedSuite& reported, const Content& content, Shown& shown) {
  shown.has_suite = true;
  return suite_table(reported.curve, content.records, content.extent);
}

/// Median and dispersion of a row of the summary; the outcome where there are none.
look::Row law_cells(const FragilityCurve& curve) {
  if (!curve.law) return {std::string(to_string(curve.outcome)), look::Cell()};
  return {median_in_words(curve), bounded_in_words(curve.law->dispersion)};
}

look::Row law_cells(const SuiteCurve& curve) {
  if (!curve.has_law()) return {std::string(to_string(curve.outcome)), look::Cell()};
  const PooledSuite& pooled = *curve.pooled;
  return {estimate_cell(pooled.median.value, pooled.median.interval),
          estimate_cell(pooled.dispersion.value, pooled.dispersion.interval)};
}

std::string comparisons_of(const FragilityReport& report) {
  if (report.comparisons.empty()) return "";
  const bool are_several = !name_before(", ", report, report.comparisons.front().run).empty();
  look::Table table{
      .title = std::string("rates compared") + (are_several ? " within each run" : "") +
               ", with the same records and random numbers; intervals hold what the levels leave undecided",
      .notes = "\n"};
  add_columns(table, {"option", "against", "event", "by", "difference per year", "interval", "ratio", "interval"});
  for (const auto& [run, found] : report.comparisons) {
    table.rows.push_back({name_before(", ", report, run) + values_of(found.option), values_of(found.base),
                          words_of(found.event), source_in_words(found.source),
                          number(found.difference, look::rate_form()),
                          look::interval(found.interval, look::rate_form()), number(found.ratio, look::rate_form()),
                          look::interval(found.ratio_interval, look::rate_form())});
  }
  return to_terminal(table);
}

std::string curve_tables(const FragilityReport& report, const Content& content) {
  std::string text;
  Shown shown;
  for (const auto& curve : report.curves) {
    std::visit(
        [&](const auto& reported) {
          const CurveSubject& subject = reported.curve.subject;
          shown.most = std::max(shown.most, most_realisations(reported.curve.levels));
          text += heading_of_curve(reported.run.title, subject.others);
          const bool is_only = report.curves.size() == 1;  // whose sentence is the headline
          if (reported.rate && !is_only) text += rate_sentence(subject, *reported.rate) + ".\n";
          if (reported.rate) text += rate_sources_in_words(*rate_of(reported), subject);
          text += table_of(reported, content, shown);
          if (reported.rate) text += annual_rate_table(*reported.rate, subject, content.extent);
          text += '\n';
        },
        curve);
  }
  text += comparisons_of(report);
  for (const auto& [run, analysis] : report.incremental) {
    text += heading_of_curve(run.title, analysis.others) + incremental_table(analysis) + '\n';
  }
  return text + legends(shown);
}

/// A line for each reason why curves of one motion have no function.
std::string reasons_in(const FragilityReport& report) {
  std::set<std::pair<FragilityOutcome, std::string>> reasons;
  for (const auto& curve : report.curves) {
    const auto* one = std::get_if<ReportedCurve>(&curve);
    if (one != nullptr && !one->curve.law) {
      reasons.insert({one->curve.outcome, why_without_law(one->curve.outcome, one->curve.subject.event)});
    }
  }
  std::string text;
  for (const auto& [outcome, reason] : reasons) {
    text += std::string(to_string(outcome)) + ": " + reason + '\n';
  }
  return text;
}

/// The name of a curve in the summary: what tells it from the others.
template <class Reported>
std::string curve_name(const FragilityReport& report, const Reported& reported) {
  const std::string values = values_of(reported.curve.subject.others);
  if (values.empty()) return reported.run.title;
  return name_before(", ", report, reported.run) + values;
}

/// What the rates of the curves lack, each line with the curve to which it belongs, as many as fit a screen.
std::string warnings_in(const FragilityReport& report) {
  std::vector<std::string> all;
  for (const auto& curve : report.curves) {
    std::visit(
        [&](const auto& reported) {
          if (!reported.rate) return;
          const ResponseEvent& event = reported.curve.subject.event;
          const std::string name =
              curve_name(report, reported) + (event.is_overturning() ? std::string() : ", " + column_of(event)) + ": ";
          std::string lines = annual_rate_warnings(*reported.rate);
          for (std::size_t end = lines.find('\n'); end != std::string::npos; end = lines.find('\n')) {
            all.push_back(name + lines.substr(0, end + 1));
            lines.erase(0, end + 1);
          }
        },
        curve);
  }
  std::string text;
  for (std::size_t i = 0; i < std::min(all.size(), most_screen_rows); ++i) text += all[i];
  if (all.size() <= most_screen_rows) return text;
  return text + std::to_string(all.size() - most_screen_rows) + " more such lines: --all\n";
}

/// A row for each curve, in the units of its sweep.
std::string summary_of(const FragilityReport& report) {
  look::Table table{.title = "curves, median and dispersion in the units of the sweep"};
  add_columns(table, {"curve", "event", "median", "dispersion", "per year", "years"});
  for (const auto& curve : report.curves) {
    std::visit(
        [&](const auto& reported) {
          const CurveSubject& subject = reported.curve.subject;
          look::Row& row = table.rows.emplace_back(look::Row{
              curve_name(report, reported), column_of(subject.event) + in_degrees(subject.event, subject.balance)});
          append(row, law_cells(reported.curve));
          const AnnualRate* rate = rate_of(reported);
          row.push_back(rate ? number(rate->value, look::rate_form()) : look::Cell());
          row.push_back(rate && rate->value > 0.0 ? years_in_words(1.0 / rate->value) : look::Cell());
        },
        curve);
  }
  table.rows.resize(std::min(table.rows.size(), most_screen_rows - 1));
  return to_terminal(table) + reasons_in(report) + warnings_in(report);
}

/// A warning for each run whose suite lacks records.
std::string warnings_of(const FragilityReport& report) {
  std::vector<Finding> warnings;
  for (const auto& curve : report.curves) {
    const auto missing = left_out_records(std::visit([](const auto& one) { return one.run.left_out; }, curve));
    if (missing && std::ranges::find(warnings, missing->text, &Finding::text) == warnings.end()) {
      warnings.push_back(*missing);
    }
  }
  return warning_lines(warnings);
}

std::string tables_of(const FragilityReport& report, RecordTable records, Extent extent) {
  const std::string whole = curve_tables(report, {.records = records, .extent = Extent::all});
  if (is_printed_whole(whole, extent)) return whole;
  const std::string more = "more rows: --all, and --json\n";
  const std::string shorter = curve_tables(report, {.records = records, .extent = Extent::one_screen});
  if (report.curves.size() < 2 || is_printed_whole(shorter, extent)) return shorter + more;
  return summary_of(report) + '\n' + comparisons_of(report) + more;
}

}  // namespace

std::string fragility_table(const FragilityReport& report, RecordTable records, Extent extent) {
  std::string text = headline(report) + '\n';
  for (const auto& [run, surface] : report.surfaces) text += surface_table(run.title, surface);
  return text + tables_of(report, records, extent) + warnings_of(report);
}

}  // namespace rocking
