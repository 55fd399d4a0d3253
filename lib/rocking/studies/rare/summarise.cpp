#include "rocking/studies/rare/summarise.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"
#include "rocking/stats/repetitions.hpp"

namespace rocking {
namespace {

struct Records {
  std::vector<Parameter> others;
  double confidence = 0.95;
  std::vector<const RareEstimate*> estimates;
};

/// The conditions that are part of a suite, by the rest of the sweep.
std::vector<Records> records_of(const std::vector<Condition>& conditions, const std::vector<RareEstimate>& estimates) {
  constexpr std::string_view record = "/excitation/file";
  std::vector<Records> groups;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    std::vector<Parameter> others = conditions[i].parameters;
    if (std::erase_if(others, [&](const Parameter& each) { return each.pointer == record; }) == 0) continue;
    auto group = std::ranges::find_if(groups, [&](const Records& known) {
      return std::ranges::equal(known.others, others, {}, &Parameter::value, &Parameter::value);
    });
    if (group == groups.end()) {
      groups.push_back({.others = std::move(others), .confidence = conditions[i].confidence, .estimates = {}});
      group = std::prev(groups.end());
    }
    group->estimates.push_back(&estimates[i]);
  }
  std::erase_if(groups, [](const Records& group) { return group.estimates.size() < 2; });
  return groups;
}

RareSuite suite_of(const Records& records) {
  const auto count = static_cast<double>(records.estimates.size());
  RareSuite suite;
  suite.parameters = records.others;
  suite.records = records.estimates.size();
  suite.confidence = records.confidence;
  std::vector<stats::Stratum> strata;
  double sum = 0.0;
  double low = 0.0;   // of the records whose error is not known, or with motions without an answer
  double high = 0.0;  // likewise
  bool is_known = true;
  for (const RareEstimate* estimate : records.estimates) {
    is_known = is_known && estimate->probability.has_value();
    sum += estimate->probability.value_or(0.0);
    if (estimate->relative_error && estimate->unresolved == 0.0) {
      strata.push_back({.mean = *estimate->probability,
                        .standard_error = *estimate->probability * *estimate->relative_error,
                        .degrees_of_freedom = static_cast<double>(estimate->repetitions.size()) - 1.0});
    } else {
      low += estimate->interval.low;
      high += estimate->interval.high;
    }
  }
  if (is_known) suite.probability = sum / count;
  if (!strata.empty()) {
    const stats::RepeatedEstimate of_strata = stats::sum_of_strata(strata, records.confidence);
    low += of_strata.interval->low;
    high += of_strata.interval->high;
    if (is_known && sum > 0.0) suite.relative_error = of_strata.mean * *of_strata.relative_error / sum;
  }
  suite.interval = {.low = low / count, .high = std::min(1.0, high / count)};
  return suite;
}

}  // namespace

std::vector<RareSuite> rare_suites(const std::vector<Condition>& conditions,
                                   const std::vector<RareEstimate>& estimates) {
  ROCKING_EXPECT(conditions.size() == estimates.size());
  std::vector<RareSuite> suites;
  for (const Records& records : records_of(conditions, estimates)) suites.push_back(suite_of(records));
  return suites;
}

}  // namespace rocking

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

/// The lower median; 0 without repetitions.
std::size_t median_of_ancestors(const std::vector<Repetition>& repetitions) {
  std::vector<std::size_t> ancestors;
  for (const Repetition& repetition : repetitions) ancestors.push_back(repetition.ancestors);
  if (ancestors.empty()) return 0;
  const auto middle = ancestors.begin() + static_cast<std::ptrdiff_t>((ancestors.size() - 1) / 2);
  std::ranges::nth_element(ancestors, middle);
  return *middle;
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
  estimate.ancestors = median_of_ancestors(estimate.repetitions);
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
