#include "rocking/studies/fragility/suite_table.hpp"

#include <utility>
#include <vector>

#include "rocking/output/text_table.hpp"
#include "rocking/studies/fragility/words.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

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

std::string bootstrap_text(const std::optional<stats::Interval>& interval) {
  return interval ? interval_in_words(*interval) : ".";
}

std::string law_table(const SuiteCurve& curve) {
  if (!curve.pooled) return "no law is fitted: " + std::string(words_for_suite(curve.outcome)) + '\n';
  const PooledSuite& pooled = *curve.pooled;
  std::vector<TextRow> rows{{"", "value", "profile likelihood", "bootstrap over records"}};
  for (const auto& [name, estimate] :
       {std::pair{"median", &pooled.median}, std::pair{"dispersion", &pooled.dispersion},
        std::pair{"between records", &pooled.between_records}, std::pair{"within a record", &pooled.within_record}}) {
    rows.push_back({name, significant(estimate->value, 3), interval_in_words(estimate->interval),
                    bootstrap_text(estimate->bootstrap)});
  }
  std::string text = "law of the suite\n" + aligned(rows);
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

std::string simple_text(const SimpleLaw& simple) {
  return "pooled law without records (Baker 2015): median " + significant(simple.median.value, 3) + ' ' +
         bootstrap_text(simple.median.bootstrap) + ", dispersion " + significant(simple.dispersion.value, 3) + ' ' +
         bootstrap_text(simple.dispersion.bootstrap) + '\n';
}

std::string level_table_of(const SuiteCurve& curve) {
  const bool has_law = curve.outcome == stats::FragilityOutcome::fitted;
  std::vector<TextRow> rows{{last_key(curve.subject.parameter), "records", "n", column_of(curve.subject.event),
                             has_law ? "fitted" : "isotonic", "band"}};
  for (const SuiteLevel& level : curve.levels) {
    rows.push_back({significant(level.intensity, 6), std::to_string(level.records),
                    std::to_string(level.happened.trials),
                    per_cent(level.estimate) + count_if_open(level.happened.successes, level.happened.trials),
                    per_cent(has_law ? level.fitted.value() : level.isotonic), "."});
    if (!has_law) rows.back().back() = per_cent(level.isotonic_band);
    if (has_law && level.band) rows.back().back() = per_cent(*level.band);
  }
  add_unresolved(curve.levels, 1, rows);
  return "\nshares of the records at each level\n" + aligned(rows);
}

std::string record_table(const SuiteCurve& curve) {
  std::vector<TextRow> rows{{"record", "outcome", "median", "dispersion"}};
  for (const RecordCurve& record : curve.records) {
    const auto& law = record.curve.law;
    rows.push_back({record.name, std::string(to_string(record.curve.outcome)),
                    law ? bounded_in_words(law->median) : ".", law ? bounded_in_words(law->dispersion) : "."});
  }
  return "\neach record\n" + aligned(rows);
}

std::string measure_table(const std::vector<RankedMeasure>& measures) {
  const auto has = [&measures](auto RankedMeasure::*covariate) {
    return std::ranges::any_of(measures, [&](const RankedMeasure& found) { return (found.*covariate).has_value(); });
  };
  const bool has_magnitude = has(&RankedMeasure::by_magnitude), has_distance = has(&RankedMeasure::by_distance);
  std::vector<TextRow> rows{{"measure", "median", "dispersion", "between", "within", "deviance", "AIC"}};
  if (has_magnitude) rows.front().emplace_back("p (magnitude)");
  if (has_distance) rows.front().emplace_back("p (distance)");
  for (const RankedMeasure& found : measures) {
    TextRow row{std::string(to_string(found.measure))};
    const auto add = [&row](const std::optional<double>& number, int digits) {
      row.push_back(number ? significant(*number, digits) : ".");
    };
    for (const auto& number : {found.median, found.dispersion, found.between_records, found.within_record})
      add(number, 3);
    for (const auto& number : {found.deviance, found.aic}) add(number, 6);
    const auto add_p = [&add](const std::optional<stats::SuiteCovariate>& covariate) {
      add(covariate ? std::optional(covariate->p_value) : std::nullopt, 2);
    };
    if (has_magnitude) add_p(found.by_magnitude);
    if (has_distance) add_p(found.by_distance);
    rows.push_back(std::move(row));
  }
  std::string text = "\nmeasures of intensity, smallest dispersion (most efficient) first\n" + aligned(rows);
  if (has_magnitude || has_distance) {
    text += "p: of no dependence of the capacity in this measure on the earthquake; below 0.05 it is not sufficient\n";
  }
  return text;
}

}  // namespace

std::string suite_table(const SuiteCurve& curve, RecordTable records, Extent extent) {
  std::string text = law_table(curve);
  if (curve.simple) text += simple_text(*curve.simple);
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
  std::vector<TextRow> rows{{last_key(analysis.parameter), "n", "overturned", "16 %", "median", "84 %"}};
  for (const PeakTiltLevel& level : analysis.all) {
    TextRow row{significant(level.intensity, 6), std::to_string(level.trials), std::to_string(level.overturned)};
    for (const auto& quantile : level.quantiles) row.push_back(quantile ? significant(*quantile, 3) : "overturned");
    rows.push_back(std::move(row));
  }
  return "peak tilt, abs(theta)/psi, over all records and realisations\n" + aligned(rows) +
         std::to_string(analysis.resurrections.trials) + " of " + std::to_string(analysis.resurrections.of) +
         " realisations that overturned at some level stood again at a stronger one\n";
}

}  // namespace rocking
