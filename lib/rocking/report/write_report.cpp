#include "rocking/report/write_report.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/base/error.hpp"
#include "rocking/report/provenance_json.hpp"
#include "rocking/report/result_json.hpp"

namespace rocking::report {
namespace {

Json floor_json(const experiment::Experiment& experiment, const experiment::ExperimentResult& result) {
  return noise_floor_json(experiment::noise_floor(result.conditions, experiment::highest_confidence(experiment)));
}

void write_result(JsonWriter& out, const experiment::Experiment& experiment,
                  const experiment::ExperimentResult& result) {
  out.begin_object("result");
  out.member("digest", base::to_hex(result.digest));
  out.member("noise_floor", floor_json(experiment, result));
  out.begin_list("conditions");
  for (std::size_t i = 0; i < result.conditions.size(); ++i) {
    out.element(condition_json(experiment.conditions[i], result.conditions[i]));
  }
  out.end();
  out.end();
}

void write_internal(JsonWriter& out, const experiment::ExperimentResult& result) {
  experiment::Effort effort;
  experiment::Clamps clamps;
  for (const experiment::ConditionResult& condition : result.conditions) {
    effort += condition.effort;
    clamps += condition.validity.clamps;
  }
  out.begin_object("internal");
  out.member("total", effort_json(effort, clamps));
  out.begin_list("conditions");
  for (const experiment::ConditionResult& condition : result.conditions) {
    out.element(effort_json(condition.effort, condition.validity.clamps));
  }
  out.end();
  out.end();
}

}  // namespace

void write_report(const TextSink& sink, const experiment::Experiment& experiment,
                  const experiment::ExperimentResult& result, const SystemFacts& system) {
  ROCKING_EXPECT(experiment.conditions.size() == result.conditions.size());
  JsonWriter out(sink);
  out.begin_object();
  out.member("format", report_format);
  out.member("input", input_json(experiment));
  write_result(out, experiment, result);
  out.member("system", system_json(system));
  write_internal(out, result);
  out.end();
  sink("\n");
}

Json report_frame(const experiment::Experiment& experiment, const experiment::ExperimentResult& result,
                  const SystemFacts& system) {
  Json frame = Json::object();
  frame["format"] = report_format;
  frame["input"] = input_json(experiment);
  frame["result"]["digest"] = base::to_hex(result.digest);
  frame["result"]["noise_floor"] = floor_json(experiment, result);
  frame["system"] = system_json(system);
  return frame;
}

std::string report_text(const experiment::Experiment& experiment, const experiment::ExperimentResult& result,
                        const SystemFacts& system) {
  std::string text;
  write_report([&text](std::string_view piece) { text += piece; }, experiment, result, system);
  return text;
}

}  // namespace rocking::report
