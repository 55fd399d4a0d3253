#include "rocking/studies/rare/summarise.hpp"

#include <algorithm>
#include <vector>

#include "rocking/stats/repetitions.hpp"

namespace rocking::rare {
namespace {

/// Of the event, and of the event or no answer.
struct EventAndOpen {
  std::vector<double> least, most;
};

EventAndOpen event_and_open(const std::vector<Repetition>& repetitions) {
  EventAndOpen found;
  for (const Repetition& repetition : repetitions) {
    found.least.push_back(repetition.estimate);
    found.most.push_back(repetition.estimate + repetition.unresolved);
  }
  return found;
}

/// As if each particle were a realisation. It is one where the pilot runs have not seen the event.
stats::Interval interval_of_none(std::size_t repetitions, double confidence, std::uint64_t particles) {
  return stats::clopper_pearson({.successes = 0, .trials = repetitions * particles}, confidence);
}

}  // namespace

void summarise_repetitions(RareEstimate& estimate, double confidence, std::uint64_t particles) {
  const std::size_t count = estimate.repetitions.size();
  estimate.probability.reset();
  estimate.relative_error.reset();
  estimate.crude_work.reset();
  estimate.interval = {0.0, 1.0};
  estimate.unresolved = 0.0;
  estimate.work = estimate.pilot_work;
  for (const Repetition& repetition : estimate.repetitions) {
    estimate.work += repetition.work;
    estimate.unresolved += repetition.unresolved / static_cast<double>(count);
  }
  if (count == 0) return;
  const EventAndOpen estimates = event_and_open(estimate.repetitions);
  const stats::RepeatedEstimate found = stats::mean_of_repetitions(estimates.least, confidence);
  estimate.probability = found.mean;
  if (count < least_with_interval) return;
  estimate.interval = found.interval ? *found.interval : interval_of_none(count, confidence, particles);
  if (estimate.unresolved > 0.0) {
    const stats::RepeatedEstimate with_unresolved = stats::mean_of_repetitions(estimates.most, confidence);
    estimate.interval.high = std::max(estimate.interval.high, with_unresolved.interval.value().high);
  }
  estimate.interval.high = std::min(1.0, estimate.interval.high);
  // Equal repetitions say nothing of their scatter.
  const double error = found.relative_error.value_or(0.0);
  if (!(error > 0.0)) return;
  estimate.relative_error = error;
  estimate.crude_work = (1.0 - found.mean) / (found.mean * error * error);
}

}  // namespace rocking::rare
