#include "rocking/output/report.hpp"

#include <algorithm>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/ensemble/mode_family.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/output/check_reported_counts.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {

namespace {

std::vector<std::string> pointers_of(const std::vector<Parameter>& parameters) {
  std::vector<std::string> pointers;
  for (const Parameter& parameter : parameters) pointers.push_back(parameter.pointer);
  return pointers;
}

}  // namespace

std::optional<double> Report::number(const std::string& pointer, const ReportedCondition& condition) const {
  Json value;
  const Json::json_pointer place(pointer);
  if (input.experiment.contains(place)) value = input.experiment.at(place);
  for (const Parameter& parameter : condition.parameters) {
    if (parameter.pointer == pointer) value = value_of(parameter);
    if (!pointer.starts_with(parameter.pointer + '/')) continue;
    const Json whole = value_of(parameter);
    const Json::json_pointer within(pointer.substr(parameter.pointer.size()));
    value = whole.contains(within) ? whole.at(within) : Json();
  }
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

std::optional<std::uint64_t> Report::periods() const {
  static const Json::json_pointer transient("/horizon/transient_periods");
  static const Json::json_pointer sampled("/horizon/sampled_periods");
  const Json& experiment = input.experiment;
  if (!experiment.contains(transient) || !experiment.contains(sampled)) return std::nullopt;
  return experiment.at(transient).get<std::uint64_t>() + experiment.at(sampled).get<std::uint64_t>();
}

std::string Report::level() const {
  const double first = conditions.front().confidence;
  const bool differs = std::ranges::any_of(conditions, [first](const auto& each) { return each.confidence != first; });
  return differs ? "each condition's own confidence" : level_text(first) + " %";
}

std::map<section::ResponseMode, std::uint64_t> Report::occurring() const {
  std::map<section::ResponseMode, std::uint64_t> found;
  for (const ReportedCondition& condition : conditions) {
    for (const auto& [mode, probability] : condition.result.modes) {
      if (probability.counts.successes > 0) found[mode] += probability.counts.successes;
    }
  }
  return found;
}

std::set<section::ResponseMode> Report::listed() const {
  std::set<section::ResponseMode> modes;
  for (const ReportedCondition& condition : conditions) {
    for (const ModeEstimate& each : condition.result.modes) modes.insert(each.mode);
  }
  return modes;
}

std::uint64_t Report::most_realisations() const {
  std::uint64_t most = 0;
  for (const ReportedCondition& condition : conditions) most = std::max(most, condition.result.realisations);
  return most;
}

bool Report::is_random() const {
  return std::ranges::any_of(conditions, [](const auto& condition) { return condition.result.is_random(); });
}

bool Report::has_settling() const {
  return std::ranges::any_of(conditions, [](const auto& condition) { return condition.result.settling.has_value(); });
}

AnyShare share_of(const ReportedCondition& condition, const section::ResponseMode& mode) {
  const ConditionResult& result = condition.result;
  AnyShare share;
  if (const Estimate* found = result.estimate_of(mode)) {
    share = {.count = found->counts.successes, .estimate = found->estimate, .interval = found->quoted()};
  } else if (!result.is_stopped_by_data()) {
    const stats::Proportion none{.successes = 0, .trials = result.realisations};
    share.interval = simultaneous_interval(mode, none, condition.confidence);
  }
  if (!result.is_random()) share.interval.reset();
  return share;
}

Report report_of(const Experiment& experiment, ExperimentResult result, SystemFacts system) {
  ROCKING_EXPECT(experiment.conditions.size() == result.conditions.size());
  Report report{.input = input_of(experiment),
                .digest = result.digest,
                .tolerance_sensitivity = result.tolerance_sensitivity,
                .conditions = {},
                .ground_motions = used_ground_motions(experiment.conditions),
                .system = std::move(system),
                .swept = {}};
  report.conditions.reserve(result.conditions.size());
  for (std::size_t i = 0; i < result.conditions.size(); ++i) {
    const Condition& condition = experiment.conditions[i];
    report.conditions.push_back({.parameters = condition.parameters,
                                 .shaking = shaking_of(condition.scene),
                                 .scale = scale_of(condition.scene),
                                 .result = std::move(result.conditions[i]),
                                 .confidence = condition.confidence});
  }
  if (!report.conditions.empty()) report.swept = pointers_of(report.conditions.front().parameters);
  return report;
}

std::string report_text(const Experiment& experiment, const ExperimentResult& result, const SystemFacts& system) {
  return report_document().text(report_of(experiment, result, system));
}

Report report_in(const Json& document) {
  Report report = report_document().read(document);
  if (report.conditions.empty()) return report;
  report.swept = pointers_of(report.conditions.front().parameters);
  for (ReportedCondition& condition : report.conditions) {
    condition.confidence = report.number("/confidence", condition).value_or(condition.confidence);
    for (ModeEstimate& each : condition.result.modes) each.probability.counts.trials = condition.result.realisations;
  }
  return report;
}

Report parse_report(std::string_view text) {
  static_cast<void>(claims_of_report(text));  // refuses what is no report
  std::vector<base::Problem> problems;
  const Json json = parse_json(text, problems);
  if (!problems.empty()) throw base::InputError(std::move(problems));
  Report report = report_in(json);
  problems = problems_of_report(json);
  if (problems.empty()) check_reported_counts(report, problems);
  if (!problems.empty()) throw base::InputError(std::move(problems));
  return report;
}

}  // namespace rocking
