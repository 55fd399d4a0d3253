#include "analysis/run_report.hpp"

#include <algorithm>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/ensemble/mode_family.hpp"
#include "rocking/input/check_report.hpp"
#include "rocking/input/read_report.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"
#include "rocking/text/parse_json.hpp"

namespace rocking::analysis {
namespace {

stats::Interval interval_from(const Json& json) { return {.low = json.at(0), .high = json.at(1)}; }

std::optional<double> number_from(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return json.get<double>();
}

Divergence divergence_from(const Json& json) {
  const Json& quartiles = json.at("quartiles_periods");
  return {.pairs = json.at("pairs"),
          .diverged = json.at("diverged"),
          .lower_quartile = number_from(quartiles.at(0)),
          .median = number_from(quartiles.at(1)),
          .upper_quartile = number_from(quartiles.at(2))};
}

std::optional<Difference> difference_from(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return Difference{.differ = json.at("differ"),
                    .interval = interval_from(json.at("differ_interval")),
                    .entropy = json.at("entropy_nat"),
                    .by_friction = divergence_from(json.at("divergence_by_friction")),
                    .by_arithmetic = divergence_from(json.at("divergence_by_tolerance"))};
}

std::vector<stats::QuantileEstimate> levels_from(const Json& json) {
  std::vector<stats::QuantileEstimate> estimates;
  for (const Json& quantile : json) {
    estimates.push_back({.level = quantile.at(0),
                         .value = number_from(quantile.at(1)),
                         .low = number_from(quantile.at(2)),
                         .high = number_from(quantile.at(3))});
  }
  return estimates;
}

/// Reports of earlier versions have no quantiles.
std::map<std::string, QuantileReport> quantiles_from(const Json& condition) {
  std::map<std::string, QuantileReport> quantiles;
  for (const char* key : {"peak_tilt", "peak_tilt_rate", "peak_slip", "final_slip"}) {
    if (!condition.contains(key) || condition.at(key).is_null()) continue;
    const Json& json = condition.at(key);
    quantiles[key] = {.realisations = json.at("realisations"),
                      .beyond = json.at("beyond"),
                      .levels = levels_from(json.at("quantiles")),
                      .levels_m = json.contains("quantiles_m") ? levels_from(json.at("quantiles_m"))
                                                               : std::vector<stats::QuantileEstimate>{}};
  }
  return quantiles;
}

std::optional<std::int64_t> whole_from(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return json.get<std::int64_t>();
}

IncidenceCurve curve_from(const Json& json) {
  IncidenceCurve curve{
      .periods = json.at("periods"), .estimate = json.at("estimate"), .pointwise = {}, .simultaneous = {}};
  for (const Json& interval : json.at("pointwise")) curve.pointwise.push_back(interval_from(interval));
  for (const Json& interval : json.at("simultaneous")) curve.simultaneous.push_back(interval_from(interval));
  return curve;
}

LongRunRow long_runs_from(const Json& json) {
  LongRunRow runs{.realisations = json.at("realisations"), .windows = json.at("windows"), .shares = {}};
  for (const auto& [name, found] : json.at("modes").items()) {
    runs.shares.push_back({.mode = section::response_mode_named(name).value(),
                           .share = found.at("share"),
                           .interval = interval_from(found.at("interval"))});
  }
  return runs;
}

SettlingRow settling_from(const Json& json, std::uint64_t realisations) {
  SettlingRow row;
  row.realisations = realisations;
  row.censored = json.at("censored");
  const Json& before = json.at("at_horizon");
  row.unresolved_at_horizon = before.at("counts").value(to_string(section::ResponseMode{}), std::uint64_t{0});
  row.differ_at_horizon = number_from(before.at("differ"));
  for (const auto& [name, found] : json.at("leaving").items()) {
    const Json& interval = found.at("interval");
    row.leaving.push_back({.mode = section::response_mode_named(name).value(),
                           .left = found.at("left"),
                           .watched_periods = found.at("watched_periods"),
                           .per_1000_periods = interval_from(interval)});
  }
  if (json.contains("long_run_shares")) row.long_runs = long_runs_from(json.at("long_run_shares"));
  if (!json.contains("nearly_all")) return row;
  const Json& found = json.at("nearly_all");
  row.all_but_one_per_cent = {.is_observed = found.at("basis") == "observed",
                              .time = whole_from(found.at("periods")),
                              .low = whole_from(found.at("interval").at(0)),
                              .high = whole_from(found.at("interval").at(1)),
                              .events = found.at("settled_in_the_last_half")};
  return row;
}

/// Only runs with `until_classified` have it.
std::optional<IncidenceReport> incidence_from(const Json& condition) {
  if (!condition.contains("incidence")) return std::nullopt;
  const Json& json = condition.at("incidence");
  IncidenceReport found;
  for (const auto& [name, curve] : json.at("modes").items()) {
    found.modes[section::response_mode_named(name).value()] = curve_from(curve);
  }
  if (json.contains("any_mode")) found.any_mode = curve_from(json.at("any_mode"));
  found.settling = settling_from(json, condition.at("realisations"));
  found.settling_periods = levels_from(json.at("settling_periods"));
  const auto median = std::ranges::find(found.settling_periods, 0.5, &stats::QuantileEstimate::level);
  if (median != found.settling_periods.end()) found.settling.median = *median;
  const Json& interval = json.at("at_horizon").at("differ_interval");
  if (!interval.is_null()) found.differ_interval = interval_from(interval);
  found.divergence = curve_from(json.at("divergence_by_friction"));
  if (json.contains("divergence_periods")) found.divergence_periods = levels_from(json.at("divergence_periods"));
  return found;
}

ConditionReport condition_from(const Json& json, double confidence) {
  ConditionReport condition;
  condition.confidence = confidence;
  for (const auto& [pointer, value] : json.at("parameters").items()) {
    condition.parameters.push_back(value);
    if (pointer == "/confidence") condition.confidence = value;
  }
  if (json.contains("shaking")) condition.shaking = shaking_from(json.at("shaking"));
  condition.realisations = json.at("realisations");
  condition.is_random = json.at("stopped_because") != "deterministic";
  for (const auto& [name, probability] : json.at("probabilities").items()) {
    const auto mode = section::response_mode_named(name);
    condition.stopped_by_data = condition.stopped_by_data || probability.contains("anytime");
    const Json& interval = probability.contains("anytime") ? probability["anytime"] : probability.at("simultaneous");
    condition.modes[mode.value()] = {.count = json.at("counts").at(name),
                                     .estimate = probability.at("estimate"),
                                     .interval = interval_from(interval)};
  }
  condition.quantiles = quantiles_from(json);
  condition.difference = difference_from(json.at("non_recurrence"));
  condition.incidence = incidence_from(json);
  if (condition.incidence && condition.difference) {
    condition.incidence->settling.differ_in_the_end = condition.difference->differ;
  }
  return condition;
}

/// The part of a condition that RunReport::text keeps. The other numbers are in its ConditionReport, which needs less
/// memory.
Json kept_of(const Json& condition) {
  return {{"validity", condition.at("validity")}, {"stopped_because", condition.at("stopped_because")}};
}

/// Builds a run report from a report without its conditions, and from these one by one.
class RunReportBuilder {
 public:
  /// `text` has `input`, `result` and `system`.
  explicit RunReportBuilder(Json text) {
    report_.experiment = text.at("input").at("experiment");
    report_.title = report_.experiment.at("title");
    confidence_ = report_.experiment.at("confidence");
    report_.text = std::move(text);
    report_.text["result"]["conditions"] = Json::array();
  }

