#include "rocking/api/studies.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/rare_of_curves.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/trajectory_extent.hpp"
#include "rocking/api/written_experiment.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/input/read_hazard.hpp"
#include "rocking/input/read_record_metadata.hpp"
#include "rocking/output/bifurcation_report.hpp"
#include "rocking/output/comparison.hpp"
#include "rocking/output/fragility_report.hpp"
#include "rocking/output/trajectory_report.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/store/store.hpp"
#include "rocking/studies/bifurcation.hpp"
#include "rocking/studies/comparison.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

constexpr std::uint64_t largest_realisation = 999'999'999;

}  // namespace

void check_request(const Experiment& experiment, const TrajectoryRequest& request) {
  check_has_conditions(experiment);
  expect("condition", request.condition, std::uint64_t{0}, std::uint64_t{experiment.conditions.size() - 1});
  check_fields(request);
}

std::int64_t periods_of(const Experiment& experiment, const TrajectoryRequest& request) {
  const Horizon& horizon = experiment.conditions[request.condition].horizon;
  return request.periods.value_or(std::int64_t{horizon.transient_periods} + horizon.sampled_periods);
}

Trajectory trajectory(const Experiment& experiment, const TrajectoryRequest& request, const Execution& execution) {
  check_request(experiment, request);
  return trajectory_of(experiment.conditions[request.condition], experiment.seed, request.realisation,
                       TrajectoryExtent(periods_of(experiment, request), request.samples_per_period, execution.stop));
}

std::string trajectory_text(const TrajectoryRequest& request, const Trajectory& trajectory, TrajectoryUnits units) {
  return trajectory_document().text(trajectory_report({request.condition, request.realisation}, trajectory, units));
}

std::string trajectory_csv(const TrajectoryRequest& request, const Trajectory& trajectory, TrajectoryUnits units) {
  return trajectory_table(trajectory_report({request.condition, request.realisation}, trajectory, units));
}

Comparison compare(const StoredRun& first, const StoredRun& second) {
  const Experiment& experiment = first.experiment;
  if (second.experiment.seed != experiment.seed) {
    refuse("/seed", std::to_string(second.experiment.seed),
           "is another than that of the first run (" + std::to_string(experiment.seed) +
               "), so that the runs have no common random numbers; run one of them with the seed of the other");
  }
  if (second.experiment.conditions.size() != experiment.conditions.size()) {
    refuse("/sweep", "",
           "gives the runs different numbers of conditions: " + std::to_string(experiment.conditions.size()) + " and " +
               std::to_string(second.experiment.conditions.size()));
  }
  if (const auto place = condition_with_other_record(experiment, second.experiment)) {
    refuse("/excitation/suite", "",
           "gives condition " + std::to_string(*place) +
               " of the runs different records, so that they have no common random numbers; run both with the same "
               "records in the same order");
  }
  std::vector<double> confidences;
  for (const Condition& condition : experiment.conditions) confidences.push_back(condition.confidence);
  return comparison_of(with_text(experiment), with_text(second.experiment),
                       compare(store_of(first.run), store_of(second.run), confidences));
}

std::string compare_text(const Comparison& found) { return comparison_document().text(found); }

std::vector<Diagram> bifurcation(const Experiment& experiment, std::uint64_t realisation, const Execution& execution) {
  expect("realisation", realisation, std::uint64_t{0}, largest_realisation);
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

namespace {

void check(const FragilityQuestion& question) {
  QuestionCheck check(question);
  if (question.hazard) check.add(problems_of(*question.hazard));
  check.finish();
  if (const auto second = second_estimate(question.rare)) {
    const std::string intensity = base::shortest(question.rare[*second].level.intensity);
    refuse("rare/" + std::to_string(*second), "intensity " + intensity, "is a second estimate of the same probability");
  }
}

}  // namespace

RunFragility fragility(const Experiment& experiment, const RunResult& run, const FragilityQuestion& question,
                       const Execution& execution) {
  check_has_conditions(experiment);
  if (intensity_of(experiment).empty()) {
    refuse("/sweep", "",
           "sweeps no intensity of the excitation: /excitation/amplitude (or amplitude_g, amplitude_m_s2) or "
           "/excitation/scale (or pga_g, pgv_m_s)");
  }
  if (experiment.conditions.front().until) {
    refuse("/realisations", "until", "a fragility function needs a fixed number of realisations");
  }
  check(question);
  return run_fragility(with_text(experiment), stripes_of(experiment, store_of(run)), question,
                       OptionsOfExecution(execution).options());
}

std::string fragility_text(const RunFragility& found) { return fragility_document().text(fragility_report({found})); }

HazardCurve hazard_curve(const std::filesystem::path& file, const HazardReading& reading) {
  return read_hazard(read_file(file, most_hazard_bytes), file.string(), reading);
}

std::vector<RecordMetadata> record_metadata(const std::filesystem::path& file) {
  return read_record_metadata(read_file(file, most_metadata_bytes), file.string());
}

}  // namespace rocking
