#include "rocking/output/report.hpp"

#include "rocking/look/text_table.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/ensemble/mode_family.hpp"
#include "rocking/input/condition_family.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/output/validity_fields.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_problems = 20;
constexpr double rounding = 1e-12;

class CountChecker {
 public:
  explicit CountChecker(Problems& problems) : problems_(&problems) {}

  void check(const Report& report) {
    if (const auto& found = report.tolerance_sensitivity) {
      place_ = "/result/tolerance_sensitivity";
      part_of(found->flips.successes, found->flips.trials, "/flips");
    }
    for (std::size_t i = 0; i < report.conditions.size() && problems_->size() < most_problems; ++i) {
      place_ = "/result/conditions/" + std::to_string(i);
      check(report.conditions[i].result);
    }
  }

 private:
  template <class Value>
  void reject(const std::string& place, const Value& value, std::string reason) {
    if (problems_->size() >= most_problems) return;
    problems_->push_back({place_ + place, Json(value).dump(), std::move(reason),
                          "`rocking run` writes the report again; `rocking verify` compares it with its realisations"});
  }

  void part_of(std::uint64_t part, std::uint64_t whole, const std::string& place) {
    if (part > whole) reject(place, part, "is greater than their number, " + std::to_string(whole));
  }

  void check(const ConditionResult& result) {
    if (static_cast<double>(result.realisations) > *rules::realisations.most) {
      return reject("/realisations", result.realisations,
                    "is greater than the largest number that an experiment may have");
    }
    check_modes(result);
    check_sides(result);
    if (result.non_recurrence) check_non_recurrence(*result.non_recurrence, result.realisations);
    const PeakQuantiles& peaks = result.peaks;
    check_quantiles(peaks.tilt, result.realisations, "/peak_tilt");
    check_quantiles(peaks.tilt_rate, result.realisations, "/peak_tilt_rate");
    if (result.exponents) check_quantiles(result.exponents->quantiles, result.realisations, "/lyapunov_exponent");
    if (peaks.slip) check_quantiles(peaks.slip->over_half_diagonal, result.realisations, "/peak_slip");
    if (peaks.final_slip) check_quantiles(peaks.final_slip->over_half_diagonal, result.realisations, "/final_slip");
    check_validity(result);
  }

  void check_share(const Estimate& probability, std::uint64_t realisations, const std::string& place) {
    const double share = static_cast<double>(probability.counts.successes) / static_cast<double>(realisations);
    if (std::abs(probability.estimate - share) <= rounding) return;
    reject(place + "/estimate", probability.estimate, "is not count/n, " + Json(share).dump());
  }

  void check_sides(const ConditionResult& result) {
    std::uint64_t sum = 0;
    for (const auto& [side, place] : {std::pair(&result.overturned_left, "/overturned_left"),
                                      std::pair(&result.overturned_right, "/overturned_right")}) {
      if (!*side) return;
      const Estimate& probability = (*side)->probability;
      sum += std::min(probability.counts.successes, result.realisations);
      check_share(probability, result.realisations, place);
    }
    const Estimate* both = result.estimate_of({.kind = section::ResponseKind::overturned});
    const std::uint64_t count = both == nullptr ? 0 : both->counts.successes;
    if (sum != count)
      reject("/overturned_left", sum,
             "is the sum of both sides, not the count of overturned, " + std::to_string(count));
  }

  void check_modes(const ConditionResult& result) {
    std::uint64_t sum = 0;
    for (const auto& [mode, probability] : result.modes) {
      const std::uint64_t count = probability.counts.successes;
      const std::string place = "/probabilities/" + to_string(mode);
      part_of(count, result.realisations, "/counts/" + to_string(mode));
      sum += std::min(count, result.realisations);
      check_share(probability, result.realisations, place);
    }
    if (sum == result.realisations) return;
    reject("/counts", sum, "is the sum of the counts, not the number of realisations");
  }

