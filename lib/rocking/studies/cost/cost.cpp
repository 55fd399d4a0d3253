#include "rocking/studies/cost/cost.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <set>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/studies/cost/half_width_forecast.hpp"
#include "rocking/studies/cost/measurement.hpp"
#include "rocking/studies/cost/sample.hpp"

namespace rocking {
namespace {

constexpr std::array decades{1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14};
constexpr std::array<std::uint64_t, 3> factors{1, 4, 16};
constexpr std::array half_widths{0.05, 0.02, 0.01};

/// Work of all conditions together.
struct Work {
  std::uint64_t periods = 0;
  double seconds = 0.0;
};

std::size_t place_of(double tolerance, const Cost& cost) {
  const auto found = std::ranges::find(cost.curve, tolerance, &ToleranceCost::tolerance);
  ROCKING_EXPECT(found != cost.curve.end());
  return static_cast<std::size_t>(found - cost.curve.begin());
}

/// If each random condition has realisations(condition) realisations.
template <class Realisations>
Work work_of(const Cost& cost, const Experiment& experiment, Realisations realisations) {
  Work work;
  for (const Condition& condition : experiment.conditions) {
    const auto transient = condition.horizon.transient_periods;
    const auto sampled = condition.horizon.sampled_periods;
    const std::uint64_t number = is_random(condition.scene) ? realisations(condition) : 1;
    const std::uint64_t periods =
        number * (static_cast<std::uint64_t>(transient) + static_cast<std::uint64_t>(sampled));
    work.periods += periods;
    work.seconds += static_cast<double>(periods) * cost.seconds_per_period(place_of(condition.tolerance, cost));
  }
  return work;
}

void add_plans(Cost& cost, const Experiment& experiment, const HalfWidthForecast& forecast) {
  if (forecast.is_empty()) return;
  for (const std::uint64_t factor : factors) {
    const auto realisations = [factor](const Condition& condition) { return factor * condition.realisations; };
    const auto [periods, seconds] = work_of(cost, experiment, realisations);
    cost.planned.push_back(
        {.factor = factor, .half_widths = forecast.at(factor), .periods = periods, .seconds = seconds});
  }
  for (const double half_width : half_widths) {
    const RealisationsNeeded needed = forecast.needed(half_width);
    const auto realisations = [&needed](const Condition&) { return needed.by_shares; };
    const auto [periods, seconds] = work_of(cost, experiment, realisations);
    cost.goals.push_back({.half_width = half_width, .needed = needed, .periods = periods, .seconds = seconds});
  }
}

}  // namespace

std::vector<double> own_tolerances(const Experiment& experiment) {
  std::set<double, std::greater<>> own;
  for (const Condition& condition : experiment.conditions) own.insert(condition.tolerance);
  return {own.begin(), own.end()};
}

std::vector<double> tolerance_ladder(const Experiment& experiment) {
  std::set<double, std::greater<>> ladder(decades.begin(), decades.end());
  const std::vector<double> own = own_tolerances(experiment);
  ladder.insert(own.begin(), own.end());
  return {ladder.begin(), ladder.end()};
}

bool Cost::is_own(std::size_t place) const { return std::ranges::find(own, place) != own.end(); }

double Cost::speed(std::size_t place) const {
  const double time = seconds_per_period(place);
  return time > 0.0 ? seconds_per_period(own.back()) / time : 1.0;
}

Cost cost_of(const Experiment& experiment, std::span<const double> tolerances,
             std::span<const MeasuredRealisation> measured, CostTiming timing) {
  ROCKING_EXPECT(timing.seconds_per_period.size() == tolerances.size());
  const HalfWidthForecast forecast(experiment, measured);
  std::set<std::uint64_t> conditions;
  for (const MeasuredRealisation& realisation : measured) conditions.insert(realisation.key.condition);
  Cost cost;
  cost.sample = measured.size();
  cost.sampled_conditions = conditions.size();
  cost.confidence = highest_confidence(experiment);
  cost.curve = cost_curve(tolerances, measured, cost.confidence);
  for (const double own : own_tolerances(experiment)) cost.own.push_back(place_of(own, cost));
  cost.timing = std::move(timing);
  cost.yardstick = {.half_width = forecast.aim(), .is_everything = CostSample(experiment).size() == measured.size()};
  cost.recommendation = recommend(cost.curve, cost.yardstick, cost.confidence);
  add_plans(cost, experiment, forecast);
  return cost;
}

}  // namespace rocking
