#include "rocking/api/studies.hpp"

#include <string_view>
#include <utility>

#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/api/written_experiment.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/output/write_bifurcation.hpp"
#include "rocking/output/write_comparison.hpp"
#include "rocking/output/write_fragility.hpp"
#include "rocking/output/write_orbits.hpp"
#include "rocking/section/period.hpp"
#include "rocking/store/store.hpp"
#include "rocking/studies/bifurcation.hpp"
#include "rocking/studies/comparison.hpp"
#include "rocking/studies/fragility.hpp"
#include "rocking/studies/orbits/orbits.hpp"
#include "rocking/studies/suite/stripes.hpp"
#include "rocking/studies/suite/suite_curve.hpp"

namespace rocking {
namespace {

template <class Number>
void expect(std::string_view name, Number value, Number least, Number largest) {
  if (least <= value && value <= largest) return;
  refuse(name, std::to_string(value),
         "must be a whole number from " + std::to_string(least) + " to " + std::to_string(largest));
}

constexpr std::uint64_t largest_realisation = 999'999'999;
constexpr std::int64_t most_periods = 100'000'000;
constexpr int most_samples = 100'000;

}  // namespace

Trajectory trajectory(const Experiment& experiment, const TrajectoryRequest& request) {
  expect("condition", request.condition, std::uint64_t{0}, std::uint64_t{experiment.conditions.size() - 1});
  expect("realisation", request.realisation, std::uint64_t{0}, largest_realisation);
  expect("periods", request.periods, std::int64_t{0}, most_periods);
  expect("samples_per_period", request.samples_per_period, 0, most_samples);
  const Condition& condition = experiment.conditions[request.condition];
  const std::int64_t horizon = std::int64_t{condition.horizon.transient_periods} + condition.horizon.sampled_periods;
  return trajectory_of(condition, experiment.seed, request.realisation,
                       TrajectoryExtent(request.periods > 0 ? request.periods : horizon, request.samples_per_period));
}

std::string trajectory_text(const TrajectoryRequest& request, const Trajectory& trajectory, TrajectoryUnits units) {
  return trajectory_text(RealisationKey{request.condition, request.realisation}, trajectory, units);
}

std::string trajectory_csv(const TrajectoryRequest& request, const Trajectory& trajectory, TrajectoryUnits units) {
  return trajectory_csv(RealisationKey{request.condition, request.realisation}, trajectory, units);
}

std::string orbits(const Experiment& experiment, int longest, const Execution& execution) {
  expect("longest", longest, 1, static_cast<int>(section::longest_period));
  check_orbits(experiment);
  auto conditions = orbits(experiment, longest, AskedOptions(execution).options());
  if (!conditions) throw base::Stopped();
  const Experiment told = with_text(experiment);
  return orbits_text({.experiment = &told, .longest = longest, .conditions = std::move(*conditions)});
}

std::vector<ConditionComparison> compare(const StoredRun& first, const StoredRun& second) {
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
  std::vector<double> confidences;
  for (const Condition& condition : experiment.conditions) confidences.push_back(condition.confidence);
  return compare(*first.run.store, *second.run.store, confidences);
}

std::string comparison(const StoredRun& first, const StoredRun& second) {
  auto conditions = compare(first, second);
  const Experiment one = with_text(first.experiment);
  const Experiment other = with_text(second.experiment);
  return comparison_text({.first = &one, .second = &other, .conditions = std::move(conditions)});
}

std::vector<Diagram> diagrams(const Experiment& experiment, std::uint64_t realisation, const Execution& execution) {
  expect("realisation", realisation, std::uint64_t{0}, largest_realisation);
  auto found = bifurcation(experiment, realisation, AskedOptions(execution).options());
  if (!found) throw base::Stopped();
  return std::move(*found);
}

std::string bifurcation(const Experiment& experiment, std::uint64_t realisation, const Execution& execution) {
  return bifurcation_text({.experiment = &experiment,
                           .realisation = realisation,
                           .diagrams = diagrams(experiment, realisation, execution)});
}

std::string fragility(const Experiment& experiment, const RunResult& run) {
  if (intensity_of(experiment).empty()) {
    refuse("/sweep", "",
           "sweeps no intensity of the excitation: /excitation/amplitude (or amplitude_g, amplitude_m_s2) or "
           "/excitation/scale (or pga_g, pgv_m_s)");
  }
  if (experiment.conditions.front().until) {
    refuse("/realisations", "until", "a fragility function needs a fixed number of realisations");
  }
  RunFragility found{.experiment = with_text(experiment)};
  for (const StripeGroup& group : stripes_of(found.experiment, *run.store, false)) {
    if (group.is_suite()) {
      found.suites.push_back({.curve = suite_curve(group, {}, experiment.seed)});
    } else {
      found.curves.push_back({.curve = fragility(group, {}, experiment.seed)});
    }
  }
  return fragility_text({found});
}

}  // namespace rocking
