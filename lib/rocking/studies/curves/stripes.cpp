#include "rocking/studies/curves/stripes.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
#include <variant>

#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/plan/plan.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/scene/intensity_measures.hpp"
#include "rocking/store/store.hpp"
#include "rocking/studies/curves/curves.hpp"

namespace rocking {
namespace {

/// The stripe and the group to which a condition belongs.
struct Place {
  double intensity = 0.0;
  std::string record;
  std::vector<Parameter> others;
};

Place place_of(const Condition& condition, std::string_view intensity) {
  Place place;
  for (const Parameter& parameter : condition.parameters) {
    if (parameter.pointer == intensity) {
      place.intensity = number_in(parameter.value).value_or(0.0);
    } else if (parameter.pointer == record_pointer) {
      place.record = record_of(condition.scene);
    } else {
      place.others.push_back(parameter);
    }
  }
  if (intensity == level_pointer) {
    place.intensity = selected_level(condition.scene).value_or(0.0);
    place.record += ", level " + base::shortest(place.intensity);
  }
  return place;
}

/// By the names of the records, so that the random numbers of a bootstrap do not depend on the order of a list of files, and
/// those of a record by growing intensity.
void sort(std::vector<Stripe>& stripes) {
  std::ranges::stable_sort(stripes, {}, [](const Stripe& each) { return std::tie(each.record, each.intensity); });
}

/// Spectral accelerations over g of ground motions at scale 1; each is computed once.
class Spectra {
 public:
  double at(const GroundMotion& motion, double period) {
    const auto [found, is_new] = known_.try_emplace({&motion, period, 0.0}, 0.0);
    if (is_new) found->second = spectral_acceleration(motion.samples, period, OscillatorAcceleration::pseudo);
    return found->second;
  }
  double average(const GroundMotion& motion, double first, double last) {
    const auto [found, is_new] = known_.try_emplace({&motion, first, last}, 0.0);
    if (is_new) found->second = average_spectral_acceleration(motion.samples, first, last);
    return found->second;
  }

 private:
  std::map<std::tuple<const GroundMotion*, double, double>, double> known_;
};

/// Measures of a motion that does not change with the realisation.
void set_measures(const Scene& scene, std::string_view intensity, Spectra& spectra, Stripe& stripe) {
  const auto* recorded = std::get_if<Recorded>(&scene.excitation);
  if (recorded == nullptr || !recorded->ground_motion || is_drawn(recorded->scale)) return;
  const double scale = mean_of(recorded->scale);
  const dynamics::Block block = mean_block(scene);
  const dynamics::Geometry shape = dynamics::geometry_of(block);
  const double pga = scale * peak_acceleration(recorded->ground_motion->samples);
  const double pgv = scale * peak_velocity(recorded->ground_motion->samples, block.gravity);
  const GroundMotion& motion = *recorded->ground_motion;
  stripe.pgv_over_pga =
      peak_velocity(motion.samples, block.gravity) / (peak_acceleration(motion.samples) * block.gravity);
  const double own = 2.0 * std::numbers::pi / shape.frequency_parameter;
  const std::vector<double>& periods = recorded->measure_periods;
  const bool has_range = periods.size() == 2;
  stripe.measures = {pga,
                     pgv,
                     scale * spectra.at(motion, own),
                     periods.size() == 1 && periods.front() != own
                         ? std::optional(scale * spectra.at(motion, periods.front()))
                         : std::nullopt,
                     scale * spectra.average(motion, has_range ? periods[0] : 0.1 * own, has_range ? periods[1] : own),
                     intensity == "/excitation/sa_absolute_g" ? std::optional(stripe.intensity) : std::nullopt};
}

/// The outcomes of all conditions. Throws InputError if the store lacks a realisation.
std::vector<Stripe> filled(const Experiment& experiment, const Store& store, unsigned threads) {
  std::vector<Stripe> stripes(experiment.conditions.size());
  std::atomic<std::uint64_t> missing = 0;
  for (std::size_t i = 0; i < stripes.size(); ++i) {
    const std::uint64_t realisations = effective_realisations(experiment.conditions[i]);
    stripes[i].overturned.resize(realisations);
    stripes[i].peaks.resize(realisations);
    stripes[i].without_answer.resize(realisations);
    missing += realisations;
  }
  store.for_each_side_by_side({.threads = threads}, [&](const RealisationKey& key, const Summary& summary) {
    Stripe& stripe = stripes.at(key.condition);
    if (key.realisation >= stripe.overturned.size()) return;
    stripe.overturned[key.realisation] = summary.mode.kind == section::ResponseKind::overturned;
    stripe.peaks[key.realisation] = summary.peaks;
    stripe.without_answer[key.realisation] = summary.has_no_answer();
    --missing;
  });
  if (missing > 0) {
    throw base::InputError({"realisations.sqlite", "", "lacks " + std::to_string(missing) + " realisations",
                            "`rocking resume` finishes the run"});
  }
  return stripes;
}

}  // namespace

std::string record_of(const Scene& scene) {
  const auto* recorded = std::get_if<Recorded>(&scene.excitation);
  if (recorded == nullptr || !recorded->ground_motion) return "";
  const GroundMotion& motion = *recorded->ground_motion;
  return motion.components.empty() ? motion.name : motion.name + ", " + motion.component;
}

bool have_equal_values(const std::vector<Parameter>& a, const std::vector<Parameter>& b) {
  return std::ranges::equal(a, b, {}, &Parameter::value, &Parameter::value);
}

std::vector<std::span<const Stripe>> StripeGroup::by_record() const {
  std::vector<std::span<const Stripe>> records;
  for (auto begin = stripes.begin(); begin != stripes.end();) {
    const auto end =
        std::find_if(begin, stripes.end(), [&](const Stripe& other) { return other.record != begin->record; });
    records.emplace_back(begin, end);
    begin = end;
  }
  return records;
}

std::optional<double> StripeGroup::least_uplift(const ResponseEvent& event) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Stripe& stripe : stripes) {
    const std::optional<double>& of_stripe = event.is_of_slip() ? stripe.sliding : stripe.uplift;
    if (!of_stripe) return std::nullopt;
    least = std::min(least, *of_stripe);
  }
  return std::isinf(least) ? std::nullopt : std::optional(least);
}

