#include "rocking/output/overview.hpp"

#include <algorithm>
#include <vector>

#include "rocking/output/mode_table.hpp"

namespace rocking {

using section::ResponseMode;

std::uint64_t realisations_of(const Report& report) {
  std::uint64_t sum = 0;
  for (const ReportedCondition& condition : report.conditions) sum += condition.result.realisations;
  return sum;
}

std::map<ResponseMode, Prevalence> prevalences_of(const Report& report) {
  std::map<ResponseMode, Prevalence> found;
  for (const ReportedCondition& condition : report.conditions) {
    for (const auto& [mode, probability] : condition.result.modes) {
      const std::uint64_t count = probability.counts.successes;
      if (count == 0) continue;
      found[mode].occurs += 1;
      found[mode].realisations += count;
    }
    const ResponseMode most = most_frequent_in(condition);
    if (count_of(condition, most) > 0) found[most].most_likely += 1;
  }
  return found;
}

std::size_t extreme_of(const Report& report, const ResponseMode& mode) {
  std::size_t where = 0;
  double highest = 0.0;
  double highest_bound = 0.0;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const Estimate* found = report.conditions[i].result.estimate_of(mode);
    if (found == nullptr) continue;
    const bool occurs = found->counts.successes > 0;
    const bool more = occurs ? found->estimate > highest : highest == 0.0 && found->quoted().high > highest_bound;
    if (!more) continue;
    where = i;
    highest = found->estimate;
    highest_bound = found->quoted().high;
  }
  return where;
}

Repeatability repeatability_of(const Report& report) {
  Repeatability found;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto& difference = report.conditions[i].result.non_recurrence;
    if (!difference) continue;
    ++found.compared;
    if (difference->differ == 0.0) ++found.alike;
    if (!found.least || difference->differ > report.conditions[*found.least].result.non_recurrence->differ)
      found.least = i;
  }
  return found;
}

PooledDivergence pooled_divergence(const Report& report, DivergenceTimes NonRecurrence::*cause) {
  PooledDivergence pooled;
  std::vector<double> medians;
  for (const ReportedCondition& condition : report.conditions) {
    if (!condition.result.non_recurrence) continue;
    const DivergenceTimes& divergence = *condition.result.non_recurrence.*cause;
    pooled.pairs += divergence.pairs;
    pooled.diverged += divergence.diverged;
    if (divergence.median) medians.push_back(*divergence.median);
  }
  if (medians.empty()) return pooled;
  std::ranges::sort(medians);
  pooled.median = medians[medians.size() / 2];
  return pooled;
}

UnresolvedResponses unresolved_responses(const Report& report) {
  const ResponseMode mode{.kind = section::ResponseKind::unresolved};
  UnresolvedResponses unresolved;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const Estimate* found = report.conditions[i].result.estimate_of(mode);
    if (found == nullptr) continue;
    unresolved.count += found->counts.successes;
    if (found->estimate > unresolved.largest_share) {
      unresolved.largest_share = found->estimate;
      unresolved.where = i;
    }
  }
  if (unresolved.count == 0) return unresolved;
  unresolved.share = static_cast<double>(unresolved.count) / static_cast<double>(realisations_of(report));
  return unresolved;
}

double widest_half_width(const Report& report) {
  double widest = 0.0;
  for (const ReportedCondition& condition : report.conditions) {
    for (const ModeEstimate& each : condition.result.modes) {
      const stats::Interval& interval = each.probability.quoted();
      widest = std::max(widest, 0.5 * (interval.high - interval.low));
    }
  }
  return widest;
}

}  // namespace rocking
