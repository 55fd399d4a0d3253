#include "rocking/output/write_fragility.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/base/error.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/scene/shaking.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using stats::FragilityOutcome;
using stats::LognormalFragility;

std::string_view name_of(FragilityOutcome outcome) {
  switch (outcome) {
    case FragilityOutcome::fitted: return "fitted";
    case FragilityOutcome::never_happened: return "never_happened";
    case FragilityOutcome::always_happened: return "always_happened";
    case FragilityOutcome::separated: return "separated";
    case FragilityOutcome::does_not_rise: return "does_not_rise";
    case FragilityOutcome::no_scatter: return "no_scatter";
    case FragilityOutcome::rejected: return "rejected";
    case FragilityOutcome::not_monotone: return "not_monotone";
    case FragilityOutcome::too_little: break;
  }
  return "too_little";
}

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
  const double high = bounded.interval.high;
  return {{"value", bounded.value},
          {"interval", Json::array({bounded.interval.low, std::isfinite(high) ? Json(high) : Json()})}};
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
  if (shaking) json["shaking"] = shaking_json(*shaking);
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

Json curve_json(const RunFragility& run, const FragilityCurve& curve) {
  Json json = Json::object();
  json["title"] = run.experiment.title;
  json["sha256"] = base::to_hex(base::sha256(run.experiment.canonical_text));
  json["parameter"] = curve.parameter;
  Json& others = json["others"] = Json::object();
  for (const auto& [pointer, value] : curve.others) others[pointer] = Json::parse(value);
  json["confidence"] = curve.confidence;
  json["outcome"] = name_of(curve.fit.outcome);
  json["law"] = curve.fit.law ? law_json(curve) : Json();
  json["test"] = curve.test ? test_json(*curve.test) : Json();
  json["missed_levels"] = curve.fit.law ? Json(curve.missed_levels()) : Json();
  Json& levels = json["levels"] = Json::array();
  const auto shakings = shakings_of(run, curve);
  for (std::size_t i = 0; i < curve.levels.size(); ++i) levels.push_back(level_json(curve.levels[i], shakings[i]));
  return json;
}

/// `2.31 [2.20, 2.43]`.
std::string spoken(const stats::Bounded& bounded) {
  const double high = bounded.interval.high;
  return significant(bounded.value, 3) + " [" + significant(bounded.interval.low, 3) + ", " +
         (std::isfinite(high) ? significant(high, 3) : "unbounded") + ']';
}

/// `2.31 [2.20, 2.43]`; outside the levels `> 1.2 (extrapolated: 1.31 [1.24, 1.42])`.
std::string spoken_median(const FragilityCurve& curve) {
  const stats::Bounded median = curve.fit.law->median(curve.confidence);
  if (!curve.is_extrapolated(median.value)) return spoken(median);
  const bool is_above = curve.levels.back().intensity < median.value;
  const double nearest = is_above ? curve.levels.back().intensity : curve.levels.front().intensity;
  return (is_above ? "> " : "< ") + significant(nearest, 6) + " (extrapolated: " + spoken(median) + ')';
}

std::string spoken(const stats::LackOfFit& test) {
  return "lack of fit: deviance " + significant(test.deviance, 3) + ", p = " + significant(test.p_value, 2) + " (" +
         std::to_string(test.samples) + " bootstrap samples)\n";
}

std::string heading_of(const RunFragility& run, const FragilityCurve& curve) {
  std::string heading = run.experiment.title;
  for (const Parameter& parameter : curve.others) {
    heading += (heading.empty() ? "" : "; ") + parameter.pointer.substr(1) + ' ' + short_value(parameter);
  }
  return heading.empty() ? "" : heading + '\n';
}

TextRow row_of(const FragilityLevel& level) {
  TextRow row{significant(level.intensity, 6),
              std::to_string(level.overturned.trials),
              per_cent(level.estimate),
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
      {last_key(curve.parameter), "n", "overturned", "exact", is_isotonic ? "isotonic" : "fitted", "band"}};
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
    text +=
        "median " + spoken_median(curve) + ", dispersion " + spoken(curve.fit.law->dispersion(curve.confidence)) + '\n';
  } else {
    text += std::string(words_for(curve.fit.outcome)) + '\n';
  }
  if (curve.test) text += spoken(*curve.test);
  const std::size_t missed = curve.missed_levels();
  if (missed == 0) return text;
  return text + "* at " + std::to_string(missed) + " of " + std::to_string(curve.levels.size()) +
         " levels the fitted function lies outside the simultaneous exact interval: it does not describe these data\n";
}

bool has_isotonic(const std::vector<RunFragility>& runs) {
  return std::any_of(runs.begin(), runs.end(), [](const RunFragility& run) {
    return std::any_of(run.curves.begin(), run.curves.end(),
                       [](const FragilityCurve& curve) { return curve.fit.outcome == FragilityOutcome::rejected; });
  });
}

}  // namespace

std::string fragility_text(const std::vector<RunFragility>& runs) {
  Json json = Json::object();
  json["format"] = fragility_format;
  Json& curves = json["curves"] = Json::array();
  for (const RunFragility& run : runs) {
    for (const FragilityCurve& curve : run.curves) curves.push_back(curve_json(run, curve));
  }
  return json.dump(1) + '\n';
}

std::string fragility_table(const std::vector<RunFragility>& runs) {
  std::string text;
  for (const RunFragility& run : runs) {
    for (const FragilityCurve& curve : run.curves) text += heading_of(run, curve) + table_of(run, curve) + '\n';
  }
  return text +
         "per cent of n realisations [exact interval of each level alone]; fitted: lognormal function of maximum "
         "likelihood "
         "with its\nband; realisations with the same index use common random numbers at all levels; intervals treat "
         "them as one\ncluster\n" +
         (has_isotonic(runs) ? "isotonic: most likely probabilities that do not decrease; their band covers all levels "
                               "at once\n"
                             : "");
}

}  // namespace rocking
