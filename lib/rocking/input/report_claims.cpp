#include "rocking/input/report_claims.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "rocking/base/digest.hpp"
#include "rocking/base/error.hpp"
#include "rocking/input/read_question.hpp"
#include "rocking/input/suite.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

std::string text_at(const Json& report, const char* pointer) {
  const Json::json_pointer place(pointer);
  if (report.contains(place) && report.at(place).is_string()) return report.at(place).get<std::string>();
  throw base::InputError(
      {.place = pointer, .value = "", .reason = "is missing, or is not text: this is not a report", .remedy = ""});
}

constexpr std::size_t most_report_problems = 20;
constexpr const char* experiment_place = "/input/experiment";

class ReportChecker {
 public:
  explicit ReportChecker(const Json& report)
      : report_(report), experiment_(report["input"]["experiment"]), one_record_(without_suite(experiment_)) {}

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
    check_form();
    if (!problems_.empty()) return;
    const Json& digest = report_["input"]["sha256"];
    if (base::to_hex(base::sha256(experiment_.dump())) != digest.get_ref<const std::string&>()) {
      reject("/input/sha256", brief(digest), "is not the digest of /input/experiment: one of them was changed");
    }
  }

  /// The experiment must be what an experiment file may hold, with every default written out. Files of ground motions are
  /// not looked at.
  void check_form() {
    if (!suite_axis(experiment_)) return check_form(experiment_, experiment_);
    const Json& records = experiment_["excitation"]["suite"];
    for (std::size_t i = 0; i < records.size() && problems_.empty(); ++i) {
      if (!records[i].is_object()) {
        return reject(experiment_place + child_pointer("/excitation/suite", std::to_string(i)), brief(records[i]),
                      "is not a record with a file and its digest");
      }
      put_record(one_record_, records[i]);
      check_form(one_record_, with_suite_as_sweep(one_record_));
    }
  }

  /// `read`: the document as its defaults are worked out.
  void check_form(const Json& document, const Json& read) {
    Problems found;
    Json canonical = read_question(read, nullptr, found).canonical;
    for (base::Problem& problem : found) {
      problem.place = experiment_place + problem.place;
      problems_.push_back(std::move(problem));
    }
    if (!problems_.empty()) return;
    canonical.erase("sweep");
    Json stated = document;
    stated.erase("sweep");
    const Json changes = Json::diff(stated, canonical);
    if (changes.empty()) return;
    const auto& place = changes.front()["path"].get_ref<const std::string&>();
    const Json::json_pointer pointer(place);
    reject(experiment_place + place, stated.contains(pointer) ? brief(stated.at(pointer)) : "",
           "is not as in a canonical experiment, where every default is written out");
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

  /// Swept values must be allowed in their places. Of the numbers of an entry the two extremes tell of all of them.
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
    Json document = one_record_;
    const bool is_whole = document.at(Json::json_pointer(pointer)).is_number_integer() && value.is_number_float();
    document[Json::json_pointer(pointer)] = is_whole ? Json(std::llround(value.get<double>())) : value;
    Problems found;
    static_cast<void>(read_question(document, nullptr, found));
    if (found.empty()) return;
    reject(std::string(experiment_place) + "/sweep/" + std::to_string(entry), brief(value),
           "is not allowed at " + pointer + ": " + found.front().reason);
  }

  void check_parameters(Json parameters, const std::vector<SweepAxis>& axes, const std::vector<const Json*>& point,
                        std::size_t condition) {
    const std::string place = "/result/conditions/" + std::to_string(condition) + "/parameters";
    Json names = Json::object();
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (std::string name = axes[i].name_of(point[i]); !name.empty()) names[axes[i].pointer] = std::move(name);
    }
    const Json stated = parameters.value(names_of_values, Json::object());
    if (stated != names) reject(place + '/' + names_of_values, brief(stated), "are not the names of the sweep");
    parameters.erase(names_of_values);
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
  Json one_record_;  ///< the experiment with one record in place of its suite
  Problems problems_;
};

}  // namespace

ReportClaims claims_of_report(std::string_view text) {
  const Json report = parse_json(text);
  if (text_at(report, "/format") != report_format) {
    throw base::InputError({.place = "/format",
                            .value = brief(report["format"]),
                            .reason = "is not the format of a report",
                            .remedy = "give a report in format " + std::string(report_format)});
  }
  if (!report.contains("input") || !report["input"].contains("experiment")) {
    throw base::InputError({.place = "/input/experiment", .value = "", .reason = "is missing", .remedy = ""});
  }
  return {.experiment = report["input"]["experiment"].dump(),
          .sha256 = text_at(report, "/input/sha256"),
          .code = text_at(report, "/system/version") + ' ' + text_at(report, "/system/revision")};
}

bool has_stated_digest(const ReportClaims& claims) {
  return base::to_hex(base::sha256(claims.experiment)) == claims.sha256;
}

Problems problems_of_report(const Json& report) { return ReportChecker(report).check(); }

}  // namespace rocking