  void add(const Json& condition) {
    if (report_.conditions.empty()) {
      for (const auto& [pointer, value] : condition.at("parameters").items()) report_.swept.push_back(pointer);
    }
    report_.conditions.push_back(condition_from(condition, confidence_));
    report_.text["result"]["conditions"].push_back(kept_of(condition));
  }

  [[nodiscard]] RunReport take() { return std::move(report_); }

 private:
  RunReport report_;
  double confidence_ = 0.0;
};

}  // namespace

std::optional<std::uint64_t> RunReport::periods() const {
  const Json& horizon = experiment.at("horizon");
  if (!horizon.contains("transient_periods") || !horizon.contains("sampled_periods")) return std::nullopt;
  return horizon.at("transient_periods").get<std::uint64_t>() + horizon.at("sampled_periods").get<std::uint64_t>();
}

std::map<section::ResponseMode, std::uint64_t> RunReport::occurring() const {
  std::map<section::ResponseMode, std::uint64_t> found;
  for (const ConditionReport& condition : conditions) {
    for (const auto& [mode, share] : condition.modes) {
      if (share.count > 0) found[mode] += share.count;
    }
  }
  return found;
}

std::uint64_t RunReport::most_realisations() const {
  return std::ranges::max(conditions, {}, &ConditionReport::realisations).realisations;
}

std::set<section::ResponseMode> RunReport::listed() const {
  std::set<section::ResponseMode> modes;
  for (const ConditionReport& condition : conditions) {
    for (const auto& [mode, share] : condition.modes) modes.insert(mode);
  }
  return modes;
}

bool RunReport::is_random() const { return std::ranges::any_of(conditions, &ConditionReport::is_random); }

std::string RunReport::level() const {
  const double first = conditions.front().confidence;
  const bool differs = std::ranges::any_of(
      conditions, [first](const ConditionReport& condition) { return condition.confidence != first; });
  return differs ? "each condition's own confidence" : level_text(first) + " %";
}

AnyShare share_of(const ConditionReport& condition, const section::ResponseMode& mode) {
  if (const auto found = condition.modes.find(mode); found != condition.modes.end()) {
    const ModeShare& share = found->second;
    AnyShare found_share{.count = share.count, .estimate = share.estimate, .interval = {}};
    if (condition.is_random) found_share.interval = share.interval;
    return found_share;
  }
  if (condition.stopped_by_data || !condition.is_random) return {};
  const stats::Proportion none{.successes = 0, .trials = condition.realisations};
  return {.count = 0, .estimate = 0.0, .interval = simultaneous_interval(mode, none, condition.confidence)};
}

namespace {

/// A whole number of a condition's horizon: the swept value, or that of the experiment. Absent if it depends on the base
/// motion.
std::optional<std::int64_t> of_horizon(const RunReport& report, const ConditionReport& condition,
                                       const std::string& place) {
  Json horizon = report.experiment.at("horizon");
  Json all = {{"horizon", std::move(horizon)}};
  for (std::size_t i = 0; i < report.swept.size(); ++i) {
    if (report.swept[i].starts_with("/horizon")) all[Json::json_pointer(report.swept[i])] = condition.parameters[i];
  }
  const Json::json_pointer pointer("/horizon" + place);
  if (!all.contains(pointer) || !all.at(pointer).is_number()) return std::nullopt;
  return all.at(pointer).get<std::int64_t>();
}

}  // namespace

std::optional<SettlingRow> settling_row(const RunReport& report, std::size_t number) {
  const ConditionReport& condition = report.conditions[number];
  if (!condition.incidence) return std::nullopt;
  SettlingRow row = condition.incidence->settling;
  row.confidence = condition.confidence;
  for (std::size_t i = 0; i < report.swept.size(); ++i) {
    row.parameters.push_back({.pointer = report.swept[i], .value = condition.parameters[i].dump()});
  }
  const auto transient = of_horizon(report, condition, "/transient_periods");
  const auto sampled = of_horizon(report, condition, "/sampled_periods");
  if (transient && sampled) row.fixed_horizon = *transient + *sampled;
  row.limit = of_horizon(report, condition, "/until_classified/at_most_periods");
  const std::int64_t held = of_horizon(report, condition, "/until_classified/held_windows").value_or(1);
  row.held_windows = static_cast<int>(held);
  row.confirmation = (held - 1) * sampled.value_or(0);
  return row;
}

std::vector<SettlingRow> settling_rows(const RunReport& report) {
  std::vector<SettlingRow> rows;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    if (auto row = settling_row(report, i)) rows.push_back(*std::move(row));
  }
  return rows;
}

