#include "rocking/output/write_fragility.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/base/error.hpp"
#include "rocking/output/fragility_words.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/output/shaking_fields.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/output/write_annual_rate.hpp"
#include "rocking/scene/shaking.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using stats::FragilityOutcome;
using stats::LognormalFragility;

/// The words that replace a fit.
std::string_view words_for(FragilityOutcome outcome) {
  switch (outcome) {
    case FragilityOutcome::fitted: return "";
    case FragilityOutcome::never_happened:
      return "no function is fitted: the block never overturned; add higher intensities";
    case FragilityOutcome::always_happened:
      return "no function is fitted: the block always overturned; add lower intensities";
    case FragilityOutcome::separated:
      return "no function is fitted: the block never overturned below an intensity and always above it; add "
             "intensities between";
    case FragilityOutcome::does_not_rise:
      return "no function is fitted: the share of overturned realisations does not clearly increase with intensity, "
             "or too\nfew realisations differ to show it";
    case FragilityOutcome::no_scatter:
      return "no function is fitted: the realisations overturn at the same levels, or differ in one way only, so the "
             "uncertainty\ncannot be estimated; make more parameters random, or add realisations and intensities";
    case FragilityOutcome::rejected:
      return "the lognormal function is rejected; the isotonic estimate and its band, of all levels at once, take its "
             "place";
    case FragilityOutcome::not_monotone:
      return "no function describes these levels: the share of overturned realisations falls as the intensity "
             "increases,\nwhich contradicts the lognormal function and every other that only rises";
    case FragilityOutcome::too_little: break;
  }
  return "no function is fitted: this requires two intensities, and two realisations with different random numbers";
}

/// `null`: without an upper bound.
Json bounded_json(const stats::Bounded& bounded) {
  return {{"value", bounded.value}, {"interval", open_interval_json(bounded.interval)}};
}

Json law_json(const FragilityCurve& curve) {
  const LognormalFragility& law = curve.fit.law.value();
  const stats::Bounded median = law.median(curve.confidence);
  Json json = Json::object();
  json["median"] = bounded_json(median);
  json["median"]["extrapolated"] = curve.is_extrapolated(median.value);
  json["dispersion"] = bounded_json(law.dispersion(curve.confidence));
  json["centre"] = law.centre;
  json["intercept"] = law.intercept;
  json["slope"] = law.slope;
  json["covariance"] = Json::array({law.covariance.aa, law.covariance.ab, law.covariance.bb});
  json["degrees_of_freedom"] = law.degrees_of_freedom;
  return json;
}

Json test_json(const stats::LackOfFit& test) {
  return {
      {"deviance", test.deviance}, {"samples", test.samples}, {"as_large", test.as_large}, {"p_value", test.p_value}};
}

/// Of the condition at each level of a curve.
std::vector<std::optional<Shaking>> shakings_of(const RunFragility& run, const FragilityCurve& curve) {
  std::vector<std::optional<Shaking>> shakings;
  for (const FragilityLevel& level : curve.levels) {
    const auto is_at_level = [&](const Condition& condition) {
      return std::ranges::all_of(condition.parameters, [&](const Parameter& parameter) {
        if (parameter.pointer == curve.parameter) return Json::parse(parameter.value) == Json(level.intensity);
        return std::ranges::any_of(curve.others, [&](const Parameter& other) {
          return other.pointer == parameter.pointer && other.value == parameter.value;
        });
      });
    };
    const auto condition = std::ranges::find_if(run.experiment.conditions, is_at_level);
    ROCKING_EXPECT(condition != run.experiment.conditions.end());
    shakings.push_back(shaking_of(condition->scene));
  }
  return shakings;
}

/// Pointers to all swept parameters.
std::vector<std::string> swept_in(const FragilityCurve& curve) {
  std::vector<std::string> swept{curve.parameter};
  for (const Parameter& other : curve.others) swept.push_back(other.pointer);
  return swept;
}

Json level_json(const FragilityLevel& level, const std::optional<Shaking>& shaking) {
  Json json = Json::object();
  json["intensity"] = level.intensity;
  if (shaking) json["shaking"] = type_of<Shaking>().json(&*shaking);
  json["realisations"] = level.overturned.trials;
  json["overturned"] = level.overturned.successes;
  json["estimate"] = level.estimate;
  json["exact"] = interval_json(level.exact);
  json["simultaneous"] = interval_json(level.simultaneous);
  json["fitted"] = level.fitted ? Json(level.fitted->value) : Json();
  json["band"] = level.fitted     ? interval_json(level.fitted->band)
                 : level.isotonic ? interval_json(level.simultaneous)
                                  : Json();
  json["isotonic"] = level.isotonic ? Json(*level.isotonic) : Json();
  return json;
}

