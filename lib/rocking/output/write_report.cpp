#include "rocking/output/write_report.hpp"

#include "rocking/base/digest.hpp"
#include "rocking/base/error.hpp"
#include "rocking/output/provenance_json.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/text/schema.hpp"

namespace rocking {
namespace {

void write_result(JsonWriter& out, const Experiment& experiment, const ExperimentResult& result) {
  out.begin_object("result");
  out.member("digest", base::to_hex(result.digest));
  out.member("tolerance_sensitivity", tolerance_sensitivity_json(result.tolerance_sensitivity));
  out.begin_list("conditions");
  for (std::size_t i = 0; i < result.conditions.size(); ++i) {
    out.element(condition_json(experiment.conditions[i], result.conditions[i]));
  }
  out.end();
  out.end();
}

void write_internal(JsonWriter& out, const ExperimentResult& result) {
  OperationCounts operations;
  Clamps clamps;
  for (const ConditionResult& condition : result.conditions) {
    operations += condition.operations;
    clamps += condition.validity.clamps;
  }
  out.begin_object("internal");
  out.member("total", operation_counts_json(operations, clamps));
  out.begin_list("conditions");
  for (const ConditionResult& condition : result.conditions) {
    out.element(operation_counts_json(condition.operations, condition.validity.clamps));
  }
  out.end();
  out.end();
}

}  // namespace

void write_report(const TextSink& sink, const Experiment& experiment, const ExperimentResult& result,
                  const SystemFacts& system) {
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

Json report_frame(const Experiment& experiment, const ExperimentResult& result, const SystemFacts& system) {
  Json frame = Json::object();
  frame["format"] = report_format;
  frame["input"] = input_json(experiment);
  frame["result"]["digest"] = base::to_hex(result.digest);
  frame["result"]["tolerance_sensitivity"] = tolerance_sensitivity_json(result.tolerance_sensitivity);
  frame["system"] = system_json(system);
  return frame;
}

std::string report_text(const Experiment& experiment, const ExperimentResult& result, const SystemFacts& system) {
  std::string text;
  write_report([&text](std::string_view piece) { text += piece; }, experiment, result, system);
  return text;
}

}  // namespace rocking
