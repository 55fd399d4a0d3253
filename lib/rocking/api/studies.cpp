#include "rocking/api/studies.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/trajectory_extent.hpp"
#include "rocking/api/written_experiment.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/input/condition_family.hpp"
#include "rocking/input/read_hazard.hpp"
#include "rocking/output/bifurcation_report.hpp"
#include "rocking/output/comparison.hpp"
#include "rocking/output/fragility_report.hpp"
#include "rocking/output/write_orbits.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/section/period.hpp"
#include "rocking/store/store.hpp"
#include "rocking/studies/bifurcation.hpp"
#include "rocking/studies/comparison.hpp"
#include "rocking/studies/orbits/bifurcation_curve.hpp"
#include "rocking/studies/orbits/branches.hpp"
#include "rocking/studies/orbits/orbits.hpp"
#include "rocking/text/files.hpp"

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

void check_request(const Experiment& experiment, const TrajectoryRequest& request) {
  check_has_conditions(experiment);
  expect("condition", request.condition, std::uint64_t{0}, std::uint64_t{experiment.conditions.size() - 1});
  expect("realisation", request.realisation, std::uint64_t{0}, largest_realisation);
  expect("periods", request.periods, std::int64_t{0}, most_periods);
  expect("samples_per_period", request.samples_per_period, 0, most_samples);
}

std::int64_t periods_of(const Experiment& experiment, const TrajectoryRequest& request) {
  const Horizon& horizon = experiment.conditions[request.condition].horizon;
  return request.periods > 0 ? request.periods : std::int64_t{horizon.transient_periods} + horizon.sampled_periods;
}

Trajectory trajectory(const Experiment& experiment, const TrajectoryRequest& request, const Execution& execution) {
  check_request(experiment, request);
  return trajectory_of(experiment.conditions[request.condition], experiment.seed, request.realisation,
                       TrajectoryExtent(periods_of(experiment, request), request.samples_per_period, execution.stop));
}

std::string trajectory_text(const TrajectoryRequest& request, const Trajectory& trajectory, TrajectoryUnits units) {
  return trajectory_text(RealisationKey{request.condition, request.realisation}, trajectory, units);
}

std::string trajectory_csv(const TrajectoryRequest& request, const Trajectory& trajectory, TrajectoryUnits units) {
  return trajectory_csv(RealisationKey{request.condition, request.realisation}, trajectory, units);
}

namespace {

std::vector<OrbitsOfCondition> found_orbits(const Experiment& experiment, int longest,
                                            const OptionsOfExecution& asked) {
  expect("longest", longest, 1, static_cast<int>(section::longest_period));
  check_has_conditions(experiment);
  check_orbits(experiment);
  auto conditions = orbits(experiment, longest, asked.options());
  if (!conditions) throw base::Stopped();
  return std::move(*conditions);
}

/// What is asked of branches. Throws where there are none.
BranchQuestion branch_question(const Experiment& experiment, const OrbitsRequest& request, const std::string& pointer,
                               const std::vector<double>& values) {
  BranchQuestion question{.conditions = condition_family(experiment, pointer),
                          .values = values,
                          .range = {},
                          .most_points = request.most_points,
                          .most_branches = request.most_branches};
  const auto [least, greatest] = std::ranges::minmax(values);
  question.range = {.low = request.from.value_or(least), .high = request.to.value_or(greatest)};
  if (!(question.range.low < question.range.high)) {
    refuse("from", base::shortest(question.range.low),
           "must be less than the end of the range of branches, " + base::shortest(question.range.high));
  }
  return question;
}

/// Adds the orbits on branches at the conditions to those that are known.
FoundBranches followed(const Experiment& experiment, const OrbitsRequest& request, base::StopRequest stop,
                       std::vector<OrbitsOfCondition>& conditions) {
  const auto swept = experiment.canonical_text.empty() ? std::nullopt : only_swept_number(experiment);
  if (!swept || !can_be_continued(swept->pointer)) {
    refuse("branches", "", "are followed over the sweep of one number of the motion alone; the experiment has none");
  }
  const BranchQuestion question = branch_question(experiment, request, swept->pointer, swept->values);
  return {.pointer = swept->pointer,
          .range = question.range,
          .most_points = request.most_points,
          .study = branches_of(question, conditions, stop)};
}

/// The second parameter and its range, without the curves. Throws where they cannot be followed.
FoundCurves curve_request(const Experiment& experiment, const OrbitsRequest& request) {
  if (experiment.canonical_text.empty()) refuse("second", request.second.front(), "needs an experiment with text");
  if (!request.branches) refuse("second", request.second.front(), "needs branches, whose bifurcations are followed");
  if (!request.second_from || !request.second_to || !(*request.second_from < *request.second_to)) {
    refuse("second_from", "", "and second_to must be given, the first below the second: the range of the parameter");
  }
  for (const std::string& pointer : request.second) {
    if (can_be_continued(pointer)) continue;
    refuse("second", pointer,
           "is no real number on which the motion depends continuously, such as /excitation/frequency_ratio or "
           "/friction/static");
  }
  FoundCurves found{.pointers = request.second,
                    .value = second_parameter(experiment, request.second).value,
                    .range = {.low = *request.second_from, .high = *request.second_to},
                    .most_points = request.most_curve_points,
                    .curves = {}};
  if (found.value >= found.range.low && found.value <= found.range.high) return found;
  refuse("second_from", base::shortest(found.range.low),
         "and second_to, " + base::shortest(found.range.high) + ", must enclose the value of the experiment, " +
             base::shortest(found.value));
}

std::vector<BifurcationCurve> followed_curves(const Experiment& experiment, const FoundBranches& branches,
                                              const FoundCurves& asked, base::StopRequest stop) {
  const SecondParameter second{.pointers = asked.pointers, .value = asked.value};
  const CurveQuestion question{.conditions = condition_plane(experiment, branches.pointer, second),
                               .ranges = {branches.range, asked.range},
                               .second = asked.value,
                               .most_points = asked.most_points};
  return bifurcation_curves(question, branches.study, stop);
}

FoundOrbits reported(const Experiment& experiment, const OrbitStudy& study) {
  check_has_conditions(experiment);
  return {.experiment = &experiment,
          .longest = study.longest,
          .conditions = study.conditions,
          .branches = study.branches,
          .curves = study.curves};
}

}  // namespace

