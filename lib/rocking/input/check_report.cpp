#include "rocking/input/check_report.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "rocking/base/digest.hpp"
#include "rocking/input/check_document.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/input/sweep.hpp"

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
    check_grid();
    if (report_["internal"]["conditions"].size() != report_["result"]["conditions"].size()) {
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

  const Json& report_;
  const Json& experiment_;
  Problems problems_;
};

}  // namespace

Problems problems_of_report(const Json& report) { return ReportChecker(report).check(); }

}  // namespace rocking