std::string unresolved_remedy(const RunReport& report) {
  double largest = 0.0;
  const ConditionReport* worst = nullptr;
  for (const ConditionReport& condition : report.conditions) {
    const auto found = condition.modes.find(section::ResponseMode{});
    if (!condition.is_random || condition.incidence || found == condition.modes.end()) continue;
    if (found->second.estimate <= largest) continue;
    largest = found->second.estimate;
    worst = &condition;
  }
  if (worst == nullptr || report.experiment.at("excitation").value("kind", "") != "harmonic") return "";
  const auto transient = of_horizon(report, *worst, "/transient_periods");
  const auto sampled = of_horizon(report, *worst, "/sampled_periods");
  if (!transient || !sampled) return "";
  return rocking::unresolved_remedy(largest, *transient, *sampled);
}

RunReport run_report_of(const Experiment& experiment, const ExperimentResult& result, const SystemFacts& system) {
  RunReportBuilder builder(report_frame(experiment, result, system));
  for (std::size_t i = 0; i < result.conditions.size(); ++i) {
    builder.add(condition_json(experiment.conditions[i], result.conditions[i]));
  }
  return builder.take();
}

RunReport run_report_of(Json json) {
  const Json conditions = std::exchange(json.at("result").at("conditions"), Json::array());
  json.erase("internal");
  RunReportBuilder builder(std::move(json));
  for (const Json& condition : conditions) builder.add(condition);
  return builder.take();
}

RunReport read_run_report(std::string_view text) {
  static_cast<void>(read_report(text));  // refuses what is no report; its keys are checked below
  std::vector<base::Problem> problems;
  Json json = parse_json(text, problems);
  if (problems.empty()) problems = problems_of_report(json);
  if (!problems.empty()) throw base::InputError(std::move(problems));
  return run_report_of(std::move(json));
}

}  // namespace rocking::analysis
