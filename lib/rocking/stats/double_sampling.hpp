#pragma once

#include <cstdint>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Trials that a fallible method named, and of which some, chosen without regard to the outcome, were named by one that is
/// taken for the truth as well.
struct CheckedCounts {
  Proportion named;           ///< had the name by the fallible method, of all trials
  std::uint64_t checked = 0;  ///< trials named by both
  std::uint64_t gained = 0;   ///< of them, had the name by the truth alone
  std::uint64_t lost = 0;     ///< of them, had the name by the fallible method alone
};

/// Probability of the name by the truth: P(named) + P(gained) - P(lost), each by its fraction, cut to [0, 1]. Without bias
/// but for the cut. Needs a trial, and one that was checked.
[[nodiscard]] double corrected_estimate(const CheckedCounts& counts);

/// An interval for it that covers at least as often as promised: exact intervals (Clopper & Pearson) for the three terms
/// at once, the first with half of the doubt, the others with a quarter each (Bonferroni). [0, 1] where nothing was checked.
/// The plan is Tenenbein's (1970), J. Am. Stat. Assoc. 65, 1350-1361; his interval holds in large samples only.
[[nodiscard]] Interval corrected_interval(const CheckedCounts& counts, double confidence);

}  // namespace rocking::stats
