#include "rocking/studies/fragility.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "rocking/base/error.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/stats/isotonic.hpp"

namespace rocking {
namespace {

constexpr std::array<std::string_view, 6> intensities{"/excitation/amplitude",      "/excitation/amplitude_g",
                                                      "/excitation/amplitude_m_s2", "/excitation/scale",
                                                      "/excitation/pga_g",          "/excitation/pgv_m_s"};

double number_in(const std::string& json) {
  double number = 0.0;
  std::from_chars(json.data(), json.data() + json.size(), number);
  return number;
}

/// The level and the curve to which a condition belongs.
struct Place {
  double intensity = 0.0;
  std::vector<Parameter> others;
};

Place place_of(const Condition& condition, std::string_view intensity) {
  Place place;
  for (const Parameter& parameter : condition.parameters) {
    if (parameter.pointer == intensity) {
      place.intensity = number_in(parameter.value);
    } else {
      place.others.push_back(parameter);
    }
  }
  return place;
}

/// A curve before its estimates are made.
struct Curve {
  std::vector<Parameter> others;
  double confidence;
  std::vector<stats::IntensityLevel> levels;
};

bool are_equal(const std::vector<Parameter>& a, const std::vector<Parameter>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Parameter& x, const Parameter& y) { return x.value == y.value; });
}

/// For each condition, which of its realisations overturned. Throws InputError if one is missing.
std::vector<std::vector<bool>> overturned(const Experiment& experiment, const Store& store) {
  std::vector<std::vector<bool>> happened;
  std::uint64_t missing = 0;
  for (const Condition& condition : experiment.conditions) {
    happened.emplace_back(is_random(condition.scene) ? condition.realisations : 1);
    missing += happened.back().size();
  }
  store.for_each([&](const RealisationKey& key, const Summary& summary) {
    if (key.condition >= happened.size() || key.realisation >= happened[key.condition].size()) return;
    happened[key.condition][key.realisation] = summary.mode.kind == section::ResponseKind::overturned;
    --missing;
  });
  if (missing > 0) {
    throw base::InputError({.place = "realisations.sqlite",
                            .value = "",
                            .reason = "lacks " + std::to_string(missing) + " realisations",
                            .remedy = "`rocking resume` finishes the run"});
  }
  return happened;
}

/// Conditions with a positive intensity by curve, in the order of the sweep.
std::vector<Curve> curves_of(const Experiment& experiment, const Store& store, std::string_view intensity) {
  std::vector<Curve> curves;
  const auto happened = overturned(experiment, store);
  for (std::size_t i = 0; i < happened.size(); ++i) {
    Place place = place_of(experiment.conditions[i], intensity);
    if (!(place.intensity > 0.0)) continue;
    auto curve = std::find_if(curves.begin(), curves.end(),
                              [&](const Curve& known) { return are_equal(known.others, place.others); });
    if (curve == curves.end()) {
      curves.push_back({std::move(place.others), experiment.conditions[i].confidence, {}});
      curve = std::prev(curves.end());
    }
    curve->levels.push_back({.intensity = place.intensity, .happened = happened[i]});
  }
  return curves;
}

FragilityLevel level_of(const stats::IntensityLevel& data, const FragilityCurve& curve, std::size_t levels) {
  FragilityLevel level;
  level.intensity = data.intensity;
  level.overturned = stats::proportion_at(data);
  level.estimate = static_cast<double>(level.overturned.successes) / static_cast<double>(level.overturned.trials);
  level.exact = stats::clopper_pearson(level.overturned, curve.confidence);
  level.simultaneous = stats::bonferroni_clopper_pearson(level.overturned, curve.confidence, levels);
  if (!curve.fit.law) return level;
  FittedProbability& fitted = level.fitted.emplace();
  fitted.value = curve.fit.law->probability(level.intensity);
  fitted.band = curve.fit.law->band(level.intensity, curve.confidence);
  fitted.is_missed = fitted.value < level.simultaneous.low || fitted.value > level.simultaneous.high;
  return level;
}

