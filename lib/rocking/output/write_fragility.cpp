#include "rocking/output/write_fragility.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/output/text_table.hpp"
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
      return "no function is fitted: the share of overturned realisations does not clearly increase with intensity";
    case FragilityOutcome::no_scatter:
      return "no function is fitted: the realisations overturn at the same levels, or differ in one way only, so the "
             "uncertainty "
             "cannot be estimated; make more parameters random, or add realisations and intensities";
    case FragilityOutcome::too_little: break;
  }
  return "no function is fitted: this requires two intensities, and two realisations with different random numbers";
}

Json bounded_json(const stats::Bounded& bounded) {
  return {{"value", bounded.value}, {"interval", interval_json(bounded.interval)}};
}

Json law_json(const LognormalFragility& law, double confidence) {
  Json json = Json::object();
  json["median"] = bounded_json(law.median(confidence));
  json["dispersion"] = bounded_json(law.dispersion(confidence));
  json["centre"] = law.centre;
  json["intercept"] = law.intercept;
  json["slope"] = law.slope;
  json["covariance"] = Json::array({law.covariance.aa, law.covariance.ab, law.covariance.bb});
  return json;
}

Json level_json(const FragilityLevel& level) {
  Json json = Json::object();
  json["intensity"] = level.intensity;
  json["realisations"] = level.overturned.trials;
  json["overturned"] = level.overturned.successes;
  json["estimate"] = level.estimate;
  json["exact"] = interval_json(level.exact);
  json["simultaneous"] = interval_json(level.simultaneous);
  json["fitted"] = level.fitted ? Json(level.fitted->value) : Json();
  json["band"] = level.fitted ? interval_json(level.fitted->band) : Json();
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
  json["law"] = curve.fit.law ? law_json(*curve.fit.law, curve.confidence) : Json();
  json["missed_levels"] = curve.fit.law ? Json(curve.missed_levels()) : Json();
  Json& levels = json["levels"] = Json::array();
  for (const FragilityLevel& level : curve.levels) levels.push_back(level_json(level));
  return json;
}

std::string spoken(const stats::Bounded& bounded) {
  return significant(bounded.value, 3) + " [" + significant(bounded.interval.low, 3) + ", " +
         significant(bounded.interval.high, 3) + ']';
}

std::string heading_of(const RunFragility& run, const FragilityCurve& curve) {
  std::string heading = run.experiment.title;
  for (const Parameter& parameter : curve.others) {
    heading += (heading.empty() ? "" : "; ") + parameter.pointer.substr(1) + ' ' + short_value(parameter);
  }
  return heading.empty() ? "" : heading + '\n';
}

std::string table_of(const FragilityCurve& curve) {
  std::vector<TextRow> rows{{last_key(curve.parameter), "n", "overturned", "exact", "fitted", "band"}};
  for (const FragilityLevel& level : curve.levels) {
    TextRow row{significant(level.intensity, 6),
                std::to_string(level.overturned.trials),
                per_cent(level.estimate),
                per_cent(level.exact),
                ".",
                "."};
    if (level.fitted) {
      row[4] = per_cent(level.fitted->value) + (level.fitted->is_missed ? " *" : "");
      row[5] = per_cent(level.fitted->band);
    }
    rows.push_back(std::move(row));
  }
  std::string text = aligned(rows);
  if (!curve.fit.law) return text + std::string(words_for(curve.fit.outcome)) + '\n';
  text += "median " + spoken(curve.fit.law->median(curve.confidence)) + ", dispersion " +
          spoken(curve.fit.law->dispersion(curve.confidence)) + '\n';
  const std::size_t missed = curve.missed_levels();
  if (missed == 0) return text;
  return text + "* at " + std::to_string(missed) + " of " + std::to_string(curve.levels.size()) +
         " levels the fitted function lies outside the simultaneous exact interval: it does not describe these data\n";
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
    for (const FragilityCurve& curve : run.curves) text += heading_of(run, curve) + table_of(curve) + '\n';
  }
  return text +
         "per cent of n realisations [exact interval of each level alone]; fitted: lognormal function of maximum "
         "likelihood "
         "with its\nband; realisations with the same index use common random numbers at all levels; intervals treat "
         "them as one\ncluster\n";
}

}  // namespace rocking
