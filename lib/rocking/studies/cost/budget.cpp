#include "rocking/studies/cost/budget.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "rocking/ensemble/run.hpp"
#include "rocking/studies/cost/cost.hpp"
#include "rocking/studies/cost/measurement.hpp"

namespace rocking {
namespace {

/// Time for the measurement of speed, relative to the time for the sample. Together they take the requested time; if
/// the sample takes less than its share, the measurement of speed may take a few seconds.
constexpr double timing_share = 1.0 / 3.0;
constexpr double few_seconds = 5.0;

double time_for_sample(const CostBudget& budget) { return budget.seconds / (1.0 + timing_share); }

/// Realisations that a measurement will reach in its time, judged by those that are done.
std::uint64_t expected_sample(const CostBudget& budget, std::uint64_t done, double elapsed_seconds) {
  const double all = static_cast<double>(done) * time_for_sample(budget) / std::max(elapsed_seconds, 1e-9);
  return std::max(done, static_cast<std::uint64_t>(std::min(all, static_cast<double>(largest_cost_sample))));
}

}  // namespace

std::vector<double> cost_tolerances(const Experiment& experiment, std::span<const double> asked) {
  if (asked.empty()) return tolerance_ladder(experiment);
  std::set<double, std::greater<>> all(asked.begin(), asked.end());
  const std::vector<double> own = own_tolerances(experiment);
  all.insert(own.begin(), own.end());
  return {all.begin(), all.end()};
}

std::optional<Cost> cost_within(const Experiment& experiment, std::span<const double> tolerances,
                                const CostBudget& budget, const CostClocks& clocks, const RunOptions& options) {
  CostPlan plan{.tolerances = {tolerances.begin(), tolerances.end()},
                .sample = budget.sample.value_or(largest_cost_sample)};
  const double time = time_for_sample(budget);
  if (!budget.sample) plan.is_enough = [&clocks, time] { return clocks.elapsed_seconds() >= time; };
  RunOptions sampling = options;
  if (options.on_progress && !budget.sample) {
    sampling.on_progress = [&](std::uint64_t done, std::uint64_t all) {
      options.on_progress(done, std::min(all, expected_sample(budget, done, clocks.elapsed_seconds())));
    };
  }
  const auto sample = measure_cost(experiment, plan, sampling);
  const double spent = clocks.elapsed_seconds();
  const double spare = std::min(few_seconds, budget.sample ? budget.seconds : budget.seconds - spent);
  const double end = spent + std::max(timing_share * spent, spare);
  auto timing = time_cost(
      experiment, tolerances,
      {.processor_seconds = clocks.processor_seconds, .seconds_left = [&] { return end - clocks.elapsed_seconds(); }},
      options);
  if (options.stop_requested.is_made()) return std::nullopt;
  return cost_of(experiment, tolerances, sample, std::move(timing));
}

}  // namespace rocking
