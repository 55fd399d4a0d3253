#include "analysis/overview.hpp"

#include <algorithm>
#include <vector>

namespace rocking::analysis {

using section::ResponseMode;

std::uint64_t realisations_of(const RunReport& report) {
  std::uint64_t sum = 0;
  for (const ConditionReport& condition : report.conditions) sum += condition.realisations;
  return sum;
}

std::map<ResponseMode, Prevalence> prevalences_of(const RunReport& report) {
  std::map<ResponseMode, Prevalence> found;
  for (const ConditionReport& condition : report.conditions) {
    const ResponseMode* most = nullptr;
    std::uint64_t highest = 0;
    for (const auto& [mode, share] : condition.modes) {
      if (share.count == 0) continue;
      found[mode].occurs += 1;
      found[mode].realisations += share.count;
      if (share.count > highest) {
        highest = share.count;
        most = &mode;
      }
    }
    if (most != nullptr) found[*most].most_likely += 1;
  }
  return found;
}

Extreme extreme_of(const RunReport& report, const ResponseMode& mode) {
  Extreme extreme;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto found = report.conditions[i].modes.find(mode);
    if (found == report.conditions[i].modes.end()) continue;
    const ModeShare& share = found->second;
    const bool more = share.count > 0 ? share.estimate > extreme.share.estimate
                                      : extreme.share.count == 0 && share.interval.high > extreme.share.interval.high;
    if (more) extreme = {.condition = i, .share = share};
  }
  return extreme;
}

Repeatability repeatability_of(const RunReport& report) {
  Repeatability found;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto& difference = report.conditions[i].difference;
    if (!difference) continue;
    ++found.compared;
    if (difference->differ == 0.0) ++found.alike;
    if (!found.least || difference->differ > report.conditions[*found.least].difference->differ) found.least = i;
  }
  return found;
}

PooledDivergence pooled_divergence(const RunReport& report, Divergence Difference::*cause) {
  PooledDivergence pooled;
  std::vector<double> medians;
  for (const ConditionReport& condition : report.conditions) {
    if (!condition.difference) continue;
    const Divergence& divergence = *condition.difference.*cause;
    pooled.pairs += divergence.pairs;
    pooled.diverged += divergence.diverged;
    if (divergence.median) medians.push_back(*divergence.median);
  }
  if (medians.empty()) return pooled;
  std::ranges::sort(medians);
  pooled.median = medians[medians.size() / 2];
  return pooled;
}

UnresolvedResponses unresolved_responses(const RunReport& report) {
  const ResponseMode mode{.kind = section::ResponseKind::unresolved};
  UnresolvedResponses unresolved;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto found = report.conditions[i].modes.find(mode);
    if (found == report.conditions[i].modes.end()) continue;
    unresolved.count += found->second.count;
    if (found->second.estimate > unresolved.largest_share) {
      unresolved.largest_share = found->second.estimate;
      unresolved.where = i;
    }
  }
  if (unresolved.count == 0) return unresolved;
  unresolved.share = static_cast<double>(unresolved.count) / static_cast<double>(realisations_of(report));
  return unresolved;
}

double widest_half_width(const RunReport& report) {
  double widest = 0.0;
  for (const ConditionReport& condition : report.conditions) {
    for (const auto& [mode, share] : condition.modes) {
      widest = std::max(widest, 0.5 * (share.interval.high - share.interval.low));
    }
  }
  return widest;
}

}  // namespace rocking::analysis