/// What the curve of one motion or of a suite begins with: its run, intensity and event.
template <class Curve>
Json begun_json(const RunFragility& run, const Curve& curve) {
  Json json = Json::object();
  json["title"] = run.experiment.title;
  json["sha256"] = base::to_hex(base::sha256(run.experiment.canonical_text));
  json["parameter"] = curve.parameter;
  Json& values = json["others"] = Json::object();
  for (const auto& [pointer, value] : curve.others) values[pointer] = Json::parse(value);
  json["confidence"] = curve.confidence;
  json["event"] = event_json(curve.event);
  json["least_uplift"] = curve.least_uplift ? Json(*curve.least_uplift) : Json();
  return json;
}

/// Outcome, function, test and levels of a curve.
Json found_json(const FragilityCurve& curve, const std::vector<std::optional<Shaking>>& shakings) {
  Json json = Json::object();
  json["outcome"] = word_of(curve.fit.outcome);
  json["law"] = curve.fit.law ? law_json(curve) : Json();
  json["test"] = curve.test ? test_json(*curve.test) : Json();
  json["missed_levels"] = curve.fit.law ? Json(curve.missed_levels()) : Json();
  Json& levels = json["levels"] = Json::array();
  for (std::size_t i = 0; i < curve.levels.size(); ++i) levels.push_back(level_json(curve.levels[i], shakings[i]));
  return json;
}

/// A ground motion has no amplitude and no frequency.
Json record_json(const FragilityCurve& curve) {
  return found_json(curve, std::vector<std::optional<Shaking>>(curve.levels.size()));
}

Json curve_json(const RunFragility& run, const ShownCurve& shown) {
  const FragilityCurve& curve = shown.curve;
  Json json = begun_json(run, curve);
  json.update(found_json(curve, shakings_of(run, curve)));
  if (shown.rate) json["annual_rate"] = annual_rate_json(shown.rate);
  return json;
}

Json shown_suite_json(const RunFragility& run, const ShownSuite& shown) {
  const SuiteCurve& curve = shown.curve;
  Json json = begun_json(run, curve);
  json.update(suite_json(curve, record_json));
  if (shown.has_hazard) json["annual_rate"] = annual_rate_json(shown.rate);
  return json;
}

/// `2.31 [2.20, 2.43]`; outside the levels `> 1.2 (extrapolated: 1.31 [1.24, 1.42])`.
std::string median_in_words(const FragilityCurve& curve) {
  const stats::Bounded median = curve.fit.law->median(curve.confidence);
  if (!curve.is_extrapolated(median.value)) return bounded_in_words(median);
  const bool is_above = curve.levels.back().intensity < median.value;
  const double nearest = is_above ? curve.levels.back().intensity : curve.levels.front().intensity;
  return (is_above ? "> " : "< ") + significant(nearest, 6) + " (extrapolated: " + bounded_in_words(median) + ')';
}

std::string in_words(const stats::LackOfFit& test) {
  return "lack of fit: deviance " + significant(test.deviance, 3) + ", p = " + significant(test.p_value, 2) + " (" +
         std::to_string(test.samples) + " bootstrap samples)\n";
}

TextRow row_of(const FragilityLevel& level) {
  TextRow row{significant(level.intensity, 6),
              std::to_string(level.overturned.trials),
              per_cent(level.estimate) + count_if_open(level.overturned.successes, level.overturned.trials),
              per_cent(level.exact),
              ".",
              "."};
  if (level.fitted) {
    row[4] = per_cent(level.fitted->value) + (level.fitted->is_missed ? " *" : "");
    row[5] = per_cent(level.fitted->band);
  } else if (level.isotonic) {
    row[4] = per_cent(*level.isotonic);
    row[5] = per_cent(level.simultaneous);
  }
  return row;
}

