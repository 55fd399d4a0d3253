#include "rocking/studies/rare/suite_probability.hpp"

#include <algorithm>
#include <string_view>

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