  void check_non_recurrence(const NonRecurrence& found, std::uint64_t realisations) {
    for (const auto& [times, key] : {std::pair(&found.friction, "/non_recurrence/divergence_by_friction"),
                                     std::pair(&found.arithmetic, "/non_recurrence/divergence_by_tolerance")}) {
      part_of(times->pairs, realisations, std::string(key) + "/pairs");
      part_of(times->diverged, times->pairs, std::string(key) + "/diverged");
    }
    part_of(found.arithmetic_flips.trials, realisations, "/non_recurrence/arithmetic_flips/of");
    part_of(found.arithmetic_flips.successes, found.arithmetic_flips.trials, "/non_recurrence/arithmetic_flips/count");
  }

  void check_quantiles(const Quantiles& quantiles, std::uint64_t realisations, const std::string& place) {
    part_of(quantiles.realisations, realisations, place + "/realisations");
    part_of(quantiles.beyond, quantiles.realisations, place + "/beyond");
  }

  void check_validity(const ConditionResult& result) {
    for_each_case(result.validity, [&](const std::string& name, const Cases& cases) {
      part_of(cases.count, result.realisations, "/validity/" + name);
      for (const std::uint64_t number : cases.first) {
        part_of(number + 1, result.realisations, "/validity/first_realisations/" + name);
      }
    });
  }

  Problems* problems_;
  std::string place_;  ///< of what is checked
};

/// Reports where the numbers of a report contradict each other: counts that do not add up to the number of
/// realisations, an estimate that is not count/n, parts that are larger than the whole.
void check_reported_counts(const Report& report, Problems& problems) { CountChecker(problems).check(report); }

/// Whether the experiment states a number of its horizon for a condition.
bool states_horizon(const Json& experiment, const Condition& condition, const std::string& key) {
  const std::string place = "/horizon/" + key;
  for (const Parameter& parameter : condition.parameters) {
    if (parameter.pointer == place) return true;
    if (parameter.pointer == "/horizon") return json_of(parameter.value).contains(key);
  }
  return experiment.contains(Json::json_pointer(place));
}

/// What follows from the experiment and its conditions.
void set_what_follows(Report& report) {
  if (report.conditions.empty()) return;
  for (const Parameter& parameter : report.conditions.front().asked.parameters) {
    report.swept.push_back(parameter.pointer);
  }
  for (ReportedCondition& condition : report.conditions) {
    condition.states_horizon = states_horizon(report.input.experiment, condition.asked, "transient_periods") &&
                               states_horizon(report.input.experiment, condition.asked, "sampled_periods");
  }
}

/// Reads what was asked for in each condition from the experiment and its parameters.
void read_conditions(Report& report) {
  report.left_out = left_out_of(report.input.experiment);
  ConditionReader reader(report.input.experiment);
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    auto& [asked, states_horizon, shaking, scale, floor, result] = report.conditions[i];
    asked = reader.read(std::move(asked.parameters), "/result/conditions/" + std::to_string(i) + "/parameters");
    for (ModeEstimate& each : result.modes) each.probability.counts.trials = result.realisations;
    for (auto* side : {&result.overturned_left, &result.overturned_right}) {
      if (*side) (*side)->probability.counts.trials = result.realisations;
    }
  }
  set_what_follows(report);
}

}  // namespace

std::optional<std::uint64_t> Report::periods() const {
  const auto periods_of = [](const ReportedCondition& condition) -> std::optional<std::uint64_t> {
    if (!condition.states_horizon) return std::nullopt;
    return static_cast<std::uint64_t>(condition.asked.horizon.periods());
  };
  const auto first = periods_of(conditions.front());
  const bool differs = std::ranges::any_of(conditions, [&](const auto& each) { return periods_of(each) != first; });
  return differs ? std::nullopt : first;
}

