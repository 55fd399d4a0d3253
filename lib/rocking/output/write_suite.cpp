#include "rocking/output/write_suite.hpp"

#include <utility>
#include <vector>

#include "rocking/output/fragility_words.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/output/text_table.hpp"
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
    default: break;
  }
  return "this requires two records and two intensities";
}

Json optional_interval(const std::optional<stats::Interval>& interval) {
  return interval ? open_interval_json(*interval) : Json();
}

Json estimate_json(const SuiteEstimate& estimate) {
  return {{"value", estimate.value},
          {"interval", open_interval_json(estimate.interval)},
          {"bootstrap", optional_interval(estimate.bootstrap)}};
}

Json simple_json(const SimpleLaw& simple) {
  const auto one = [](const SimpleEstimate& estimate) {
    return Json{{"value", estimate.value}, {"bootstrap", optional_interval(estimate.bootstrap)}};
  };
  return {{"median", one(simple.median)}, {"dispersion", one(simple.dispersion)}, {"deviance", simple.deviance}};
}

Json pooled_json(const SuiteCurve& curve) {
  const PooledSuite& pooled = curve.pooled.value();
  Json json = Json::object();
  json["median"] = estimate_json(pooled.median);
  json["median"]["extrapolated"] =
      pooled.median.value < curve.levels.front().intensity || curve.levels.back().intensity < pooled.median.value;
  json["dispersion"] = estimate_json(pooled.dispersion);
  json["between_records"] = estimate_json(pooled.between_records);
  json["within_record"] = estimate_json(pooled.within_record);
  json["log_likelihood"] = pooled.law.log_likelihood;
  return json;
}

Json suite_level_json(const SuiteLevel& level) {
  return {{"intensity", level.intensity},
          {"records", level.records},
          {"realisations", level.happened.trials},
          {"overturned", level.happened.successes},
          {"estimate", level.estimate},
          {"fitted", level.fitted ? Json(*level.fitted) : Json()},
          {"band", level.band ? interval_json(*level.band) : Json()}};
}

Json measure_json(const RankedMeasure& measure) {
  Json json = Json::object();
  json["measure"] = name_of(measure.measure);
  if (!measure.law) {
    for (const char* key : {"median", "dispersion", "between_records", "within_record", "deviance", "aic"}) {
      json[key] = nullptr;
    }
    return json;
  }
  json["median"] = measure.law->median;
  json["dispersion"] = measure.law->dispersion();
  json["between_records"] = measure.law->between_records;
  json["within_record"] = measure.law->within_record;
  json["deviance"] = measure.deviance;
  json["aic"] = measure.aic;
  return json;
}

Json tilt_level_json(const PeakTiltLevel& level) {
  Json quantiles = Json::array();
  for (std::size_t i = 0; i < peak_tilt_shares.size(); ++i) {
    quantiles.push_back(Json::array({peak_tilt_shares[i], level.quantiles[i] ? Json(*level.quantiles[i]) : Json()}));
  }
  return {{"intensity", level.intensity},
          {"realisations", level.trials},
          {"overturned", level.overturned},
          {"quantiles", std::move(quantiles)}};
}

Json resurrections_json(const Resurrections& found) { return {{"trials", found.trials}, {"of", found.of}}; }

