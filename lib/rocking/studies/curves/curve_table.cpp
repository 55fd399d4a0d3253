#include <utility>

#include "rocking/output/parameter_text.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/studies/curves/look.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::number;
using look::percentage;

using stats::FragilityOutcome;

/// Pointers to all swept parameters.
std::vector<std::string> swept_in(const FragilityCurve& curve) {
  std::vector<std::string> swept{curve.subject.parameter};
  for (const Parameter& other : curve.subject.others) swept.push_back(other.pointer);
  return swept;
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
                : why_without_law(curve.outcome, curve.subject.event);
  return law + '\n' + (curve.test ? test_in_words(*curve.test) : "");
}

}  // namespace

std::string why_without_law(FragilityOutcome outcome, const ResponseEvent& event) {
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

std::string median_in_words(const FragilityCurve& curve) {
  const stats::Bounded& median = curve.law->median;
  if (!curve.law->is_extrapolated) return bounded_in_words(median);
  const bool is_above = curve.levels.back().intensity < median.value;
  const double nearest = is_above ? curve.levels.back().intensity : curve.levels.front().intensity;
  return (is_above ? "> " : "< ") + significant(nearest, 6) + " (extrapolated: " + bounded_in_words(median) + ')';
}

std::string curve_table(const FragilityCurve& curve, Extent extent) {
  const bool is_isotonic = curve.outcome == FragilityOutcome::rejected;
  look::Table table{.title = "shares at the levels" + tilt_note(curve.subject)};
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

namespace {

using look::number;
using look::percentage;
using look::whole;

std::string_view words_for_suite(stats::FragilityOutcome outcome) {
  switch (outcome) {
    case stats::FragilityOutcome::never_happened: return "it never happened; add higher intensities";
    case stats::FragilityOutcome::always_happened: return "it always happened; add lower intensities";
    case stats::FragilityOutcome::separated:
      return "every record has its threshold between the same levels, so the scatter may be 0; add intensities between";
    case stats::FragilityOutcome::does_not_rise: return "the share does not clearly increase with intensity";
    case stats::FragilityOutcome::unresolved:
      return "some realisations ended without an answer, and whether they have the event is not known; bands cover "
             "both";
    default: break;
  }
  return "this requires two records and two intensities";
}

std::string law_table(const SuiteCurve& curve) {
  if (!curve.pooled) return "no law is fitted: " + std::string(words_for_suite(curve.outcome)) + '\n';
  const PooledSuite& pooled = *curve.pooled;
  look::Table table{.title = "law of the suite"};
  add_columns(table, {"", "value", "profile likelihood", "bootstrap over records"});
  for (const auto& [name, estimate] :
       {std::pair{"median", &pooled.median}, std::pair{"dispersion", &pooled.dispersion},
        std::pair{"between records", &pooled.between_records}, std::pair{"within a record", &pooled.within_record}}) {
    table.rows.push_back({name, number(estimate->value, 3), look::interval(estimate->interval, 3),
                          look::interval(estimate->bootstrap, 3)});
  }
  std::string text = to_terminal(table);
  if (curve.test) text += test_in_words(*curve.test);
  if (curve.outcome == stats::FragilityOutcome::rejected) {
    text += "the lognormal law is rejected: it does not describe these shares; use the isotonic ones\n";
  }
  if (pooled.is_extrapolated) text += "the median lies outside the levels: it is extrapolated\n";
  if (pooled.within_record.value == 0.0) {
    text += "the outcomes of every record are a step: its realisations show no scatter at these levels\n";
  }
  return text;
}

std::string level_table_of(const SuiteCurve& curve) {
  const bool has_law = curve.has_law();
  look::Table table{.title = "\nshares of the records at each level" + tilt_note(curve.subject)};
  add_columns(table, {last_key(curve.subject.parameter), "records", "n", column_of(curve.subject.event),
                      has_law ? "fitted" : "isotonic", "band"});
  for (const SuiteLevel& level : curve.levels) {
    table.rows.push_back(
        {number(level.intensity, 6), whole(level.records), whole(level.overturned.trials),
         number(level.estimate, percentage(), count_if_open(level.overturned.successes, level.overturned.trials)),
         number(has_law ? level.fitted.value() : level.isotonic, percentage()),
         look::interval(has_law ? level.band : level.isotonic_band, percentage())});
  }
  add_unresolved(curve.levels, 1, table);
  return to_terminal(table);
}

std::string record_table(const SuiteCurve& curve) {
  look::Table table{.title = "\neach record"};
  add_columns(table, {"record", "outcome", "median", "dispersion"});
  const auto cell = [](const stats::Bounded& found) { return estimate_cell(found.value, found.interval); };
  for (const RecordCurve& record : curve.records) {
    const auto& law = record.curve.law;
    table.rows.push_back({record.name, std::string(to_string(record.curve.outcome)),
                          law ? cell(law->median) : look::Cell(), law ? cell(law->dispersion) : look::Cell()});
  }
  return to_terminal(table);
}

std::string measure_table(const std::vector<RankedMeasure>& measures) {
  look::Table table{.title = "\nmeasures of intensity, smallest dispersion (most efficient) first"};
  add_columns(table, {"measure", "median", "dispersion", "between", "within", "deviance", "AIC"});
  for (const RankedMeasure& found : measures) {
    look::Row& row = table.rows.emplace_back(look::Row{std::string(to_string(found.measure))});
    for (const auto& each : {found.median, found.dispersion, found.between_records, found.within_record}) {
      row.push_back(number(each, 3));
    }
    for (const auto& each : {found.deviance, found.aic}) row.push_back(number(each, look::decimals(1)));
  }
  return to_terminal(table);
}

}  // namespace

std::string suite_table(const SuiteCurve& curve, RecordTable records, Extent extent) {
  std::string text = law_table(curve);
  text += level_table_of(curve) + rare_table(curve.rare, curve.subject.parameter);
  if (records == RecordTable::shown) text += record_table(curve);
  if (curve.measures.empty()) return text;
  if (extent == Extent::all) return text + measure_table(curve.measures);
  const RankedMeasure& best = curve.measures.front();
  if (!best.dispersion) return text;
  return text + "most efficient of " + std::to_string(curve.measures.size()) +
         " measures of intensity: " + std::string(to_string(best.measure)) + ", dispersion " +
         significant(*best.dispersion, 3) + '\n';
}

}  // namespace rocking
