#include "rocking/stats/incidence.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::stats {
namespace {

/// What happens at one time, of the observations that are still under way just before it.
struct EventTime {
  std::int64_t time = 0;
  double at_risk = 0.0;
  double events = 0.0;  ///< of any kind
  double wanted = 0.0;  ///< of the event asked for
};

std::vector<EventTime> moments_of(const EventTally& tally, std::size_t event) {
  double under_way = 0.0;
  for (const auto& [end, count] : tally) under_way += static_cast<double>(count);
  std::vector<EventTime> moments;
  for (const auto& [end, count] : tally) {
    const auto number = static_cast<double>(count);
    if (moments.empty() || moments.back().time != end.time) {
      moments.push_back({.time = end.time, .at_risk = under_way, .events = 0.0, .wanted = 0.0});
    }
    if (end.event) moments.back().events += number;
    if (end.event == event) moments.back().wanted += number;
    under_way -= number;
  }
  return moments;
}

/// Adds count times the squared influence of an observation on the incidence to the variance at each moment.
void add_influence(const std::vector<EventTime>& moments, const EndOfObservation& end, std::size_t event, double count,
                   std::vector<double>& variances) {
  double survival = 1.0;     // just before the moment
  double of_survival = 0.0;  // derivative of its logarithm
  double of_incidence = 0.0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const auto& [time, at_risk, events, wanted] = moments[i];
    const bool ends_here = end.time == time;
    const double here = end.time >= time ? 1.0 : 0.0;
    const double hazard = wanted / at_risk;
    const double of_hazard = ((ends_here && end.event == event ? 1.0 : 0.0) - here * hazard) / at_risk;
    of_incidence += survival * (of_hazard + hazard * of_survival);
    variances[i] += count * of_incidence * of_incidence;
    const double any = events / at_risk;
    if (any >= 1.0) {
      survival = 0.0;
    } else {
      of_survival -= ((ends_here && end.event ? 1.0 : 0.0) - here * any) / at_risk / (1.0 - any);
      survival *= 1.0 - any;
    }
  }
}

Interval exact_interval_of(double estimate, double variance, double observations, double tail) {
  const double spread = estimate * (1.0 - estimate);
  const double n = variance > 0.0 && spread > 0.0 ? std::min(observations, spread / variance) : observations;
  const double k = n * estimate;
  const double low = k > 0.0 ? boost::math::ibeta_inv(k, n - k + 1.0, tail) : 0.0;
  const double high = k < n ? boost::math::ibetac_inv(k + 1.0, n - k, tail) : 1.0;
  return {.low = std::min(low, estimate), .high = std::max(high, estimate)};
}

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

std::vector<Incidence> cumulative_incidence(const EventTally& tally, std::size_t event, double confidence) {
  ROCKING_EXPECT(0.0 < confidence && confidence < 1.0);
  const std::vector<EventTime> moments = moments_of(tally, event);
  std::vector<double> variances(moments.size(), 0.0);
  double observations = 0.0;
  std::int64_t last_event = 0;
  for (const auto& [end, count] : tally) {
    add_influence(moments, end, event, static_cast<double>(count), variances);
    observations += static_cast<double>(count);
    if (end.event) last_event = std::max(last_event, end.time);
  }
  double uncensored = observations;
  for (const auto& [end, count] : tally) {
    if (!end.event && end.time < last_event) uncensored -= static_cast<double>(count);
  }
  const double half_width = std::sqrt(std::log(2.0 / (1.0 - confidence)) / (2.0 * std::max(uncensored, 1.0)));
  std::vector<Incidence> curve;
  double survival = 1.0;
  double estimate = 0.0;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const auto& [time, at_risk, events, wanted] = moments[i];
    estimate = std::min(1.0, estimate + survival * wanted / at_risk);
    survival *= 1.0 - events / at_risk;
    if (wanted == 0.0) continue;
    curve.push_back(
        {.time = time,
         .estimate = estimate,
         .variance = variances[i],
         .pointwise = exact_interval_of(estimate, variances[i], observations, 0.5 * (1.0 - confidence)),
         .simultaneous = {.low = std::max(0.0, estimate - half_width), .high = std::min(1.0, estimate + half_width)}});
  }
  return curve;
}

Interval poisson_rate_interval(std::uint64_t count, double exposure, double confidence) {
  ROCKING_EXPECT(exposure > 0.0 && 0.0 < confidence && confidence < 1.0);
  const auto k = static_cast<double>(count);
  const double tail = 0.5 * (1.0 - confidence);
  return {.low = count > 0 ? boost::math::gamma_p_inv(k, tail) / exposure : 0.0,
          .high = boost::math::gamma_q_inv(k + 1.0, tail) / exposure};
}

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
