#include "rocking/studies/fragility/study.hpp"

#include <set>

#include "rocking/output/alarms.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/studies/fragility/words.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::number;
using look::percentage;

using stats::FragilityOutcome;

/// The words that replace a fit.
std::string words_for(FragilityOutcome outcome, const ResponseEvent& event) {
  switch (outcome) {
    case FragilityOutcome::fitted: return "";
    case FragilityOutcome::never_happened:
      return "no function is fitted: the block never " + did(event) + "; add higher intensities";
    case FragilityOutcome::always_happened:
      return "no function is fitted: the block always " + did(event) + "; add lower intensities";
    case FragilityOutcome::separated:
      return "no function is fitted: the block never " + did(event) +
             " below an intensity and always above it; add intensities between";
    case FragilityOutcome::does_not_rise:
      return "no function is fitted: the share of realisations that " + did(event) +
             " does not clearly increase with intensity, or too\nfew realisations differ to show it";
    case FragilityOutcome::no_scatter:
      return "no function is fitted: the realisations " + to_do(event) +
             " at the same levels, or differ in one way only, so the uncertainty\ncannot be estimated; make more "
             "parameters random, or add realisations and intensities";
    case FragilityOutcome::rejected:
      return "the lognormal function is rejected; the isotonic estimate and its band, of all levels at once, take its "
             "place";
    case FragilityOutcome::not_monotone:
      return "no function describes these levels: the share of realisations that " + did(event) +
             " falls as the intensity increases,\nwhich contradicts the lognormal function and every other that only "
             "rises";
    case FragilityOutcome::unresolved:
      return "no function is fitted: some realisations ended without an answer, and whether they " + to_do(event) +
             " is not known; the\nintervals of the levels cover both";
    case FragilityOutcome::too_little: break;
  }
  return "no function is fitted: this requires two intensities, and two realisations with different random numbers";
}

/// Pointers to all swept parameters.
std::vector<std::string> swept_in(const FragilityCurve& curve) {
  std::vector<std::string> swept{curve.subject.parameter};
  for (const Parameter& other : curve.subject.others) swept.push_back(other.pointer);
  return swept;
}

/// `2.31 [2.20, 2.43]`; outside the levels `> 1.2 (extrapolated: 1.31 [1.24, 1.42])`.
std::string median_in_words(const FragilityCurve& curve) {
  const stats::Bounded& median = curve.law->median;
  if (!curve.law->is_extrapolated) return bounded_in_words(median);
  const bool is_above = curve.levels.back().intensity < median.value;
  const double nearest = is_above ? curve.levels.back().intensity : curve.levels.front().intensity;
  return (is_above ? "> " : "< ") + significant(nearest, 6) + " (extrapolated: " + bounded_in_words(median) + ')';
}

/// The cells after the intensity.
look::Row row_of(const FragilityLevel& level) {
  look::Cell curve = number(level.isotonic ? level.isotonic : level.fitted, percentage());
  if (level.fitted && !level.isotonic && level.is_missed()) std::get<look::Number>(curve).after = " *";
  return {look::whole(level.overturned.trials),
          number(level.estimate, percentage(), count_if_open(level.overturned.successes, level.overturned.trials)),
          look::interval(level.exact, percentage()), curve, look::interval(level.band, percentage())};
}

/// Median and dispersion, or why there are none, and the test of the function.
std::string law_in_words(const FragilityCurve& curve) {
  const std::string law =
      curve.law ? "median " + median_in_words(curve) + ", dispersion " + bounded_in_words(curve.law->dispersion)
                : words_for(curve.outcome, curve.subject.event);
  return law + '\n' + (curve.test ? test_in_words(*curve.test) : "");
}

