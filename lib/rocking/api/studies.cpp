#include "rocking/api/studies.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "rocking/api/refuse.hpp"
#include "rocking/api/written_experiment.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/output/write_fragility.hpp"
#include "rocking/output/write_orbits.hpp"
#include "rocking/section/period.hpp"
#include "rocking/store/store.hpp"
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

std::string orbits(const Experiment& experiment, int longest, const Execution& execution) {
  expect("longest", longest, 1, static_cast<int>(section::longest_period));
  check_orbits(experiment);
  std::atomic<bool> own_flag{false};
  std::atomic<bool>& stop = execution.stop != nullptr ? *execution.stop : own_flag;
  RunOptions options;
  options.threads = std::max(1U, execution.threads);
  options.stop_requested = &stop;
  if (execution.on_progress) {
    options.on_progress = [&](std::uint64_t done, std::uint64_t all) {
      if (execution.on_progress(done, all) == Decision::stop) stop = true;
    };
  }
  auto conditions = orbits(experiment, longest, options);
  if (!conditions) throw base::Stopped();
  const Experiment told = with_text(experiment);
  return orbits_text({.experiment = &told, .longest = longest, .conditions = std::move(*conditions)});
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
