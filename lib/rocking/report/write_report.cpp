#include "rocking/report/write_report.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/base/error.hpp"
#include "rocking/report/provenance_json.hpp"
#include "rocking/report/result_json.hpp"

namespace rocking::report {
namespace {

Json all_conditions_json(const experiment::Experiment& experiment, const experiment::ExperimentResult& result) {
  Json json = Json::object();
  json["digest"] = base::to_hex(result.digest);
  json["noise_floor"] =
      noise_floor_json(experiment::noise_floor(result.conditions, experiment.conditions.front().confidence));
  Json& conditions = json["conditions"] = Json::array();
  for (std::size_t i = 0; i < result.conditions.size(); ++i) {
    conditions.push_back(condition_json(experiment.conditions[i], result.conditions[i]));
  }
  return json;
}

Json internal_json(const experiment::ExperimentResult& result) {
  experiment::Effort effort;
  experiment::Clamps clamps;
  Json conditions = Json::array();
  for (const experiment::ConditionResult& condition : result.conditions) {
    conditions.push_back(effort_json(condition.effort, condition.validity.clamps));
    effort += condition.effort;
    clamps += condition.validity.clamps;
  }
  Json json = Json::object();
  json["total"] = effort_json(effort, clamps);
  json["conditions"] = std::move(conditions);
  return json;
}

}  // namespace

std::string report_text(const experiment::Experiment& experiment, const experiment::ExperimentResult& result,
                        const SystemFacts& system) {
  ROCKING_EXPECT(experiment.conditions.size() == result.conditions.size());
  Json report = Json::object();
  report["format"] = report_format;
  report["input"] = input_json(experiment);
  report["result"] = all_conditions_json(experiment, result);
  report["system"] = system_json(system);
  report["internal"] = internal_json(result);
  return report.dump(2) + '\n';
}

}  // namespace rocking::report