Json tilt_levels_json(const std::vector<PeakTiltLevel>& levels) {
  Json list = Json::array();
  for (const PeakTiltLevel& level : levels) list.push_back(tilt_level_json(level));
  return list;
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
  std::string text = aligned(rows);
  const double median = pooled.median.value;
  if (median < curve.levels.front().intensity || curve.levels.back().intensity < median) {
    text += "the median lies outside the levels: it is extrapolated\n";
  }
  if (pooled.law.within_record == 0.0) {
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
  std::vector<TextRow> rows{{last_key(curve.parameter), "records", "n", column_of(curve.event), "fitted", "band"}};
  for (const SuiteLevel& level : curve.levels) {
    rows.push_back({significant(level.intensity, 6), std::to_string(level.records),
                    std::to_string(level.happened.trials),
                    per_cent(level.estimate) + count_if_open(level.happened.successes, level.happened.trials),
                    level.fitted ? per_cent(*level.fitted) : ".", level.band ? per_cent(*level.band) : "."});
  }
  return aligned(rows);
}

std::string record_table(const SuiteCurve& curve) {
  std::vector<TextRow> rows{{"record", "outcome", "median", "dispersion"}};
  for (const RecordCurve& record : curve.records) {
    const auto& law = record.curve.fit.law;
    rows.push_back({record.name, std::string(word_of(record.curve.fit.outcome)),
                    law ? bounded_in_words(law->median(curve.confidence)) : ".",
                    law ? bounded_in_words(law->dispersion(curve.confidence)) : "."});
  }
  return aligned(rows);
}

std::string measure_table(const std::vector<RankedMeasure>& measures) {
  std::vector<TextRow> rows{{"measure", "median", "dispersion", "between", "within", "deviance", "AIC"}};
  for (const RankedMeasure& found : measures) {
    TextRow row{std::string(name_of(found.measure)), ".", ".", ".", ".", ".", "."};
    if (found.law) {
      row = {row[0],
             significant(found.law->median, 3),
             significant(found.law->dispersion(), 3),
             significant(found.law->between_records, 3),
             significant(found.law->within_record, 3),
             significant(found.deviance, 6),
             significant(found.aic, 6)};
    }
    rows.push_back(std::move(row));
  }
  return "measures of intensity, smallest dispersion first\n" + aligned(rows);
}

}  // namespace

Json suite_json(const SuiteCurve& curve, Json (*record)(const FragilityCurve&)) {
  Json json = Json::object();
  json["outcome"] = word_of(curve.outcome);
  json["pooled"] = curve.pooled ? pooled_json(curve) : Json();
  json["simple"] = curve.simple ? simple_json(*curve.simple) : Json();
  json["bootstrap"] = {{"samples", curve.bootstrap.samples}, {"with_law", curve.bootstrap.laws.size()}};
  Json& levels = json["levels"] = Json::array();
  for (const SuiteLevel& level : curve.levels) levels.push_back(suite_level_json(level));
  Json& records = json["records"] = Json::array();
  for (const RecordCurve& found : curve.records) {
    Json own = Json::object();
    own["name"] = found.name;
    own.update(record(found.curve));
    records.push_back(std::move(own));
  }
  Json& measures = json["measures"] = Json::array();
  for (const RankedMeasure& measure : curve.measures) measures.push_back(measure_json(measure));
  return json;
}

std::string suite_table(const SuiteCurve& curve, RecordTable records) {
  std::string text = level_table_of(curve) + law_table(curve);
  if (curve.simple) text += simple_text(*curve.simple);
  if (records == RecordTable::shown) text += record_table(curve);
  if (!curve.measures.empty()) text += measure_table(curve.measures);
  return text;
}

Json incremental_json(const IncrementalAnalysis& analysis) {
  Json json = Json::object();
  json["parameter"] = analysis.parameter;
  Json& others = json["others"] = Json::object();
  for (const auto& [pointer, value] : analysis.others) others[pointer] = Json::parse(value);
  json["resurrections"] = resurrections_json(analysis.resurrections);
  json["levels"] = tilt_levels_json(analysis.all);
  Json& records = json["records"] = Json::array();
  for (const PeakTiltCurve& curve : analysis.records) {
    records.push_back({{"name", curve.record},
                       {"resurrections", resurrections_json(curve.resurrections)},
                       {"levels", tilt_levels_json(curve.levels)}});
  }
  return json;
}

std::string incremental_table(const IncrementalAnalysis& analysis) {
  std::vector<TextRow> rows{{last_key(analysis.parameter), "n", "overturned", "16 %", "median", "84 %"}};
  for (const PeakTiltLevel& level : analysis.all) {
    TextRow row{significant(level.intensity, 6), std::to_string(level.trials), std::to_string(level.overturned)};
    for (const auto& quantile : level.quantiles) row.push_back(quantile ? significant(*quantile, 3) : "overturned");
    rows.push_back(std::move(row));
  }
  return aligned(rows) + "peak tilt, abs(theta)/psi, over all records and realisations\n" +
         std::to_string(analysis.resurrections.trials) + " of " + std::to_string(analysis.resurrections.of) +
         " realisations that overturned at some level stood again at a stronger one\n";
}

}  // namespace rocking
