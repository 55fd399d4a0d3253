#pragma once

#include <cstddef>
#include <cstdint>

#include "rocking/stats/family.hpp"

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

/// The equal-tailed posterior interval under Jeffreys's prior: quantiles of Beta(k + 1/2, n - k + 1/2); from 0 for k =
/// 0 and to 1 for k = n, without which it would never cover a p near 0 or 1.
///
/// Covers on the average over p, as `wilson` does, and lies less to the middle.
/// Source: Brown, Cai, DasGupta (2001), Stat. Sci. 16, 101-133.
[[nodiscard]] Interval jeffreys(const Proportion& proportion, double confidence);

/// The exact interval: those p under which neither tail from the count onward has less than (1 - confidence)/2.
///
///     P(K >= k | low) = (1 - confidence)/2 (low = 0 for k = 0),   P(K <= k | high) = the same (high = 1 for k = n)
///
/// Covers the truth at least as often as it promises, for every p and n: the one to claim.
/// Source: Clopper & Pearson (1934), Biometrika 26, 404-413.
[[nodiscard]] Interval clopper_pearson(const Proportion& proportion, double confidence);

/// Clopper and Pearson's with a doubt: those p under which neither tail has less than doubt(p)/2. Misses each p with
/// probability doubt(p) at most. doubt(1) < 1.
///
/// One crossing on each side: the upper tail is convex, then concave in p, and ends above the straight line of the
/// doubt. Where the doubt is proportional to p, one success out of any number of trials leaves low = 0: among ever so
/// many rare categories some occur.
[[nodiscard]] Interval exact_interval(const Proportion& proportion, const Doubt& doubt);

/// Of several categories, `wilson` at level 1 - (1 - confidence)/categories for each. Good for large counts; covers all
/// of them at once about as often as promised, not always.
/// Source: Goodman (1965), Technometrics 7, 247-254.
[[nodiscard]] Interval goodman(const Proportion& proportion, double confidence, std::size_t categories);

/// The exact interval at level 1 - (1 - confidence)/categories: one of `categories` intervals, at least 1, settled
/// before there were data, that cover all their truths at once with probability `confidence` or more (Bonferroni's
/// inequality).
[[nodiscard]] Interval bonferroni_clopper_pearson(const Proportion& proportion, double confidence,
                                                  std::size_t categories);

}  // namespace rocking::stats
