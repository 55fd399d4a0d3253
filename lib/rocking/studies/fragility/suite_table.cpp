#include "rocking/studies/fragility/words.hpp"

#include <utility>

#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
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
  look::Table table{.title = "\nshares of the records at each level"};
  add_columns(table, {last_key(curve.subject.parameter), "records", "n", column_of(curve.subject.event),
                      has_law ? "fitted" : "isotonic", "band"});
  for (const SuiteLevel& level : curve.levels) {
    table.rows.push_back(
        {number(level.intensity, 6), whole(level.records), whole(level.happened.trials),
         number(level.estimate, percentage(), count_if_open(level.happened.successes, level.happened.trials)),
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

std::string incremental_table(const IncrementalAnalysis& analysis) {
  look::Table table{.title = "peak tilt, abs(theta)/psi of its side, over all records and realisations",
                    .absent = "overturned"};
  add_columns(table, {last_key(analysis.parameter), "n", "overturned", "16 %", "median", "84 %"});
  for (const PeakTiltLevel& level : analysis.all) {
    look::Row& row =
        table.rows.emplace_back(look::Row{number(level.intensity, 6), whole(level.trials), whole(level.overturned)});
    for (const auto& quantile : level.quantiles) row.push_back(number(quantile, 3));
  }
  return to_terminal(table) + std::to_string(analysis.resurrections.trials) + " of " +
         std::to_string(analysis.resurrections.of) +
         " realisations that overturned at some level stood again at a stronger one\n";
}

}  // namespace rocking
