#include "rocking/ensemble/response_times.hpp"

#include <algorithm>

#include "rocking/ensemble/settling_tally.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/survival.hpp"

namespace rocking {
namespace {

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
  const std::int64_t fixed = std::int64_t{horizon.transient_periods} + horizon.sampled_periods;
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
