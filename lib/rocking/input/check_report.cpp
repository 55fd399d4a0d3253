#include "rocking/input/check_report.hpp"

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/base/digest.hpp"
#include "rocking/input/check_document.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/section/response_mode.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_report_problems = 20;
constexpr const char* experiment_place = "/input/experiment";

/// What a report's experiment holds whether its author wrote it or not.
constexpr const char* written_defaults[] = {
    "/title", "/block/gravity_m_s2", "/excitation/kind", "/horizon", "/accuracy/tolerance", "/confidence", "/seed"};

class ReportChecker {
 public:
  explicit ReportChecker(const Json& report) : report_(report), experiment_(report["input"]["experiment"]) {}

  Problems check() {
    check_experiment();
    if (!problems_.empty()) return std::move(problems_);
    check_tolerance_sensitivity(report_["result"]["tolerance_sensitivity"]);
    check_grid();
    const Json& conditions = report_["result"]["conditions"];
    for (std::size_t i = 0; i < conditions.size() && problems_.size() < most_report_problems; ++i) {
      place_ = "/result/conditions/" + std::to_string(i);
      check_condition(conditions[i]);
    }
    if (report_["internal"]["conditions"].size() != conditions.size()) {
      reject("/internal/conditions", "", "differ in number from /result/conditions");
    }
    return std::move(problems_);
  }

 private:
  void reject(std::string place, std::string value, std::string reason) {
    if (problems_.size() >= most_report_problems) return;
    problems_.push_back({std::move(place), std::move(value), std::move(reason),
                         "`rocking run` writes the report again; `rocking verify` compares it with its realisations"});
  }

  /// Of the condition at hand.
  void reject_here(const std::string& place, const Json& value, std::string reason) {
    reject(place_ + place, brief(value), std::move(reason));
  }

  void check_experiment() {
    check_document(experiment_, "experiment", experiment_place, problems_);
    if (!problems_.empty()) return;
    for (const char* pointer : written_defaults) {
      if (experiment_.contains(Json::json_pointer(pointer))) continue;
      reject(std::string(experiment_place) + pointer, "",
             "is missing: a report's experiment has its defaults written out");
    }
    if (problems_.empty() && !experiment_["seed"].is_string()) {
      reject("/input/experiment/seed", brief(experiment_["seed"]), "must be text in a report");
    }
    const Json& digest = report_["input"]["sha256"];
    if (base::to_hex(base::sha256(experiment_.dump())) != digest.get_ref<const std::string&>()) {
      reject("/input/sha256", brief(digest), "is not the digest of /input/experiment: one of them was changed");
    }
  }

  /// One condition for each point of the sweep, with the values of that point.
  void check_grid() {
    std::vector<SweepAxis> axes;
    if (experiment_.contains("sweep")) {
      Problems of_sweep;
      axes = read_sweep(experiment_["sweep"], experiment_, most_conditions, of_sweep);
      for (base::Problem& problem : of_sweep) {
        problem.place = experiment_place + problem.place;
        problems_.push_back(std::move(problem));
      }
      if (problems_.empty()) check_swept_values(axes);
      if (!problems_.empty()) return;
    }
    if (auto records = suite_axis(experiment_)) axes.insert(axes.begin(), *std::move(records));
    const Json& conditions = report_["result"]["conditions"];
    if (conditions.size() != grid_size(axes)) {
      reject("/result/conditions", "",
             "are " + std::to_string(conditions.size()) + ", where the sweep has " + std::to_string(grid_size(axes)) +
                 " points");
      return;
    }
    for (std::size_t i = 0; i < conditions.size() && problems_.size() < most_report_problems; ++i) {
      check_parameters(conditions[i]["parameters"], axes, grid_point(axes, i), i);
    }
  }

