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

/// Number of successes out of a number of trials.
struct Proportion {
  std::uint64_t successes = 0;
  std::uint64_t trials = 0;
};

/// Two-sided confidence intervals for a probability; `confidence` in (0, 1). All lie in [0, 1] and contain
/// successes/trials. Without trials they are [0, 1].

/// Score interval: those p whose distance from the proportion is at most z sqrt(p (1 - p)/n).
///
/// Its coverage equals the confidence on average over p; for some p it is lower. Recommended for figures.
/// Source: Wilson (1927), J. Am. Stat. Assoc. 22, 209-212.
[[nodiscard]] Interval wilson(const Proportion& proportion, double confidence);

/// Equal-tailed posterior interval under Jeffreys's prior: quantiles of Beta(k + 1/2, n - k + 1/2). The lower end is 0
/// for k = 0 and the upper end is 1 for k = n; otherwise the interval would never cover p near 0 or 1.
///
/// Its coverage is right on average over p, as for `wilson`; its centre is nearer to the proportion.
/// Source: Brown, Cai, DasGupta (2001), Stat. Sci. 16, 101-133.
[[nodiscard]] Interval jeffreys(const Proportion& proportion, double confidence);

/// Exact interval: those p for which neither tail from the count outwards has a probability below (1 - confidence)/2.
///
///     P(K >= k | low) = (1 - confidence)/2 (low = 0 for k = 0),   P(K <= k | high) = the same (high = 1 for k = n)
///
/// Covers the true value at least as often as promised, for every p and n. Recommended for statements.
/// Source: Clopper & Pearson (1934), Biometrika 26, 404-413.
[[nodiscard]] Interval clopper_pearson(const Proportion& proportion, double confidence);

/// As clopper_pearson, with a significance level that may depend on p: those p for which neither tail has a probability
/// below significance(p)/2. Each p is missed with probability at most significance(p). Requires significance(1) < 1.
///
/// There is one crossing on each side: the upper tail is convex, then concave in p, and ends above the straight line of
/// the significance level. If that level is proportional to p, one success out of any number of trials gives low = 0:
/// among many rare categories some are expected to occur.
[[nodiscard]] Interval exact_interval(const Proportion& proportion, const Significance& significance);

/// Interval for one of several categories: `wilson` at level 1 - (1 - confidence)/categories. For large counts only; it
/// covers all categories at once with about, not at least, the promised probability.
/// Source: Goodman (1965), Technometrics 7, 247-254.
[[nodiscard]] Interval goodman(const Proportion& proportion, double confidence, std::size_t categories);

/// The exact interval at level 1 - (1 - confidence)/categories, for one of `categories` >= 1 categories fixed before
/// there were data. All of these intervals cover at once with probability at least `confidence` (Bonferroni's
/// inequality).
[[nodiscard]] Interval bonferroni_clopper_pearson(const Proportion& proportion, double confidence,
                                                  std::size_t categories);

}  // namespace rocking::stats
