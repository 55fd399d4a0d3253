#include "rocking/report/write_fragility.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/report/json.hpp"
#include "rocking/report/mode_table.hpp"
#include "rocking/report/result_json.hpp"
#include "rocking/report/text_table.hpp"

namespace rocking::report {
namespace {

using experiment::FragilityCurve;
using stats::FragilityOutcome;
using stats::Interval;
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

/// What stands in the place of a fit.
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

/// A level as it is told: counts, their intervals, and what the law says there.
struct LevelView {
  double intensity = 0.0;
  stats::Proportion overturned;
  Interval exact, simultaneous;
  double fitted = 0.0;
  Interval band;
  bool is_missed = false;  ///< the law lies outside the simultaneous interval
};

std::vector<LevelView> views_of(const FragilityCurve& curve) {
  std::vector<LevelView> views;
  for (const stats::IntensityLevel& level : curve.levels) {
    LevelView view;
    view.intensity = level.intensity;
    view.overturned = stats::proportion_at(level);
    view.exact = stats::clopper_pearson(view.overturned, curve.confidence);
    view.simultaneous = stats::bonferroni_clopper_pearson(view.overturned, curve.confidence, curve.levels.size());
    if (curve.fit.law) {
      view.fitted = curve.fit.law->probability(level.intensity);
      view.band = curve.fit.law->band(level.intensity, curve.confidence);
      view.is_missed = view.fitted < view.simultaneous.low || view.fitted > view.simultaneous.high;
    }
    views.push_back(view);
  }
  return views;
}

double estimate_of(const stats::Proportion& proportion) {
  return static_cast<double>(proportion.successes) / static_cast<double>(proportion.trials);
}

std::size_t missed(const std::vector<LevelView>& views) {
  std::size_t count = 0;
  for (const LevelView& view : views) count += view.is_missed ? 1 : 0;
  return count;
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

Json level_json(const LevelView& view, bool has_law) {
  Json json = Json::object();
  json["intensity"] = view.intensity;
  json["realisations"] = view.overturned.trials;
  json["overturned"] = view.overturned.successes;
  json["estimate"] = estimate_of(view.overturned);
  json["exact"] = interval_json(view.exact);
  json["simultaneous"] = interval_json(view.simultaneous);
  json["fitted"] = has_law ? Json(view.fitted) : Json();
  json["band"] = has_law ? interval_json(view.band) : Json();
  return json;
}

Json curve_json(const RunFragility& run, const FragilityCurve& curve) {
  const auto views = views_of(curve);
  Json json = Json::object();
  json["title"] = run.experiment.title;
  json["sha256"] = base::to_hex(base::sha256(run.experiment.canonical_text));
  json["parameter"] = curve.parameter;
  Json& others = json["others"] = Json::object();
  for (const auto& [pointer, value] : curve.others) others[pointer] = Json::parse(value);
  json["confidence"] = curve.confidence;
  json["outcome"] = name_of(curve.fit.outcome);
  json["law"] = curve.fit.law ? law_json(*curve.fit.law, curve.confidence) : Json();
  json["missed_levels"] = curve.fit.law ? Json(missed(views)) : Json();
  Json& levels = json["levels"] = Json::array();
  for (const LevelView& view : views) levels.push_back(level_json(view, curve.fit.law.has_value()));
  return json;
}

std::string spoken(const stats::Bounded& bounded) {
  return significant(bounded.value, 3) + " [" + significant(bounded.interval.low, 3) + ", " +
         significant(bounded.interval.high, 3) + ']';
}

std::string heading_of(const RunFragility& run, const FragilityCurve& curve) {
  std::string heading = run.experiment.title;
  for (const experiment::Parameter& parameter : curve.others) {
    heading += (heading.empty() ? "" : "; ") + parameter.pointer.substr(1) + ' ' + short_value(parameter);
  }
  return heading.empty() ? "" : heading + '\n';
}

std::string table_of(const FragilityCurve& curve) {
  const auto views = views_of(curve);
  std::vector<TextRow> rows{
      {curve.parameter.substr(curve.parameter.rfind('/') + 1), "n", "overturned", "exact", "fitted", "band"}};
  for (const LevelView& view : views) {
    TextRow row{significant(view.intensity, 6),
                std::to_string(view.overturned.trials),
                per_cent(estimate_of(view.overturned)),
                per_cent(view.exact),
                ".",
                "."};
    if (curve.fit.law) {
      row[4] = per_cent(view.fitted) + (view.is_missed ? " *" : "");
      row[5] = per_cent(view.band);
    }
    rows.push_back(std::move(row));
  }
  std::string text = aligned(rows);
  if (!curve.fit.law) return text + std::string(words_for(curve.fit.outcome)) + '\n';
  text += "median " + spoken(curve.fit.law->median(curve.confidence)) + ", dispersion " +
          spoken(curve.fit.law->dispersion(curve.confidence)) + '\n';
  if (missed(views) == 0) return text;
  return text + "* at " + std::to_string(missed(views)) + " of " + std::to_string(views.size()) +
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

}  // namespace rocking::report