  /// Swept values against the schema of experiments. Of the numbers of an entry the two extremes tell of all of them.
  void check_swept_values(const std::vector<SweepAxis>& axes) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      std::vector<const Json*> tried;
      const Json* least = nullptr;
      const Json* most = nullptr;
      for (const Json& value : axes[i].values) {
        if (!value.is_number()) {
          tried.push_back(&value);
          continue;
        }
        if (least == nullptr || value < *least) least = &value;
        if (most == nullptr || *most < value) most = &value;
      }
      if (least != nullptr) tried.insert(tried.end(), {least, most});
      for (const Json* value : tried) {
        if (problems_.empty()) check_swept_value(axes[i].pointer, *value, i);
      }
    }
  }

  void check_swept_value(const std::string& pointer, const Json& value, std::size_t entry) {
    Json document = experiment_;
    const bool is_whole = document.at(Json::json_pointer(pointer)).is_number_integer() && value.is_number_float();
    document[Json::json_pointer(pointer)] = is_whole ? Json(std::llround(value.get<double>())) : value;
    Problems found;
    check_document(document, "experiment", "", found);
    if (found.empty()) return;
    reject(std::string(experiment_place) + "/sweep/" + std::to_string(entry), brief(value),
           "is not allowed at " + pointer + ": " + found.front().reason);
  }

  void check_parameters(const Json& parameters, const std::vector<SweepAxis>& axes,
                        const std::vector<const Json*>& point, std::size_t condition) {
    const std::string place = "/result/conditions/" + std::to_string(condition) + "/parameters";
    if (parameters.size() != axes.size()) {
      reject(place, brief(parameters),
             "holds " + std::to_string(parameters.size()) + " values, where the sweep has " +
                 std::to_string(axes.size()) + " entries");
      return;
    }
    std::size_t i = 0;
    for (const auto& [pointer, value] : parameters.items()) {
      if (pointer != axes[i].pointer) {
        reject(child_pointer(place, pointer), brief(value), "is not swept here; the sweep has " + axes[i].pointer);
      } else if (value != *point[i]) {
        reject(child_pointer(place, pointer), brief(value), "is not the value of the sweep, " + brief(*point[i]));
      }
      ++i;
    }
  }

  void check_condition(const Json& condition) {
    const auto n = whole(condition["realisations"], "/realisations");
    if (!n) return;
    if (*n > static_cast<std::uint64_t>(rules::realisations.high)) {
      reject_here("/realisations", condition["realisations"],
                  "is greater than the largest number that an experiment may have");
      return;
    }
    check_modes(condition, *n);
    if (!condition["non_recurrence"].is_null()) check_non_recurrence(condition["non_recurrence"], *n);
    for (const char* key : {"peak_tilt", "peak_tilt_rate", "peak_slip", "final_slip"}) {
      if (condition.contains(key) && !condition[key].is_null())
        check_quantities(condition[key], *n, '/' + std::string(key));
    }
    check_validity(condition["validity"], *n);
  }

  /// Quantiles of a number over at most n realisations.
  void check_quantities(const Json& json, std::uint64_t n, const std::string& place) {
    const auto of = at_most(json["realisations"], n, place + "/realisations");
    if (of) static_cast<void>(at_most(json["beyond"], *of, place + "/beyond"));
    for (const char* key : {"quantiles", "quantiles_m"}) {
      if (!json.contains(key)) continue;
      for (std::size_t i = 0; i < json[key].size(); ++i) {
        check_quantile(json[key][i], place + '/' + key + '/' + std::to_string(i));
      }
    }
  }

  /// [level, value, low, high]: those that are there are in order.
  void check_quantile(const Json& quantile, const std::string& place) {
    std::optional<double> last;
    for (const std::size_t i : {2U, 1U, 3U}) {
      if (quantile[i].is_null()) continue;
      const auto number = quantile[i].get<double>();
      if (last && number < *last) reject_here(place, quantile, "has a value that lies outside its interval");
      last = number;
    }
  }

  void check_modes(const Json& condition, std::uint64_t n) {
    const Json& counts = condition["counts"];
    const Json& probabilities = condition["probabilities"];
    std::uint64_t sum = 0;
    for (const auto& [name, count] : counts.items()) {
      if (!section::response_mode_named(name)) reject_here("/counts/" + name, count, "is not a response mode");
      if (!probabilities.contains(name)) reject_here("/counts/" + name, count, "has no probability");
      sum += at_most(count, n, "/counts/" + name).value_or(0);
    }
    if (sum != n) {
      reject_here("/counts", counts, "add up to " + std::to_string(sum) + ", not to the number of realisations");
    }
    for (const auto& [name, probability] : probabilities.items()) {
      const std::string place = "/probabilities/" + name;
      if (!counts.contains(name)) {
        reject_here(place, probability, "has no count");
        continue;
      }
      check_probability(probability, counts[name], n, place);
    }
  }

  void check_probability(const Json& probability, const Json& count, std::uint64_t n, const std::string& place) {
    constexpr double rounding = 1e-12;
    const double share = count.get<double>() / static_cast<double>(n);
    if (std::abs(probability["estimate"].get<double>() - share) > rounding) {
      reject_here(place + "/estimate", probability["estimate"], "is not count/n, " + Json(share).dump());
    }
    for (const auto& [key, part] : probability.items()) {
      if (part.is_array()) check_interval(part, place + '/' + key);
    }
    if (!probability.contains("corrected")) return;
    const Json& corrected = probability["corrected"];
    check_interval(corrected["interval"], place + "/corrected/interval");
    const auto checked = at_most(corrected["checked"], n, place + "/corrected/checked");
    for (const char* key : {"gained", "lost"}) {
      if (checked) static_cast<void>(at_most(corrected[key], *checked, place + "/corrected/" + key));
    }
  }

  void check_non_recurrence(const Json& found, std::uint64_t n) {
    check_interval(found["differ_interval"], "/non_recurrence/differ_interval");
    for (const char* key : {"divergence_by_friction", "divergence_by_tolerance"}) {
      const std::string place = std::string("/non_recurrence/") + key;
      const auto pairs = at_most(found[key]["pairs"], n, place + "/pairs");
      if (pairs) static_cast<void>(at_most(found[key]["diverged"], *pairs, place + "/diverged"));
    }
    const Json& flips = found["arithmetic_flips"];
    check_interval(flips["interval"], "/non_recurrence/arithmetic_flips/interval");
    const auto of = at_most(flips["of"], n, "/non_recurrence/arithmetic_flips/of");
    if (of) static_cast<void>(at_most(flips["count"], *of, "/non_recurrence/arithmetic_flips/count"));
  }

  void check_validity(const Json& validity, std::uint64_t n) {
    const Json& first = validity["first_realisations"];
    for (const auto& [key, cases] : validity.items()) {
      if (!cases.is_number_integer() || key == "draws") continue;  // draws are no realisations
      const auto count = at_most(cases, n, "/validity/" + key);
      if (count && *count > 0 && !first.contains(key)) {
        reject_here("/validity/first_realisations/" + key, Json(), "is missing, although there are such realisations");
      }
    }
    for (const auto& [reason, cases] : validity["unresolved"].items()) {
      static_cast<void>(at_most(cases, n, "/validity/unresolved/" + reason));
    }
    for (const auto& [key, numbers] : first.items()) {
      for (const Json& number : numbers) {
        static_cast<void>(at_most(number, n - 1, "/validity/first_realisations/" + key));
      }
    }
  }

  void check_tolerance_sensitivity(const Json& floor) {
    if (floor.is_null()) return;
    place_ = "/result/tolerance_sensitivity";
    check_interval(floor["interval"], "/interval");
    const auto of = whole(floor["of"], "/of");
    if (of) static_cast<void>(at_most(floor["flips"], *of, "/flips"));
  }

  void check_interval(const Json& interval, const std::string& place) {
    if (interval[0].get<double>() <= interval[1].get<double>()) return;
    reject_here(place, interval, "begins above its end");
  }

  /// The schema calls 3.0 a whole number as well; we never write that.
  std::optional<std::uint64_t> whole(const Json& value, const std::string& place) {
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    reject_here(place, value, "must be a whole number, 0 or more");
    return std::nullopt;
  }

  std::optional<std::uint64_t> at_most(const Json& value, std::uint64_t most, const std::string& place) {
    const auto number = whole(value, place);
    if (!number || *number <= most) return number;
    reject_here(place, value, "is greater than their number, " + std::to_string(most));
    return std::nullopt;
  }

  const Json& report_;
  const Json& experiment_;
  Problems problems_;
  std::string place_;  ///< of what is checked
};

}  // namespace

Problems problems_of_report(const Json& report) {
  Problems problems;
  check_document(report, "report", "", problems);
  if (!problems.empty()) return problems;
  return ReportChecker(report).check();
}

}  // namespace rocking
