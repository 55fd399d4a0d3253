#pragma once

#include <cstddef>
#include <cstdint>

namespace rocking::stats {

/// Closed interval.
struct Interval {
  double low = 0.0;
  double high = 0.0;
};

/// Successes out of trials.
struct Proportion {
  std::uint64_t successes = 0;
  std::uint64_t trials = 0;
};

/// Confidence intervals for the probability behind a proportion. All lie in [0, 1] and contain successes/trials;
/// without trials nothing is known and they are [0, 1]. `confidence` in (0, 1), two-sided.

/// The score interval: those p whose distance from the proportion is at most z sqrt(p (1 - p)/n).
///
/// Covers the truth with the promised probability on the average over p, for some p less often: the one to plot.
/// Source: Wilson (1927), J. Am. Stat. Assoc. 22, 209-212.
[[nodiscard]] Interval wilson(const Proportion& proportion, double confidence);

/// The exact interval: those p under which neither tail from the count onward has less than (1 - confidence)/2.
///
///     P(K >= k | low) = (1 - confidence)/2 (low = 0 for k = 0),   P(K <= k | high) = the same (high = 1 for k = n)
///
/// Covers the truth at least as often as it promises, for every p and n: the one to claim.
/// Source: Clopper & Pearson (1934), Biometrika 26, 404-413.
[[nodiscard]] Interval clopper_pearson(const Proportion& proportion, double confidence);

/// The exact interval at level 1 - (1 - confidence)/categories: one of `categories` intervals, at least 1, that
/// cover all their truths at once with probability `confidence` or more (Bonferroni's inequality).
[[nodiscard]] Interval bonferroni_clopper_pearson(const Proportion& proportion, double confidence,
                                                  std::size_t categories);

}  // namespace rocking::stats