std::string Report::level(const std::string& swept_text) const {
  const double first = conditions.front().asked.confidence;
  const bool differs =
      std::ranges::any_of(conditions, [first](const auto& each) { return each.asked.confidence != first; });
  return differs ? swept_text : level_text(first) + " %";
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

bool Report::is_periodic() const {
  return std::ranges::all_of(
      conditions, [](const auto& condition) { return rocking::is_periodic(condition.asked.scene.excitation); });
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
    share.interval = simultaneous_interval(mode, none, condition.asked.confidence);
  }
  if (!result.is_random()) share.interval.reset();
  return share;
}

AnyShare share_of(const ReportedCondition& condition, const SideEstimate& side) {
  const Estimate& found = side.probability;
  AnyShare share{.count = found.counts.successes, .estimate = found.estimate, .interval = found.quoted()};
  if (!condition.result.is_random()) share.interval.reset();
  return share;
}

bool has_unlike_edges(const Report& report) {
  return std::ranges::any_of(report.conditions, [](const ReportedCondition& condition) {
    return !dynamics::geometry_of(mean_block(condition.asked.scene)).has_mirror_symmetry();
  });
}

std::string floor_in_words(const Report& report) {
  std::string words;
  bool is_one = true;
  NumberRange ground, floor;
  for (const ReportedCondition& condition : report.conditions) {
    const auto* recorded = std::get_if<Recorded>(&condition.asked.scene.excitation);
    const bool is_in_building = recorded != nullptr && recorded->building;
    const std::string own = is_in_building ? floor_in_words(*recorded->building) : "on the ground";
    is_one = is_one && (words.empty() || words == own);
    words = own;
    if (!condition.floor) continue;
    ground.add(condition.floor->pga_g);
    floor.add(condition.floor->floor_peak_g);
  }
  if (is_one && words == "on the ground") return "";
  return (is_one ? words : std::string("on several floors")) + ": peak " + floor.text() + " g, of the ground " +
         ground.text() + " g";
}

Report report_of(Experiment experiment, ExperimentResult result, SystemFacts system) {
  ROCKING_EXPECT(experiment.conditions.size() == result.conditions.size());
  Report report{.input = input_of(experiment),
                .digest = result.digest,
                .tolerance_sensitivity = result.tolerance_sensitivity,
                .conditions = {},
                .ground_motions = used_ground_motions(experiment.conditions),
                .system = std::move(system),
                .swept = {},
                .left_out = std::move(experiment.left_out)};
  report.conditions.reserve(result.conditions.size());
  for (std::size_t i = 0; i < result.conditions.size(); ++i) {
    ReportedCondition& condition = report.conditions.emplace_back();
    condition.asked = std::move(experiment.conditions[i]);
    condition.shaking = shaking_of(condition.asked.scene);
    condition.scale = scale_of(condition.asked.scene);
    condition.floor = floor_peaks_of(condition.asked.scene);
    condition.result = std::move(result.conditions[i]);
  }
  set_what_follows(report);
  return report;
}

std::string report_text(const Experiment& experiment, const ExperimentResult& result, const SystemFacts& system) {
  return report_document().text(report_of(experiment, result, system));
}

Report report_in(const Json& document) {
  Report report = report_document().read(document);
  read_conditions(report);
  return report;
}

Report parse_report(std::string_view text) {
  static_cast<void>(claims_of_report(text));  // refuses what is no report
  std::vector<base::Problem> problems;
  const Json json = parse_json(text, problems);
  if (!problems.empty()) throw base::InputError(std::move(problems));
  Report report = report_document().read(json);
  problems = problems_of_report(json);
  if (problems.empty()) check_reported_counts(report, problems);
  if (!problems.empty()) throw base::InputError(std::move(problems));
  read_conditions(report);
  return report;
}

bool sweeps_records(const Report& report) {
  return std::ranges::find(report.swept, "/excitation/file") != report.swept.end();
}

}  // namespace rocking