CurveSubject subject_of(const StripeGroup& group, const ResponseEvent& event) {
  return {.parameter = group.parameter,
          .others = group.others,
          .confidence = group.confidence,
          .event = event,
          .least_uplift = group.least_uplift(event),
          .balance = event.name == EventName::tilt ? group.balance : std::nullopt};
}

stats::IntensityLevel level_of(const Stripe& stripe, const ResponseEvent& event) {
  stats::IntensityLevel level{.intensity = stripe.intensity, .happened = stripe.overturned};
  for (std::size_t j = 0; j < level.happened.size() && !event.is_overturning(); ++j) {
    const bool is_known = event.name != EventName::displacement || !stripe.has_no_answer(j);
    level.happened[j] = level.happened[j] || (is_known && event.is_exceeded(stripe.peaks[j]));
  }
  for (std::size_t j = 0; j < stripe.without_answer.size(); ++j) {
    level.unresolved += stripe.without_answer[j] && !level.happened[j] ? 1 : 0;
  }
  return level;
}

std::vector<StripeGroup> stripes_of(const Experiment& experiment, const Store& store, unsigned threads) {
  const std::string_view intensity = intensity_of(experiment);
  ROCKING_EXPECT(!intensity.empty());
  std::vector<StripeGroup> groups;
  std::vector<Stripe> stripes = filled(experiment, store, threads);
  Spectra spectra;
  for (std::size_t i = 0; i < stripes.size(); ++i) {
    Place place = place_of(experiment.conditions[i], intensity);
    if (!(place.intensity > 0.0)) continue;
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const StripeGroup& known) { return have_equal_values(known.others, place.others); });
    if (group == groups.end()) {
      groups.push_back({.parameter = std::string(intensity),
                        .others = std::move(place.others),
                        .confidence = experiment.conditions[i].confidence,
                        .stripes = {}});
      group = std::prev(groups.end());
    }
    stripes[i].record = std::move(place.record);
    stripes[i].intensity = place.intensity;
    stripes[i].shaking = shaking_of(experiment.conditions[i].scene);
    // Another level has other records: this one says nothing of it.
    if (intensity != level_pointer) {
      stripes[i].uplift = least_uplift(experiment.conditions[i].scene, place.intensity);
      stripes[i].sliding = least_sliding(experiment.conditions[i].scene, place.intensity);
    }
    group->balance = joined(group->balance, balance_of(experiment.conditions[i].scene));
    set_measures(experiment.conditions[i].scene, intensity, spectra, stripes[i]);
    group->stripes.push_back(std::move(stripes[i]));
  }
  for (StripeGroup& group : groups) sort(group.stripes);
  return groups;
}

}  // namespace rocking
