#include "rocking/studies/cost/cost.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/studies/cost/measurement.hpp"

namespace rocking {
namespace {

/// A share of realisations, and the significance of its interval.
struct Share {
  double value = 0.0;
  stats::Significance significance;
};

double half(const stats::Interval& interval) { return 0.5 * (interval.high - interval.low); }

stats::Proportion proportion(double share, std::uint64_t realisations) {
  const double count = std::round(share * static_cast<double>(realisations));
  return {.successes = static_cast<std::uint64_t>(count), .trials = realisations};
}

double half_width_of(const Share& share, std::uint64_t realisations) {
  return half(stats::exact_interval(proportion(share.value, realisations), share.significance));
}

std::vector<Share> shares_of(const ModeTally& modes, std::uint64_t trials, double confidence) {
  std::vector<Share> shares;
  for (const auto& [mode, count] : modes) {
    shares.push_back({.value = static_cast<double>(count) / static_cast<double>(trials),
                      .significance = significance_of(mode, confidence)});
  }
  return shares;
}

/// The share whose interval is the widest.
Share widest_of(const std::vector<Share>& shares, std::uint64_t realisations) {
  return *std::ranges::max_element(shares, {}, [&](const Share& share) { return half_width_of(share, realisations); });
}

/// That of `until`; a relative one is multiplied by the share of its mode. Absent if that mode did not occur.
std::optional<double> intended_half_width(const Until& until, const ModeTally& modes, std::uint64_t trials) {
  if (until.half_width) return until.half_width;
  const auto found = modes.find(*until.mode);
  if (found == modes.end()) return std::nullopt;
  return *until.relative_half_width * static_cast<double>(found->second) / static_cast<double>(trials);
}

/// Smallest number of realisations with this half-width. Counts are whole numbers, so it may be off by one or two.
std::uint64_t needed_for(const Share& share, double half_width, std::uint64_t most) {
  std::uint64_t too_few = 0;
  std::uint64_t enough = 1;
  while (enough < most && half_width_of(share, enough) > half_width) {
    too_few = enough;
    enough = std::min(most, 2 * enough);
  }
  while (enough - too_few > 1) {
    const std::uint64_t middle = too_few + (enough - too_few) / 2;
    (half_width_of(share, middle) > half_width ? too_few : enough) = middle;
  }
  return enough;
}

}  // namespace

HalfWidthForecast::HalfWidthForecast(const Experiment& experiment, std::span<const MeasuredRealisation> measured) {
  std::map<std::uint64_t, SampledCondition> sampled;
  for (const MeasuredRealisation& realisation : measured) {
    const Condition& condition = experiment.conditions[realisation.key.condition];
    if (!is_random(condition.scene)) continue;
    SampledCondition& entry =
        sampled.try_emplace(realisation.key.condition, SampledCondition{&condition, {}, 0}).first->second;
    ++entry.modes[realisation.runs.back().mode];
    ++entry.trials;
  }
  for (auto& [index, entry] : sampled) tallies_.push_back(std::move(entry));
}

HalfWidths HalfWidthForecast::at(std::uint64_t factor) const {
  ROCKING_EXPECT(!is_empty());
  HalfWidths widths;
  for (const auto& [condition, modes, trials] : tallies_) {
    const std::uint64_t realisations = factor * condition->realisations;
    const Share widest = widest_of(shares_of(modes, trials, condition->confidence), realisations);
    const double width = half_width_of(widest, realisations);
    widths.mean += width / static_cast<double>(tallies_.size());
    widths.widest = std::max(widths.widest, width);
    for (const auto& [mode, count] : modes) {
      const double share = static_cast<double>(count) / static_cast<double>(trials);
      const stats::Interval wilson = stats::wilson(proportion(share, realisations), condition->confidence);
      widths.widest_wilson = std::max(widths.widest_wilson, half(wilson));
    }
  }
  return widths;
}

std::optional<double> HalfWidthForecast::aim() const {
  if (is_empty()) return std::nullopt;
  double sum = 0.0;
  for (const auto& [condition, modes, trials] : tallies_) {
    const std::uint64_t n = condition->realisations;
    const auto intended = condition->until ? intended_half_width(*condition->until, modes, trials) : std::nullopt;
    sum += intended ? *intended : half_width_of(widest_of(shares_of(modes, trials, condition->confidence), n), n);
  }
  return sum / static_cast<double>(tallies_.size());
}

RealisationsNeeded HalfWidthForecast::needed(double half_width) const {
  ROCKING_EXPECT(!is_empty());
  ROCKING_EXPECT(0.0 < half_width && half_width < 0.5);
  const std::uint64_t n = tallies_.front().condition->realisations;
  std::vector<Share> widest;
  double highest = 0.0;
  for (const auto& [condition, modes, trials] : tallies_) {
    widest.push_back(widest_of(shares_of(modes, trials, condition->confidence), n));
    highest = std::max(highest, condition->confidence);
  }
  const Share half_of_all{.value = 0.5, .significance = mode_family(highest).of_others()};
  return {.by_shares = needed_for(widest_of(widest, n), half_width, most_needed),
          .at_most = needed_for(half_of_all, half_width, most_needed)};
}

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
