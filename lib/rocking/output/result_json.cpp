#include "rocking/output/result_json.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "rocking/base/error.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/scene/shaking.hpp"

namespace rocking {
namespace {

Json number(double value) {
  ROCKING_EXPECT(std::isfinite(value));
  return value;
}

Json optional_number(const std::optional<double>& value) { return value ? number(*value) : Json(); }

}  // namespace

Json interval_json(const stats::Interval& interval) {
  return Json::array({number(interval.low), number(interval.high)});
}

Json parameters_json(const Condition& condition) {
  Json parameters = Json::object();
  for (const auto& [pointer, value] : condition.parameters) parameters[pointer] = Json::parse(value);
  return parameters;
}

namespace {

Json counts_json(const ConditionResult& result) {
  Json counts = Json::object();
  for (const auto& [mode, probability] : result.modes) counts[to_string(mode)] = probability.counts.successes;
  return counts;
}

Json corrected_json(const Corrected& corrected) {
  Json json = Json::object();
  json["checked"] = corrected.counts.checked;
  json["gained"] = corrected.counts.gained;
  json["lost"] = corrected.counts.lost;
  json["estimate"] = number(corrected.estimate);
  json["interval"] = interval_json(corrected.interval);
  return json;
}

Json probabilities_json(const ConditionResult& result) {
  Json probabilities = Json::object();
  for (const auto& [mode, probability] : result.modes) {
    Json& entry = probabilities[to_string(mode)];
    entry["estimate"] = number(probability.estimate);
    entry["wilson"] = interval_json(probability.wilson);
    entry["jeffreys"] = interval_json(probability.jeffreys);
    entry["clopper_pearson"] = interval_json(probability.clopper_pearson);
    entry["simultaneous"] = interval_json(probability.simultaneous);
    entry["simultaneous_goodman"] = interval_json(probability.goodman);
    entry["simultaneous_sison_glaz"] = probability.sison_glaz ? interval_json(*probability.sison_glaz) : Json();
    if (probability.corrected) entry["corrected"] = corrected_json(*probability.corrected);
    if (probability.anytime) entry["anytime"] = interval_json(*probability.anytime);
  }
  return probabilities;
}

Json divergence_json(const DivergenceTimes& times) {
  Json divergence = Json::object();
  divergence["pairs"] = times.pairs;
  divergence["diverged"] = times.diverged;
  divergence["quartiles_periods"] = Json::array(
      {optional_number(times.lower_quartile), optional_number(times.median), optional_number(times.upper_quartile)});
  return divergence;
}

Json non_recurrence_json(const ConditionResult& result) {
  if (!result.non_recurrence) return {};
  const NonRecurrence& found = *result.non_recurrence;
  Json json = Json::object();
  json["differ"] = number(found.differ);
  json["differ_interval"] = interval_json(found.differ_interval);
  json["entropy_nat"] = number(found.entropy);
  json["divergence_by_friction"] = divergence_json(found.friction);
  json["divergence_by_tolerance"] = divergence_json(found.arithmetic);
  json["arithmetic_tolerance"] = number(found.arithmetic_tolerance);
  json["arithmetic_flips"] = {{"count", found.arithmetic_flips.successes},
                              {"of", found.arithmetic_flips.trials},
                              {"interval", interval_json(found.arithmetic_flips_interval)}};
  return json;
}

Json quantiles_json(const std::vector<stats::QuantileEstimate>& levels) {
  Json json = Json::array();
  for (const stats::QuantileEstimate& quantile : levels) {
    json.push_back(Json::array({number(quantile.level), optional_number(quantile.value), optional_number(quantile.low),
                                optional_number(quantile.high)}));
  }
  return json;
}

Json quantiles_json(const Quantiles& quantiles) {
  Json json = Json::object();
  json["realisations"] = quantiles.realisations;
  json["beyond"] = quantiles.beyond;
  json["quantiles"] = quantiles_json(quantiles.levels);
  return json;
}

Json slip_json(const std::optional<PeakQuantiles::Slip>& slip) {
  if (!slip) return {};
  Json json = quantiles_json(slip->over_half_diagonal);
  json["quantiles_m"] = quantiles_json(slip->metres.levels);
  return json;
}

void add_peaks(Json& json, const std::optional<PeakQuantiles>& peaks) {
  json["peak_tilt"] = peaks ? quantiles_json(peaks->tilt) : Json();
  json["peak_tilt_rate"] = peaks ? quantiles_json(peaks->tilt_rate) : Json();
  json["peak_slip"] = peaks ? slip_json(peaks->slip) : Json();
  json["final_slip"] = peaks ? slip_json(peaks->final_slip) : Json();
}

Json curve_json(const std::vector<stats::Incidence>& curve) {
  Json json = Json::object();
  for (const char* key : {"periods", "estimate", "variance", "pointwise", "simultaneous"}) json[key] = Json::array();
  for (const stats::Incidence& point : curve) {
    json["periods"].push_back(point.time);
    json["estimate"].push_back(number(point.estimate));
    json["variance"].push_back(number(point.variance));
    json["pointwise"].push_back(interval_json(point.pointwise));
    json["simultaneous"].push_back(interval_json(point.simultaneous));
  }
  return json;
}

Json long_run_shares_json(const LongRuns& runs) {
  Json json = Json::object();
  json["realisations"] = runs.count;
  json["windows"] = runs.windows;
  Json& modes = json["modes"] = Json::object();
  for (const auto& [mode, share] : runs.shares) {
    Json& entry = modes[to_string(mode)] = Json::object();
    entry["share"] = number(share.share);
    entry["interval"] = interval_json(share.interval);
  }
  return json;
}

/// By which period all but one per cent have settled.
Json nearly_all_json(const stats::TimeToShare& found) {
  const auto whole = [](const std::optional<std::int64_t>& period) { return period ? Json(*period) : Json(); };
  Json json = Json::object();
  json["unsettled"] = number(ResponseTimes::tolerable_share);
  json["basis"] = found.is_observed ? "observed" : found.time ? "extrapolated" : "unknown";
  json["periods"] = whole(found.time);
  json["interval"] = Json::array({whole(found.low), whole(found.high)});
  json["settled_in_the_last_half"] = found.events;
  return json;
}

Json incidence_json(const SettlingResult& settling, const ResponseTimes& times) {
  Json json = Json::object();
  json["censored"] = settling.censored;
  json["settling_periods"] = quantiles_json(times.quartiles);
  json["nearly_all"] = nearly_all_json(times.nearly_all);
  json["any_mode"] = curve_json(times.any_mode);
  Json& modes = json["modes"] = Json::object();
  for (const auto& [mode, curve] : settling.incidence) modes[to_string(mode)] = curve_json(curve);
  Json& before = json["at_horizon"] = Json::object();
  before["counts"] = Json::object();
  for (const auto& [mode, count] : settling.at_horizon) before["counts"][to_string(mode)] = count;
  before["differ"] = optional_number(settling.differ);
  before["differ_interval"] = settling.differ ? interval_json(settling.differ_interval) : Json();
  json["divergence_by_friction"] = curve_json(settling.divergence);
  json["divergence_periods"] = quantiles_json(times.divergence_quartiles);
  Json& leaving = json["leaving"] = Json::object();
  for (const auto& [mode, found] : settling.leaving) {
    Json& entry = leaving[to_string(mode)] = Json::object();
    entry["left"] = found.left;
    entry["watched_periods"] = found.watched_periods;
    entry["per_1000_periods"] =
        number(1000.0 * static_cast<double>(found.left) / static_cast<double>(found.watched_periods));
    entry["interval"] = interval_json(found.per_1000_periods);
  }
  if (settling.long_runs) json["long_run_shares"] = long_run_shares_json(*settling.long_runs);
  return json;
}

Json clamps_json(const Clamps& clamps) {
  Json json = Json::object();
  for (const ClampKind& kind : clamp_kinds) {
    const std::uint64_t count = clamps.*kind.count;
    if (kind.in_every_report || count > 0) json[std::string(kind.key)] = count;
  }
  return json;
}

Json validity_json(const Validity& validity, const OperationCounts& operations) {
  Json json = Json::object();
  Json first = Json::object();
  const auto add = [&first](Json& counts, const std::string& name, const Cases& cases) {
    counts[name] = cases.count;
    if (cases.count > 0) first[name] = cases.first;
  };
  add(json, "left_ground", validity.left_ground);
  add(json, "left_ground_before_fall", validity.left_ground_before_fall);
  add(json, "painleve", validity.painleve);
  add(json, "stopped", validity.stopped);
  add(json, "in_transient", validity.in_transient);
  add(json, "settled_late", validity.settled_late);
  json["least_held"] = validity.least_held;
  add(json, "past_balance", validity.past_balance);
  add(json, "contradictions", validity.contradictions);
  add(json, "clamped", validity.clamped);
  Json& unresolved = json["unresolved"] = Json::object();
  for (const auto& [reason, cases] : validity.unresolved) add(unresolved, std::string(to_string(reason)), cases);
  json["clamped_draws"] = clamps_json(validity.clamps);
  json["draws"] = operations.draws();
  json["first_realisations"] = std::move(first);
  return json;
}

}  // namespace

Json condition_json(const Condition& condition, const ConditionResult& result) {
  Json json = Json::object();
  json["parameters"] = parameters_json(condition);
  if (const auto shaking = shaking_of(condition.scene)) json["shaking"] = shaking_json(*shaking);
  json["realisations"] = result.realisations;
  json["counts"] = counts_json(result);
  json["probabilities"] = probabilities_json(result);
  json["non_recurrence"] = non_recurrence_json(result);
  if (result.settling && result.response_times) {
    json["incidence"] = incidence_json(*result.settling, *result.response_times);
  }
  add_peaks(json, result.peaks);
  json["validity"] = validity_json(result.validity, result.operations);
  json["stopped_because"] = to_string(result.stopped_because);
  return json;
}

Json tolerance_sensitivity_json(const std::optional<ToleranceSensitivity>& floor) {
  if (!floor) return {};
  Json json = Json::object();
  json["flips"] = floor->flips.successes;
  json["of"] = floor->flips.trials;
  json["interval"] = interval_json(floor->interval);
  json["half_width"] = number(floor->half_width);
  json["arithmetic_noise"] = to_string(floor->noise);
  return json;
}

Json operation_counts_json(const OperationCounts& operations, const Clamps& clamps) {
  Json json = Json::object();
  json["steps"] = operations.steps;
  json["slip_steps"] = operations.slip_steps;
  json["root_isolations"] = operations.root_isolations;
  json["ground_motion_segments"] = operations.ground_motion_segments;
  json["exponent_periods"] = operations.perturbed_pair_periods;
  Json& draws = json["draws"] = Json::object();
  draws["static_friction"] = operations.static_friction_draws;
  draws["kinetic_friction"] = operations.kinetic_friction_draws;
  draws["restitution"] = operations.restitution_draws;
  draws["amplitude"] = operations.amplitude_draws;
  draws["initial"] = operations.initial_draws;
  json["clamped_draws"] = clamps_json(clamps);
  Json& events = json["events"] = Json::object();
  for (std::size_t kind = 0; kind < operations.events.size(); ++kind) {
    events[std::string(to_string(static_cast<dynamics::EventKind>(kind)))] = operations.events[kind];
  }
  return json;
}

}  // namespace rocking
