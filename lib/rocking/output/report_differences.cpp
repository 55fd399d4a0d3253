#include "rocking/output/report_differences.hpp"

#include "rocking/base/build_info.hpp"
#include "rocking/output/report.hpp"
#include "rocking/text/json.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_listed = 10;

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

std::vector<std::string> report_differences(std::string_view claimed, std::string_view right) {
  Json a = parse_json(claimed);
  Json b = parse_json(right);
  a.erase("system");
  b.erase("system");
  // Findings follow from the rest; reports of earlier programs have none.
  if (a.contains("result") && a["result"].is_object() && !a["result"].contains("findings")) {
    a["result"].erase("warnings");
    b["result"].erase("findings");
  }
  std::vector<std::string> list;
  list_differences(a, b, list);
  return list;
}

std::vector<std::string> experiment_differences(std::string_view claimed, std::string_view right) {
  std::vector<std::string> list;
  list_differences(parse_json(claimed), parse_json(right), list);
  return list;
}

ReportRerun rerun_report(std::string_view report, const Experiment& experiment, const RunOptions& options) {
  ReportRerun again;
  const auto result = run(experiment, options);
  again.was_stopped = !result.has_value();
  if (again.was_stopped) return again;
  for (const auto& condition : result->conditions) again.checked += condition.realisations;
  // Machine and time are not compared.
  const SystemFacts facts{.build = base::build_info(), .machine = "", .start = "", .threads = 1};
  again.differences = report_differences(report, report_text(experiment, *result, facts));
  return again;
}

}  // namespace rocking
