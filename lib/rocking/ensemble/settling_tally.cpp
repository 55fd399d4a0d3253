#include "rocking/ensemble/settling_tally.hpp"

#include <algorithm>

#include "rocking/stats/diversity.hpp"
#include "rocking/stats/incidence.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking {
namespace {

std::vector<stats::Incidence> curve_of(const stats::EventTally& tally, std::size_t event, double confidence) {
  return stats::thinned(stats::cumulative_incidence(tally, event, confidence), SettlingResult::most_times);
}

std::vector<stats::QuantileEstimate> quartiles_of(const stats::EventTally& tally, double confidence) {
  std::vector<stats::QuantileEstimate> quartiles;
  std::uint64_t observations = 0;
  for (const auto& [end, count] : tally) observations += count;
  const auto curve = stats::cumulative_incidence(tally, 0, confidence);
  for (const double level : {0.25, 0.5, 0.75}) {
    quartiles.push_back(stats::incidence_quantile(curve, observations, level, confidence));
  }
  return quartiles;
}

}  // namespace

double bound_of_none_left(std::uint64_t watched_periods, double confidence) {
  return stats::poisson_rate_interval(0, static_cast<double>(watched_periods) / 1000.0, confidence).high;
}

std::int64_t confirmation_periods(const Horizon& horizon) {
  if (!horizon.until_classified) return 0;
  return (std::int64_t{horizon.until_classified->held_windows} - 1) * horizon.sampled_periods;
}

void SettlingTally::add(const Summary& summary) {
  const std::int64_t observed = summary.observed_periods.value_or(0);
  const section::ResponseMode before = summary.horizon_mode.value_or(summary.mode);
  ++at_horizon_[before];
  if (summary.settling_period) {
    ++ends_[End{*summary.settling_period, summary.mode}];
    if (summary.mode.kind != section::ResponseKind::overturned) {
      Settled& settled = settled_[summary.mode];
      ++settled.realisations;
      settled.periods += static_cast<std::uint64_t>(observed - *summary.settling_period);
      settled.left += summary.left_period ? 1 : 0;
    }
  } else {
    ++ends_[End{observed, std::nullopt}];
  }
  if (summary.long_run) {
    ++long_runs_;
    long_run_windows_ = summary.long_run->total();
    for (const auto& [mode, windows] : *summary.long_run) in_long_runs_[mode].add(windows);
  }
  if (!first_of_pair_) {
    first_of_pair_ = before;
    return;
  }
  ++differing_pairs_.trials;
  differing_pairs_.successes += *first_of_pair_ == before ? 0 : 1;
  first_of_pair_.reset();
}

LongRuns SettlingTally::long_runs(double confidence) const {
  LongRuns runs{.windows = long_run_windows_, .count = long_runs_, .shares = {}};
  for (auto [mode, windows] : in_long_runs_) {
    windows.clusters = long_runs_;  // also those without this mode
    windows.trials_each = long_run_windows_;
    runs.shares[mode] = {.share = windows.share(), .interval = stats::korn_graubard(windows, confidence)};
  }
  return runs;
}

SettlingResult SettlingTally::result(const Condition& condition, const std::map<std::int64_t, std::uint64_t>& diverged,
                                     std::uint64_t later) const {
  const double confidence = condition.confidence;
  SettlingResult result;
  result.at_horizon = at_horizon_;
  std::vector<std::uint64_t> counts;
  std::uint64_t realisations = 0;
  for (const auto& [mode, count] : at_horizon_) {
    counts.push_back(count);
    realisations += count;
  }
  if (realisations >= 2) {
    result.differ = stats::probability_of_difference(counts);
    const stats::Interval exact = stats::clopper_pearson(differing_pairs_, confidence);
    result.differ_interval = {.low = std::min(exact.low, *result.differ), .high = std::max(exact.high, *result.differ)};
  }
  std::map<section::ResponseMode, std::size_t> events;
  for (const auto& [end, count] : ends_) {
    if (end.mode) events.emplace(*end.mode, events.size());
  }
  // A response that appears in the last windows cannot be confirmed: it is at risk of settling only before them.
  const std::int64_t confirmation = confirmation_periods(condition.horizon);
  stats::EventTally tally;
  for (const auto& [end, count] : ends_) {
    stats::EndOfObservation observation{.time = end.period, .event = std::nullopt};
    if (end.mode) {
      observation.event = events.at(*end.mode);
    } else {
      result.censored += count;
      observation.time = std::max<std::int64_t>(0, end.period - confirmation);
    }
    tally[observation] += count;
  }
  for (const auto& [mode, event] : events) {
    result.incidence[mode] = curve_of(tally, event, confidence);
  }
  for (const auto& [mode, settled] : settled_) {
    const std::uint64_t watched = settled.periods - settled.realisations * static_cast<std::uint64_t>(confirmation);
    if (watched == 0) continue;
    const double thousands = static_cast<double>(watched) / 1000.0;
    result.leaving[mode] = {.watched_periods = watched,
                            .left = settled.left,
                            .per_1000_periods = stats::poisson_rate_interval(settled.left, thousands, confidence)};
  }
  if (condition.horizon.until_classified && condition.horizon.until_classified->long_run_every > 0) {
    result.long_runs = long_runs(confidence);
  }
  stats::EventTally pairs;
  const std::int64_t horizon = condition.horizon.periods();
  for (const auto& [period, count] : diverged) pairs[{.time = period, .event = 0}] = count;
  if (later > 0) pairs[{.time = horizon, .event = std::nullopt}] = later;
  if (!pairs.empty()) result.divergence = curve_of(pairs, 0, confidence);
  return result;
}

double bound_of_none(std::uint64_t realisations, double confidence) {
  return stats::clopper_pearson({.successes = 0, .trials = realisations}, confidence).high;
}

void ResponseTimesTally::add(const Summary& summary) {
  if (summary.settling_period) {
    ++settled_[*summary.settling_period];
  } else {
    ++censored_[summary.observed_periods.value_or(0)];
  }
}

ResponseTimes ResponseTimesTally::result(const Condition& condition,
                                         const std::map<std::int64_t, std::uint64_t>& diverged,
                                         std::uint64_t later) const {
  const Horizon& horizon = condition.horizon;
  const std::int64_t fixed = horizon.periods();
  // A response that appears in the last windows cannot be held for long enough: it is at risk only before them.
  const std::int64_t confirmation = confirmation_periods(horizon);
  stats::EventTally tally;
  for (const auto& [period, count] : settled_) tally[{.time = period, .event = 0}] += count;
  for (const auto& [period, count] : censored_) {
    tally[{.time = std::max<std::int64_t>(0, period - confirmation), .event = std::nullopt}] += count;
  }
  ResponseTimes result;
  result.any_mode =
      stats::thinned(stats::cumulative_incidence(tally, 0, condition.confidence), ResponseTimes::most_times);
  result.quartiles = quartiles_of(tally, condition.confidence);
  result.nearly_all = stats::time_to_share(tally, {.from = fixed, .step = horizon.sampled_periods},
                                           ResponseTimes::tolerable_share, condition.confidence);
  stats::EventTally pairs;
  for (const auto& [period, count] : diverged) pairs[{.time = period, .event = 0}] = count;
  if (later > 0) pairs[{.time = fixed, .event = std::nullopt}] = later;
  result.divergence_quartiles = quartiles_of(pairs, condition.confidence);
  return result;
}

}  // namespace rocking
