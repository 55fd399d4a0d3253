#include "rocking/experiment/fragility.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "rocking/base/error.hpp"

namespace rocking::experiment {
namespace {

constexpr std::array<std::string_view, 2> intensities{"/excitation/amplitude", "/excitation/scale"};

double number_in(const std::string& json) {
  double number = 0.0;
  std::from_chars(json.data(), json.data() + json.size(), number);
  return number;
}

/// Which curve, and which level of it, a condition is.
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

bool are_equal(const std::vector<Parameter>& a, const std::vector<Parameter>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Parameter& x, const Parameter& y) { return x.value == y.value; });
}

/// For each condition, which of its realisations overturned. Throws InputError where one is missing.
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

}  // namespace

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
  const auto happened = overturned(experiment, store);
  for (std::size_t i = 0; i < happened.size(); ++i) {
    Place place = place_of(experiment.conditions[i], intensity);
    if (!(place.intensity > 0.0)) continue;
    auto curve = std::find_if(curves.begin(), curves.end(),
                              [&](const FragilityCurve& known) { return are_equal(known.others, place.others); });
    if (curve == curves.end()) {
      curves.push_back({.parameter = std::string(intensity),
                        .others = std::move(place.others),
                        .confidence = experiment.conditions[i].confidence,
                        .levels = {},
                        .fit = {}});
      curve = std::prev(curves.end());
    }
    curve->levels.push_back({.intensity = place.intensity, .happened = happened[i]});
  }
  for (FragilityCurve& curve : curves) {
    std::stable_sort(curve.levels.begin(), curve.levels.end(),
                     [](const auto& a, const auto& b) { return a.intensity < b.intensity; });
    curve.fit = stats::fit_lognormal(curve.levels);
  }
  return curves;
}

}  // namespace rocking::experiment