std::string curve_table(const FragilityCurve& curve, Extent extent) {
  const bool is_isotonic = curve.outcome == FragilityOutcome::rejected;
  look::Table table{.title = "shares at the levels"};
  std::vector<std::optional<Shaking>> shakings;
  for (const FragilityLevel& level : curve.levels) shakings.push_back(level.shaking);
  const auto beside = shaking_columns(swept_in(curve), shakings);
  add_columns(table, {last_key(curve.subject.parameter)});
  add_columns(table, {beside.begin(), beside.end()});
  add_columns(table, {"n", column_of(curve.subject.event), "exact", is_isotonic ? "isotonic" : "fitted", "band"});
  const std::size_t step = extent == Extent::all ? 1 : (curve.levels.size() + most_screen_rows - 1) / most_screen_rows;
  for (std::size_t i = 0; i < curve.levels.size(); i += step) {
    look::Row& row = table.rows.emplace_back(look::Row{number(curve.levels[i].intensity, 6)});
    for (const std::string_view key : beside) row.emplace_back(column_cell(shakings[i], key));
    append(row, row_of(curve.levels[i]));
  }
  add_unresolved(curve.levels, step, table);
  const std::string common = common_shaking(swept_in(curve), shakings);
  std::string text = law_in_words(curve) + '\n' + to_terminal(table) + rare_table(curve.rare, curve.subject.parameter) +
                     (common.empty() ? "" : "shaking: " + common + '\n');
  const std::size_t missed = curve.missed_levels();
  if (missed == 0) return text;
  return text + "* at " + std::to_string(missed) + " of " + std::to_string(curve.levels.size()) +
         " levels the fitted function lies outside the simultaneous exact interval: it does not describe these data\n";
}

const stats::Proportion& counted_at(const FragilityLevel& level) { return level.overturned; }
const stats::Proportion& counted_at(const SuiteLevel& level) { return level.happened; }

/// Largest number of realisations of a level.
template <class Levels>
std::uint64_t most_realisations(const Levels& levels) {
  std::uint64_t most = 0;
  for (const auto& level : levels) most = std::max(most, counted_at(level).trials);
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
        "likelihood "
        "with its\nband; realisations with the same index use common random numbers at all levels; intervals treat "
        "them as one\ncluster" +
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
  look::Table table{
      .title =
          "rates compared, with the same records and random numbers; intervals hold what the levels leave undecided",
      .notes = "\n"};
  add_columns(table, {"option", "against", "event", "by", "difference per year", "interval", "ratio", "interval"});
  for (const auto& [run, found] : report.comparisons) {
    table.rows.push_back({values_of(found.option), values_of(found.base), words_of(found.event),
                          source_in_words(found.source), number(found.difference, look::rate_form()),
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
          if (reported.rate) text += annual_rate_in_words(*reported.rate, subject);
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
      reasons.insert({one->curve.outcome, words_for(one->curve.outcome, one->curve.subject.event)});
    }
  }
  std::string text;
  for (const auto& [outcome, reason] : reasons) {
    text += std::string(to_string(outcome)) + ": " + reason + '\n';
  }
  return text;
}

/// The name of a curve in the summary.
template <class Reported>
std::string curve_name(const Reported& reported) {
  const std::string values = values_of(reported.curve.subject.others);
  return values.empty() ? reported.run.title : values;
}

/// What the rates of the curves lack, each line with the curve to which it belongs, as many as fit a screen.
std::string warnings_in(const FragilityReport& report) {
  std::vector<std::string> all;
  for (const auto& curve : report.curves) {
    std::visit(
        [&all](const auto& reported) {
          if (!reported.rate) return;
          const ResponseEvent& event = reported.curve.subject.event;
          const std::string name =
              curve_name(reported) + (event.is_overturning() ? std::string() : ", " + column_of(event)) + ": ";
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
        [&table](const auto& reported) {
          const CurveSubject& subject = reported.curve.subject;
          look::Row& row = table.rows.emplace_back(look::Row{curve_name(reported), column_of(subject.event)});
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
  std::vector<std::string> warnings;
  for (const auto& curve : report.curves) {
    const auto missing = left_out_records(std::visit([](const auto& one) { return one.run.left_out; }, curve));
    if (missing && std::ranges::find(warnings, *missing) == warnings.end()) warnings.push_back(*missing);
  }
  std::string text;
  for (const std::string& warning : warnings) text += "warning: " + warning + '\n';
  return text;
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
  const bool has_options = !report.comparisons.empty();  // the only one has its sentence above its tables
  return (has_options ? headline(report) + '\n' : "") + tables_of(report, records, extent) + warnings_of(report);
}

}  // namespace rocking
