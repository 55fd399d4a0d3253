#include "rocking/studies/cost/study.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/studies/cost/budget.hpp"
#include "rocking/studies/cost/result.hpp"

namespace rocking {

void check_request(const Experiment& experiment, const CostRequest& request) {
  if (!request.elapsed_seconds || !request.processor_seconds) {
    throw std::invalid_argument("a measurement of cost needs both clocks: elapsed_seconds and processor_seconds");
  }
  check_has_conditions(experiment);
  check_fields(request);
  if (cost_tolerances(experiment, request.tolerances).size() < 3) {
    refuse("tolerances", "",
           "are fewer than three with the experiment's own; the tightest is the reference and the second tightest the "
           "floor, so give at least three, for example 1e-8, 1e-11, 1e-14");
  }
}

Cost cost(const Experiment& experiment, const CostRequest& request, const Execution& execution) {
  check_request(experiment, request);
  const std::vector<double> tolerances = cost_tolerances(experiment, request.tolerances);
  const double start = request.elapsed_seconds();
  auto found = cost_within(experiment, tolerances, {.seconds = request.seconds, .sample = request.sample},
                           {.elapsed_seconds = [&] { return request.elapsed_seconds() - start; },
                            .processor_seconds = request.processor_seconds},
                           OptionsOfExecution(execution).options());
  if (!found) throw base::Stopped();
  return std::move(*found);
}

std::string cost_text(const Experiment& experiment, const Cost& cost, const Provenance& provenance) {
  return cost_document().text(cost_report({.experiment = &experiment, .cost = cost, .system = facts_of(provenance)}));
}

}  // namespace rocking
