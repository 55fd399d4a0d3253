#include "rocking/stats/survival.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/base/error.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::stats {
namespace {

/// Rounding of a product of some thousand factors below 1: k/n must reach the level k/n.
constexpr double curve_rounding = 1e-12;

/// Longest extrapolation, in steps; beyond it a time is not told.
constexpr double longest_extrapolation = 1e9;

template <class Reaches>
std::optional<std::int64_t> first_time(const std::vector<Incidence>& curve, const Reaches& reaches) {
  const auto found = std::ranges::find_if(curve, reaches);
  if (found == curve.end()) return std::nullopt;
  return found->time;
}

std::optional<double> as_number(const std::optional<std::int64_t>& time) {
  if (!time) return std::nullopt;
  return static_cast<double>(*time);
}

std::uint64_t observations_in(const EventTally& tally) {
  std::uint64_t observations = 0;
  for (const auto& [end, count] : tally) observations += count;
  return observations;
}

/// Whole steps until a share `left` has become `share`, with probability q of the event in a step. Absent: too many.
std::optional<std::int64_t> steps_until(double left, double share, double q) {
  if (left <= share) return 0;
  if (q >= 1.0) return 1;
  const double steps = std::ceil(std::log(left / share) / -std::log1p(-q));
  if (!(steps < longest_extrapolation)) return std::nullopt;
  return static_cast<std::int64_t>(steps);
}

/// Events in the steps that end after `middle`, among the observations that were under way in them.
Proportion events_after(const EventTally& tally, std::int64_t middle, std::int64_t step) {
  Proportion found;
  for (const auto& [end, count] : tally) {
    const std::int64_t after = std::max<std::int64_t>(0, end.time - middle);
    const std::int64_t steps = end.event ? (after + step - 1) / step : after / step;
    found.trials += count * static_cast<std::uint64_t>(steps);
    if (end.event && after > 0) found.successes += count;
  }
  return found;
}

}  // namespace

QuantileEstimate incidence_quantile(const std::vector<Incidence>& curve, std::uint64_t observations, double level,
                                    double confidence) {
  ROCKING_EXPECT(0.0 < level && level < 1.0);
  QuantileEstimate quantile{.level = level, .value = {}, .low = {}, .high = {}};
  if (curve.empty()) return quantile;
  quantile.value =
      as_number(first_time(curve, [&](const Incidence& at) { return at.estimate >= level - curve_rounding; }));
  const double before = clopper_pearson({.successes = 0, .trials = observations}, confidence).high;
  if (before <= level) {
    quantile.low = as_number(first_time(curve, [&](const Incidence& at) { return at.pointwise.high > level; }));
  }
  quantile.high = as_number(first_time(curve, [&](const Incidence& at) { return at.pointwise.low >= level; }));
  return quantile;
}

TimeToShare time_to_share(const EventTally& tally, const Steps& steps, double share, double confidence) {
  ROCKING_EXPECT(steps.step > 0 && 0.0 < share && share < 1.0);
  if (tally.empty()) return {};
  const double level = 1.0 - share;
  const double each = 1.0 - 0.5 * (1.0 - confidence);
  const auto curve = cumulative_incidence(tally, 0, confidence);
  const auto whole = [](const std::optional<double>& time) {
    return time ? std::optional(static_cast<std::int64_t>(*time)) : std::nullopt;
  };
  const QuantileEstimate observed = incidence_quantile(curve, observations_in(tally), level, confidence);
  TimeToShare result{.is_observed = observed.value.has_value(),
                     .time = whole(observed.value),
                     .low = whole(observed.low),
                     .high = whole(observed.high)};
  if (result.is_observed || curve.empty()) return result;
  const std::int64_t last = tally.rbegin()->first.time;
  const std::int64_t half = ((last - steps.from) / steps.step + 1) / 2;
  if (half < 1) return result;
  const Proportion late = events_after(tally, last - half * steps.step, steps.step);
  if (late.trials == 0) return result;
  result.events = late.successes;
  const Incidence end = cumulative_incidence(tally, 0, each).back();
  const Interval q = clopper_pearson(late, each);
  const auto after = [&](double left, double probability) -> std::optional<std::int64_t> {
    if (probability <= 0.0) return std::nullopt;
    const auto more = steps_until(left, share, probability);
    return more ? std::optional(last + *more * steps.step) : std::nullopt;
  };
  result.time = after(1.0 - end.estimate, static_cast<double>(late.successes) / static_cast<double>(late.trials));
  if (!result.low) result.low = after(1.0 - end.pointwise.high, q.high);
  result.high = after(1.0 - end.pointwise.low, q.low);
  return result;
}

std::vector<Incidence> thinned(const std::vector<Incidence>& curve, std::size_t most) {
  ROCKING_EXPECT(most >= 2);
  if (curve.size() <= most) return curve;
  std::vector<Incidence> kept;
  for (std::size_t i = 0; i < most; ++i) kept.push_back(curve[i * (curve.size() - 1) / (most - 1)]);
  return kept;
}

}  // namespace rocking::stats
