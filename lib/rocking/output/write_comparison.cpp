#include "rocking/output/write_comparison.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "rocking/output/mode_table.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/scene/shaking.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

Json mode_json(const ModeComparison& mode) {
  const stats::PairedCounts& counts = mode.counts;
  Json json = Json::object();
  json["both"] = counts.both;
  json["first_only"] = counts.first_only;
  json["second_only"] = counts.second_only;
  json["neither"] = counts.neither;
  json["difference"] = mode.difference;
  json["score"] = interval_json(mode.score);
  json["exact"] = interval_json(mode.exact);
  json["mcnemar_p_value"] = mode.test.p_value;
  json["mcnemar_mid_p"] = mode.test.mid_p;
  json["variance_reduction"] = mode.variance_reduction ? Json(*mode.variance_reduction) : Json();
  return json;
}

std::string level_of(const ComparedRuns& runs) {
  const auto common = common_confidence(*runs.first);
  return common ? level_text(*common) + " % interval" : "interval at the confidence of each condition";
}

/// ` = 1.1 g`, the other form of a swept amplitude or frequency; empty for other parameters.
std::string form_beside(const Parameter& parameter, const std::optional<Shaking>& shaking) {
  for (const ShakingNumber& each : shaking_numbers) {
    if (!shaking || parameter.pointer != "/excitation/" + std::string(each.key)) continue;
    const std::string_view other = other_form_of(each.key);
    return " = " + in_unit(other, significant(number_of(*shaking, other), 3));
  }
  return "";
}

std::string name_of(const ComparedRuns& runs, std::size_t condition) {
  std::string name;
  const auto shaking = shaking_of(runs.first->conditions[condition].scene);
  for (const Parameter& parameter : runs.first->conditions[condition].parameters) {
    name += (name.empty() ? "" : ", ") + short_value(parameter) + form_beside(parameter, shaking);
  }
  return name.empty() ? std::to_string(condition) : name;
}

}  // namespace

std::string comparison_text(const ComparedRuns& runs) {
  Json json = Json::object();
  json["format"] = comparison_format;
  json["settings"] = experiment_differences(runs.first->canonical_text, runs.second->canonical_text);
  const auto common = common_confidence(*runs.first);
  json["confidence"] = common ? Json(*common) : Json();
  json["tests"] = number_of_tests(runs.conditions);
  Json& conditions = json["conditions"] = Json::array();
  for (std::size_t i = 0; i < runs.conditions.size(); ++i) {
    const ConditionComparison& compared = runs.conditions[i];
    Json entry = Json::object();
    entry["parameters"] = parameters_json(runs.first->conditions[i]);
    entry["confidence"] = compared.confidence;
    entry["realisations"] = compared.realisations;
    entry["changed"] = {{"count", compared.changed.successes}, {"interval", interval_json(compared.changed_interval)}};
    Json& modes = entry["modes"] = Json::object();
    for (const auto& [mode, comparison] : compared.modes) modes[to_string(mode)] = mode_json(comparison);
    conditions.push_back(std::move(entry));
  }
  return json.dump(2) + '\n';
}

std::string comparison_table(const ComparedRuns& runs) {
  std::string text;
  for (const std::string& difference :
       experiment_differences(runs.first->canonical_text, runs.second->canonical_text)) {
    text += "first run: " + difference + " as in the second\n";
  }
  if (!text.empty()) text += '\n';
  std::uint64_t most = 0;
  std::vector<TextRow> rows{
      {"condition", "n", "changed", "mode", "first", "second", "difference", "interval", "p", "worth"}};
  for (std::size_t i = 0; i < runs.conditions.size(); ++i) {
    const auto& compared = runs.conditions[i];
    most = std::max(most, compared.realisations);
    for (const auto& [mode, found] : compared.modes) {
      const auto& factor = found.variance_reduction;
      const std::uint64_t in_first = found.counts.both + found.counts.first_only;
      const std::uint64_t in_second = found.counts.both + found.counts.second_only;
      rows.push_back(
          {name_of(runs, i), std::to_string(compared.realisations), std::to_string(compared.changed.successes),
           to_string(mode), per_cent(found.in_first) + count_if_open(in_first, compared.realisations),
           per_cent(found.in_second) + count_if_open(in_second, compared.realisations), per_cent(found.difference),
           per_cent(found.exact), significant(found.test.p_value, 2), factor ? significant(*factor, 2) + "x" : "."});
    }
  }
  return text + aligned(rows) +
         "\nper cent of n realisations with common random numbers; difference = first - second with its exact " +
         level_of(runs) + ";\np: exact McNemar test, one of " + std::to_string(number_of_tests(runs.conditions)) +
         "; worth: variance with independent random numbers over that with common ones" + count_legend(most) + '\n';
}

}  // namespace rocking