std::vector<std::vector<PeriodicOrbit>> periodic_orbits(const Experiment& experiment, int longest,
                                                        const Execution& execution) {
  std::vector<std::vector<PeriodicOrbit>> all;
  for (const OrbitsOfCondition& condition : found_orbits(experiment, longest, OptionsOfExecution(execution))) {
    auto& here = all.emplace_back();
    for (const Orbit& orbit : condition.orbits) {
      PeriodicOrbit& found = here.emplace_back();
      found.period = orbit.period;
      found.cycles = orbit.cycles;
      for (const SectionState& state : orbit.points) found.points.push_back(state.point);
      found.multipliers = orbit.stability.multipliers;
      found.kind = to_string(orbit.stability.kind);
      found.is_stable = orbit.stability.is_stable();
      found.residual = orbit.residual;
    }
  }
  return all;
}

OrbitStudy orbit_study(const Experiment& experiment, const OrbitsRequest& request, const Execution& execution) {
  expect("most_points", request.most_points, std::uint64_t{2}, std::uint64_t{1'000'000});
  expect("most_branches", request.most_branches, std::uint64_t{1}, std::uint64_t{100'000});
  expect("most_curve_points", request.most_curve_points, std::uint64_t{1}, std::uint64_t{1'000'000});
  const OptionsOfExecution asked(execution);
  OrbitStudy study{.longest = request.longest, .conditions = {}};
  if (!request.second.empty()) study.curves = curve_request(experiment, request);
  study.conditions = found_orbits(experiment, request.longest, asked);
  if (request.branches) study.branches = followed(experiment, request, asked.stop(), study.conditions);
  if (study.curves) {
    study.curves->curves = followed_curves(experiment, *study.branches, *study.curves, asked.stop());
  }
  return study;
}

std::string orbits_text(const Experiment& experiment, const OrbitStudy& study) {
  const Experiment with = with_text(experiment);
  return orbits_text(reported(with, study));
}

std::string orbits_table(const Experiment& experiment, const OrbitStudy& study) {
  return orbits_table(reported(experiment, study));
}

std::string orbits(const Experiment& experiment, const OrbitsRequest& request, const Execution& execution) {
  return orbits_text(experiment, orbit_study(experiment, request, execution));
}

std::string orbits(const Experiment& experiment, int longest, const Execution& execution) {
  return orbits(experiment, OrbitsRequest{.longest = longest}, execution);
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
  std::vector<double> confidences;
  for (const Condition& condition : experiment.conditions) confidences.push_back(condition.confidence);
  return comparison_of(with_text(experiment), with_text(second.experiment),
                       compare(store_of(first.run), store_of(second.run), confidences));
}

std::string comparison_text(const Comparison& found) { return comparison_document().text(found); }

std::vector<Diagram> diagrams(const Experiment& experiment, std::uint64_t realisation, const Execution& execution) {
  expect("realisation", realisation, std::uint64_t{0}, largest_realisation);
  check_has_conditions(experiment);
  auto found = bifurcation(experiment, realisation, OptionsOfExecution(execution).options());
  if (!found) throw base::Stopped();
  return std::move(*found);
}

std::string bifurcation(const Experiment& experiment, std::uint64_t realisation, const Execution& execution) {
  return bifurcation_document().text(
      bifurcation_report(experiment, realisation, diagrams(experiment, realisation, execution)));
}

RunFragility fragility_curves(const Experiment& experiment, const RunResult& run, const FragilityQuestion& question,
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
  for (const double tilt : question.peak_tilts) {
    if (!(tilt >= 1e-9 && tilt <= 1e9)) refuse("peak_tilts", base::shortest(tilt), "must be from 1e-9 to 1e9");
  }
  return run_fragility(experiment, stripes_of(experiment, store_of(run)), question,
                       OptionsOfExecution(execution).options());
}

std::string fragility(const Experiment& experiment, const RunResult& run, const FragilityQuestion& question,
                      const Execution& execution) {
  return fragility_document().text(
      fragility_report({fragility_curves(with_text(experiment), run, question, execution)}));
}

HazardCurve hazard_curve(const std::filesystem::path& file) {
  return read_hazard(read_file(file, most_hazard_bytes), file.string());
}

}  // namespace rocking
