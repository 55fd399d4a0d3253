#pragma once

#include <cstdint>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Counts of trials that were all classified by a fallible method. Some of them, chosen independently of the outcome,
/// were also classified by a second method, whose result is taken as true.
struct CheckedCounts {
  Proportion classified;      ///< trials with the class by the fallible method, out of all trials
  std::uint64_t checked = 0;  ///< trials classified by both
  std::uint64_t gained = 0;   ///< checked trials with the class by the true method only
  std::uint64_t lost = 0;     ///< checked trials with the class by the fallible method only
};

/// Estimate of the true probability of the class: P(classified) + P(gained) - P(lost), each replaced by its fraction,
/// limited to [0, 1]. Unbiased except for that limit. Needs at least one trial and one checked trial.
[[nodiscard]] double corrected_estimate(const CheckedCounts& counts);

/// Interval for this probability that covers at least as often as promised. It adds exact intervals (Clopper & Pearson)
/// for the three terms that hold at once (Bonferroni): the first has half of the significance level, the others have a
/// quarter each. [0, 1] if nothing was checked; `confidence` in (0, 1). Source: the plan of Tenenbein (1970), J. Am.
/// Stat. Assoc. 65, 1350-1361; his own interval holds for large samples only.
[[nodiscard]] Interval corrected_interval(const CheckedCounts& counts, double confidence);

}  // namespace rocking::stats