stats::BootstrapNumbers bootstrap_numbers(std::uint64_t seed) {
  return [seed](std::uint64_t sample, std::uint64_t number) {
    const random::Draws draws(seed, sample);
    return std::array{draws.uniform(random::Source::fragility_bootstrap, 2 * number),
                      draws.uniform(random::Source::fragility_bootstrap, 2 * number + 1)};
  };
}

void reject(FragilityCurve& curve, stats::FragilityOutcome outcome) {
  curve.fit = {.outcome = outcome, .law = std::nullopt};
}

/// Tests the fitted function, and removes it if it is rejected.
void test_fit(const std::vector<stats::IntensityLevel>& levels, std::uint64_t seed, FragilityCurve& curve) {
  if (!curve.fit.law) return;
  curve.test = stats::lack_of_fit(levels, *curve.fit.law, fragility_samples, bootstrap_numbers(seed));
  std::vector<stats::Proportion> counts;
  for (const stats::IntensityLevel& level : levels) counts.push_back(stats::proportion_at(level));
  if (!stats::isotonic_band(counts, curve.confidence)) {
    reject(curve, stats::FragilityOutcome::not_monotone);
  } else if (curve.test->p_value <= fragility_significance) {
    reject(curve, stats::FragilityOutcome::rejected);
  }
}

/// Gives the levels of a curve whose function was rejected their isotonic estimates. Where pooling moves an estimate
/// out of the intervals of probabilities that do not decrease, the nearest end is the estimate.
void set_isotonic(FragilityCurve& curve) {
  if (curve.fit.outcome != stats::FragilityOutcome::rejected) return;
  std::vector<stats::Proportion> counts;
  for (const FragilityLevel& level : curve.levels) counts.push_back(level.overturned);
  const std::vector<double> values = stats::isotonic_regression(counts);
  const std::vector<stats::Interval> band = stats::isotonic_band(counts, curve.confidence).value();
  for (std::size_t i = 0; i < values.size(); ++i) {
    curve.levels[i].isotonic = std::clamp(values[i], band[i].low, band[i].high);
  }
}

}  // namespace

std::size_t FragilityCurve::missed_levels() const {
  return static_cast<std::size_t>(std::ranges::count_if(
      levels, [](const FragilityLevel& level) { return level.fitted && level.fitted->is_missed; }));
}

bool FragilityCurve::is_extrapolated(double intensity) const {
  return intensity < levels.front().intensity || levels.back().intensity < intensity;
}

FragilityCurve fragility_curve(const std::vector<stats::IntensityLevel>& levels, double confidence,
                               std::uint64_t seed) {
  FragilityCurve curve;
  curve.confidence = confidence;
  curve.fit = stats::fit_lognormal(levels, confidence);
  test_fit(levels, seed, curve);
  for (const stats::IntensityLevel& level : levels) curve.levels.push_back(level_of(level, curve, levels.size()));
  set_isotonic(curve);
  return curve;
}

std::string_view intensity_of(const Experiment& experiment) {
  for (const Parameter& parameter : experiment.conditions.front().parameters) {
    const auto found = std::find(intensities.begin(), intensities.end(), parameter.pointer);
    if (found != intensities.end()) return *found;
  }
  return {};
}

std::vector<FragilityCurve> fragility(const Experiment& experiment, const Store& store) {
  const std::string_view intensity = intensity_of(experiment);
  ROCKING_EXPECT(!intensity.empty());
  std::vector<FragilityCurve> curves;
  for (Curve& found : curves_of(experiment, store, intensity)) {
    std::ranges::stable_sort(found.levels, {}, &stats::IntensityLevel::intensity);
    FragilityCurve& curve = curves.emplace_back(fragility_curve(found.levels, found.confidence, experiment.seed));
    curve.parameter = intensity;
    curve.others = std::move(found.others);
  }
  return curves;
}

}  // namespace rocking