std::string table_of(const RunFragility& run, const FragilityCurve& curve) {
  const bool is_isotonic = curve.fit.outcome == FragilityOutcome::rejected;
  std::vector<TextRow> rows{
      {last_key(curve.parameter), "n", column_of(curve.event), "exact", is_isotonic ? "isotonic" : "fitted", "band"}};
  const auto shakings = shakings_of(run, curve);
  const auto beside = shaking_columns(swept_in(curve), shakings);
  rows.front().insert(rows.front().begin() + 1, beside.begin(), beside.end());
  for (std::size_t i = 0; i < curve.levels.size(); ++i) {
    TextRow row = row_of(curve.levels[i]);
    for (std::size_t k = beside.size(); k-- > 0;) row.insert(row.begin() + 1, column_cell(shakings[i], beside[k]));
    rows.push_back(std::move(row));
  }
  const std::string common = common_shaking(swept_in(curve), shakings);
  std::string text = aligned(rows) + (common.empty() ? "" : "shaking: " + common + '\n');
  if (curve.fit.law) {
    text += "median " + median_in_words(curve) + ", dispersion " +
            bounded_in_words(curve.fit.law->dispersion(curve.confidence)) + '\n';
  } else {
    text += std::string(words_for(curve.fit.outcome)) + '\n';
  }
  if (curve.test) text += in_words(*curve.test);
  const std::size_t missed = curve.missed_levels();
  if (missed == 0) return text;
  return text + "* at " + std::to_string(missed) + " of " + std::to_string(curve.levels.size()) +
         " levels the fitted function lies outside the simultaneous exact interval: it does not describe these data\n";
}

bool has_isotonic(const std::vector<RunFragility>& runs) {
  return std::any_of(runs.begin(), runs.end(), [](const RunFragility& run) {
    return std::any_of(run.curves.begin(), run.curves.end(),
                       [](const ShownCurve& shown) { return shown.curve.fit.outcome == FragilityOutcome::rejected; });
  });
}

}  // namespace

std::string fragility_text(const std::vector<RunFragility>& runs) {
  Json json = Json::object();
  json["format"] = fragility_format;
  Json& curves = json["curves"] = Json::array();
  Json incremental = Json::array();
  for (const RunFragility& run : runs) {
    for (const ShownCurve& curve : run.curves) curves.push_back(curve_json(run, curve));
    for (const ShownSuite& suite : run.suites) curves.push_back(shown_suite_json(run, suite));
    for (const IncrementalAnalysis& analysis : run.incremental) {
      Json shown = Json::object();
      shown["title"] = run.experiment.title;
      shown["sha256"] = base::to_hex(base::sha256(run.experiment.canonical_text));
      shown.update(incremental_json(analysis));
      incremental.push_back(std::move(shown));
    }
  }
  if (!incremental.empty()) json["incremental"] = std::move(incremental);
  return json.dump(1) + '\n';
}

std::string fragility_table(const std::vector<RunFragility>& runs, RecordTable records) {
  std::string text;
  bool has_curve = false;
  bool has_suite = false;
  std::uint64_t most = 0;  // realisations of a level
  for (const RunFragility& run : runs) {
    for (const auto& [curve, rate] : run.curves) {
      for (const FragilityLevel& level : curve.levels) most = std::max(most, level.overturned.trials);
      text += heading_of_curve(run.experiment, curve.others) + table_of(run, curve);
      if (rate) text += annual_rate_table(*rate, curve.event, curve.parameter, curve.least_uplift);
      text += '\n';
      has_curve = true;
    }
    for (const ShownSuite& shown : run.suites) {
      const SuiteCurve& curve = shown.curve;
      for (const SuiteLevel& level : curve.levels) most = std::max(most, level.happened.trials);
      text += heading_of_curve(run.experiment, curve.others) + suite_table(curve, records);
      if (shown.rate) {
        text += annual_rate_table(*shown.rate, curve.event, curve.parameter, curve.least_uplift);
      }
      if (shown.has_hazard && !shown.rate) text += "no annual rate: the suite has no law\n";
      text += '\n';
      has_suite = true;
    }
    for (const IncrementalAnalysis& analysis : run.incremental) {
      text += heading_of_curve(run.experiment, analysis.others) + incremental_table(analysis) + '\n';
    }
  }
  if (has_curve) {
    text +=
        "per cent of n realisations [exact interval of each level alone]; fitted: lognormal function of maximum "
        "likelihood "
        "with its\nband; realisations with the same index use common random numbers at all levels; intervals treat "
        "them as one\ncluster" +
        count_legend(most) + '\n';
  }
  if (has_isotonic(runs)) {
    text += "isotonic: most likely probabilities that do not decrease; their band covers all levels at once\n";
  }
  if (has_suite) {
    text +=
        "per cent: mean over the records of their shares; fitted: lognormal law with scatter between and within "
        "records; "
        "its band\nis a bootstrap over records; the probability is that of a record like those of the suite" +
        count_legend(most) + '\n';
  }
  return text;
}

}  // namespace rocking
