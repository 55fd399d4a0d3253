#include "rocking/report/result_json.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "rocking/base/error.hpp"

namespace rocking::report {
namespace {

using experiment::ConditionResult;

Json number(double value) {
  ROCKING_EXPECT(std::isfinite(value));
  return value;
}

Json optional_number(const std::optional<double>& value) { return value ? number(*value) : Json(); }

}  // namespace

Json interval_json(const stats::Interval& interval) {
  return Json::array({number(interval.low), number(interval.high)});
}

Json parameters_json(const experiment::Condition& condition) {
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

Json corrected_json(const experiment::Corrected& corrected) {
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

Json parting_json(const experiment::PartingTimes& times) {
  Json parting = Json::object();
  parting["pairs"] = times.pairs;
  parting["parted"] = times.parted;
  parting["quartiles_periods"] = Json::array(
      {optional_number(times.lower_quartile), optional_number(times.median), optional_number(times.upper_quartile)});
  return parting;
}

Json non_recurrence_json(const ConditionResult& result) {
  if (!result.non_recurrence) return {};
  const experiment::NonRecurrence& found = *result.non_recurrence;
  Json json = Json::object();
  json["differ"] = number(found.differ);
  json["differ_interval"] = interval_json(found.differ_interval);
  json["entropy_nat"] = number(found.entropy);
  json["parting_by_friction"] = parting_json(found.friction);
  json["parting_by_arithmetic"] = parting_json(found.arithmetic);
  json["arithmetic_tolerance"] = number(found.arithmetic_tolerance);
  json["arithmetic_flips"] = {{"count", found.arithmetic_flips.successes},
                              {"of", found.arithmetic_flips.trials},
                              {"interval", interval_json(found.arithmetic_flips_interval)}};
  return json;
}

Json clamps_json(const experiment::Clamps& clamps) {
  Json json = Json::object();
  json["kinetic_friction_at_zero"] = clamps.kinetic_at_zero;
  json["kinetic_friction_at_static"] = clamps.kinetic_at_static;
  json["static_friction_at_zero"] = clamps.static_at_zero;
  json["restitution"] = clamps.restitution;
  json["amplitude_at_zero"] = clamps.amplitude_at_zero;
  return json;
}

Json validity_json(const experiment::Validity& validity) {
  Json json = Json::object();
  Json first = Json::object();
  const auto add = [&first](Json& counts, const std::string& name, const experiment::Cases& cases) {
    counts[name] = cases.count;
    if (cases.count > 0) first[name] = cases.first;
  };
  add(json, "left_ground", validity.left_ground);
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
  json["first_realisations"] = std::move(first);
  return json;
}

}  // namespace

Json condition_json(const experiment::Condition& condition, const ConditionResult& result) {
  Json json = Json::object();
  json["parameters"] = parameters_json(condition);
  json["realisations"] = result.realisations;
  json["counts"] = counts_json(result);
  json["probabilities"] = probabilities_json(result);
  json["non_recurrence"] = non_recurrence_json(result);
  json["validity"] = validity_json(result.validity);
  json["stopped_because"] = to_string(result.stopped_because);
  return json;
}

Json noise_floor_json(const std::optional<experiment::NoiseFloor>& floor) {
  if (!floor) return {};
  Json json = Json::object();
  json["flips"] = floor->flips.successes;
  json["of"] = floor->flips.trials;
  json["interval"] = interval_json(floor->interval);
  json["half_width"] = number(floor->half_width);
  json["arithmetic_noise"] = to_string(floor->noise);
  return json;
}

Json effort_json(const experiment::Effort& effort, const experiment::Clamps& clamps) {
  Json json = Json::object();
  json["steps"] = effort.steps;
  json["slip_steps"] = effort.slip_steps;
  json["root_isolations"] = effort.root_isolations;
  json["record_segments"] = effort.record_segments;
  json["companion_periods"] = effort.companion_periods;
  Json& draws = json["draws"] = Json::object();
  draws["static_friction"] = effort.static_friction_draws;
  draws["kinetic_friction"] = effort.kinetic_friction_draws;
  draws["restitution"] = effort.restitution_draws;
  draws["amplitude"] = effort.amplitude_draws;
  draws["initial"] = effort.initial_draws;
  json["clamped_draws"] = clamps_json(clamps);
  Json& events = json["events"] = Json::object();
  for (std::size_t kind = 0; kind < effort.events.size(); ++kind) {
    events[std::string(to_string(static_cast<dynamics::EventKind>(kind)))] = effort.events[kind];
  }
  return json;
}

}  // namespace rocking::report
