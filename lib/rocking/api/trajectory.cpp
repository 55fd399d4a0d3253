#include "rocking/api/trajectory.hpp"

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/output/trajectory_report.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {

void check_request(const Experiment& experiment, const TrajectoryRequest& request) {
  check_has_conditions(experiment);
  expect("condition", request.condition, std::uint64_t{0}, std::uint64_t{experiment.conditions.size() - 1});
  check_fields(request);
}

std::int64_t periods_of(const Experiment& experiment, const TrajectoryRequest& request) {
  const Horizon& horizon = experiment.conditions[request.condition].horizon;
  return request.periods.value_or(horizon.periods());
}

Trajectory trajectory(const Experiment& experiment, const TrajectoryRequest& request, const Execution& execution) {
  check_request(experiment, request);
  const Condition& condition = experiment.conditions[request.condition];
  Trajectory found =
      trajectory_of(condition, experiment.seed, request.realisation,
                    TrajectoryExtent(periods_of(experiment, request), request.samples_per_period, execution.stop));
  if (!request.periods) {
    found.label = realise(condition, experiment.seed, request.realisation, execution.stop).classification;
  }
  return found;
}

TrajectoryInSi in_si(const Trajectory& trajectory) {
  const TrajectoryReport report = trajectory_report({}, trajectory, TrajectoryUnits::si);
  TrajectoryInSi found;
  const auto add = [](const auto& rows, std::vector<StateInSi>& states) {
    for (const auto& row : rows) {
      states.push_back({row.time, row.state.tilt, row.state.tilt_rate, row.state.slip, row.state.slip_rate});
    }
  };
  add(report.strobe, found.strobe);
  add(report.events, found.events);
  add(report.history, found.history);
  return found;
}

std::string trajectory_text(const TrajectoryRequest& request, const Trajectory& trajectory, TrajectoryUnits units) {
  return trajectory_document().text(trajectory_report({request.condition, request.realisation}, trajectory, units));
}

std::string trajectory_csv(const TrajectoryRequest& request, const Trajectory& trajectory, TrajectoryUnits units) {
  return trajectory_table(trajectory_report({request.condition, request.realisation}, trajectory, units));
}

}  // namespace rocking
