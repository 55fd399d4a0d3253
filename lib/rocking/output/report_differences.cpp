#include "rocking/output/report_differences.hpp"

#include "rocking/text/json.hpp"
#include "rocking/text/parse_json.hpp"

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

/// Reports of programs before layout 4 of a store have no peaks, no alarms that depend on a fall, no number of draws.
void drop_what_earlier_reports_lack(const Json& claimed, Json& right) {
  if (!claimed.contains("result") || !claimed["result"].contains("conditions")) return;
  const Json& before = claimed["result"]["conditions"];
  Json& after = right["result"]["conditions"];
  for (std::size_t i = 0; i < before.size() && i < after.size(); ++i) {
    if (before[i].contains("peak_tilt")) continue;
    for (const char* key : {"peak_tilt", "peak_tilt_rate", "peak_slip", "final_slip"}) after[i].erase(key);
    Json& validity = after[i]["validity"];
    for (const char* key : {"left_ground_before_fall", "draws"}) validity.erase(key);
    validity["first_realisations"].erase("left_ground_before_fall");
  }
}

/// Earlier versions wrote conditions without `shaking`: where it is absent, it is not missed.
void forget_absent_shaking(const Json& claimed, Json& right) {
  static const Json::json_pointer conditions("/result/conditions");
  if (!claimed.contains(conditions) || !right.contains(conditions)) return;
  const Json& of_claim = claimed.at(conditions);
  Json& of_right = right.at(conditions);
  for (std::size_t i = 0; i < of_right.size() && of_claim.is_array() && i < of_claim.size(); ++i) {
    if (of_claim[i].is_object() && !of_claim[i].contains("shaking")) of_right[i].erase("shaking");
  }
}

}  // namespace

std::vector<std::string> report_differences(std::string_view claimed, std::string_view right) {
  Json a = parse_json(claimed);
  Json b = parse_json(right);
  a.erase("system");
  b.erase("system");
  drop_what_earlier_reports_lack(a, b);
  forget_absent_shaking(a, b);
  std::vector<std::string> list;
  list_differences(a, b, list);
  return list;
}

std::vector<std::string> experiment_differences(std::string_view claimed, std::string_view right) {
  std::vector<std::string> list;
  list_differences(parse_json(claimed), parse_json(right), list);
  return list;
}

}  // namespace rocking
