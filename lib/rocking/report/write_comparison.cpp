#include "rocking/report/write_comparison.hpp"

#include "rocking/report/json.hpp"
#include "rocking/report/mode_table.hpp"
#include "rocking/report/read_report.hpp"
#include "rocking/report/result_json.hpp"
#include "rocking/report/text_table.hpp"

namespace rocking::report {
namespace {

using stats::Interval;
using stats::PairedCounts;

Json mode_json(const PairedCounts& counts, double confidence) {
  Json json = Json::object();
  json["both"] = counts.both;
  json["first_only"] = counts.first_only;
  json["second_only"] = counts.second_only;
  json["neither"] = counts.neither;
  json["difference"] = stats::paired_difference(counts);
  json["score"] = interval_json(stats::paired_difference_score(counts, confidence));
  json["exact"] = interval_json(stats::paired_difference_exact(counts, confidence));
  const stats::McNemar test = stats::mcnemar(counts);
  json["mcnemar_p_value"] = test.p_value;
  json["mcnemar_mid_p"] = test.mid_p;
  const auto factor = stats::variance_reduction(counts).factor;
  json["variance_reduction"] = factor ? Json(*factor) : Json();
  return json;
}

double confidence_of(const ComparedRuns& runs, std::size_t condition) { return runs.first->conditions[condition].confidence; }

std::string level_of(const ComparedRuns& runs) {
  const auto common = experiment::common_confidence(*runs.first);
  return common ? level_text(*common) + " % interval" : "interval at the confidence of each condition";
}

std::size_t number_of_tests(const ComparedRuns& runs) {
  std::size_t tests = 0;
  for (const auto& condition : runs.conditions) tests += condition.modes.size();
  return tests;
}

double share(std::uint64_t part, std::uint64_t whole) { return static_cast<double>(part) / static_cast<double>(whole); }

std::string name_of(const ComparedRuns& runs, std::size_t condition) {
  std::string name;
  for (const experiment::Parameter& parameter : runs.first->conditions[condition].parameters) {
    name += (name.empty() ? "" : ", ") + short_value(parameter);
  }
  return name.empty() ? std::to_string(condition) : name;
}

}  // namespace

std::string comparison_text(const ComparedRuns& runs) {
  Json json = Json::object();
  json["format"] = comparison_format;
  json["settings"] = experiment_differences(runs.first->canonical_text, runs.second->canonical_text);
  const auto common = experiment::common_confidence(*runs.first);
  json["confidence"] = common ? Json(*common) : Json();
  json["tests"] = number_of_tests(runs);
  Json& conditions = json["conditions"] = Json::array();
  for (std::size_t i = 0; i < runs.conditions.size(); ++i) {
    const experiment::ConditionComparison& compared = runs.conditions[i];
    const double confidence = confidence_of(runs, i);
    Json entry = Json::object();
    entry["parameters"] = parameters_json(runs.first->conditions[i]);
    entry["confidence"] = confidence;
    entry["realisations"] = compared.realisations;
    entry["changed"] = {{"count", compared.changed.successes},
                        {"interval", interval_json(stats::clopper_pearson(compared.changed, confidence))}};
    Json& modes = entry["modes"] = Json::object();
    for (const auto& [mode, counts] : compared.modes) modes[to_string(mode)] = mode_json(counts, confidence);
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
  std::vector<TextRow> rows{
      {"condition", "n", "changed", "mode", "first", "second", "difference", "interval", "p", "worth"}};
  for (std::size_t i = 0; i < runs.conditions.size(); ++i) {
    const auto& compared = runs.conditions[i];
    for (const auto& [mode, counts] : compared.modes) {
      const auto factor = stats::variance_reduction(counts).factor;
      rows.push_back({name_of(runs, i), std::to_string(compared.realisations),
                      std::to_string(compared.changed.successes), to_string(mode),
                      per_cent(share(counts.both + counts.first_only, counts.trials())),
                      per_cent(share(counts.both + counts.second_only, counts.trials())),
                      per_cent(stats::paired_difference(counts)),
                      per_cent(stats::paired_difference_exact(counts, confidence_of(runs, i))),
                      significant(stats::mcnemar(counts).p_value, 2), factor ? significant(*factor, 2) + "x" : "."});
    }
  }
  return text + aligned(rows) +
         "\nper cent of n realisations with common random numbers; difference = first - second with its exact " +
         level_of(runs) + ";\np: exact McNemar test, one of " + std::to_string(number_of_tests(runs)) +
         "; worth: variance with independent random numbers over that with common ones\n";
}

}  // namespace rocking::report
