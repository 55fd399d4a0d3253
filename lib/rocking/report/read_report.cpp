#include "rocking/report/read_report.hpp"

#include "rocking/base/error.hpp"
#include "rocking/report/json.hpp"
#include "rocking/report/parse_json.hpp"
#include "rocking/report/write_report.hpp"

namespace rocking::report {
namespace {

constexpr std::size_t most_listed = 10;

Json parsed(std::string_view text) {
  std::vector<base::Problem> problems;
  Json json = parse_json(text, problems);
  if (!problems.empty()) throw base::InputError(std::move(problems));
  return json;
}

std::string text_at(const Json& report, const char* pointer) {
  const Json::json_pointer place(pointer);
  if (report.contains(place) && report.at(place).is_string()) return report.at(place).get<std::string>();
  throw base::InputError(
      {.place = pointer, .value = "", .reason = "is missing, or is not text: this is not a report", .remedy = ""});
}

void list_differences(const Json& claimed, const Json& right, std::vector<std::string>& list) {
  for (const Json& step : Json::diff(claimed, right)) {
    if (list.size() == most_listed) return;
    const auto place = step["path"].get<std::string>();
    const std::string operation = step["op"];
    if (operation == "remove") {
      list.push_back(place + " should not be there");
    } else if (operation == "add") {
      list.push_back(place + " is missing; it is " + brief(step["value"]));
    } else {
      list.push_back(place + " is " + brief(claimed.at(Json::json_pointer(place))) + ", not " + brief(step["value"]));
    }
  }
}

}  // namespace

ReportClaims read_report(std::string_view text) {
  const Json report = parsed(text);
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

std::vector<std::string> report_differences(std::string_view claimed, std::string_view right) {
  Json a = parsed(claimed);
  Json b = parsed(right);
  a.erase("system");
  b.erase("system");
  std::vector<std::string> list;
  list_differences(a, b, list);
  return list;
}

std::vector<std::string> experiment_differences(std::string_view claimed, std::string_view right) {
  std::vector<std::string> list;
  list_differences(parsed(claimed), parsed(right), list);
  return list;
}

}  // namespace rocking::report
