#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/studies/bifurcation/bifurcation.hpp"
#include "rocking/studies/bifurcation/result.hpp"

namespace rocking {

std::vector<Diagram> bifurcation(const Experiment& experiment, std::uint64_t realisation, const Execution& execution) {
  expect("realisation", realisation, std::uint64_t{0}, std::uint64_t{999'999'999});
  check_has_conditions(experiment);
  auto found = bifurcation(experiment, realisation, OptionsOfExecution(execution).options());
  if (!found) throw base::Stopped();
  return std::move(*found);
}

std::string bifurcation_text(const Experiment& experiment, std::uint64_t realisation,
                             const std::vector<Diagram>& found) {
  for (const Diagram& diagram : found) {
    for (const std::size_t condition : diagram.conditions) {
      if (condition < experiment.conditions.size()) continue;
      refuse("found", "condition " + std::to_string(condition), "is one of an experiment with more conditions");
    }
  }
  return bifurcation_document().text(bifurcation_report(experiment, realisation, found));
}

}  // namespace rocking
