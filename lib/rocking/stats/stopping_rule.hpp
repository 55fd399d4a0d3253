#pragma once

#include <cstdint>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Confidence sequence: intervals for a probability that cover it at all numbers of trials at once. They remain valid
/// if one looks at them after every trial and stops because of what they show. For one fixed n, `clopper_pearson` is
/// narrower.
///
/// Let each trial succeed with probability p. Average the likelihood of the counts over q ~ Beta(c p, c (1 - p)) and
/// divide it by the likelihood at p:
///
///     M_c = B(c p + k, c (1 - p) + n - k)/(B(c p, c (1 - p)) p^k (1 - p)^(n - k)),
///
/// This ratio is a martingale that starts at 1. So is the average M of several such ratios. With probability at least 1
/// - d, M stays below 1/d for all n (Ville's inequality). The interval at n contains the p for which M is still below
/// 1/d. ln M_c is convex in p and in ln p, hence so is ln M; therefore the set is an interval, also if d is
/// proportional to p.
///
/// Three concentrations are averaged. c, with weight 1/2, makes the interval narrow at about the expected number of
/// trials. c/8 and c/64, with weight 1/4 each, do so at smaller numbers of trials, which suffice if p is near 0 or 1.
///
/// Uses only IEEE operations and base/elementary.hpp: the end of a run depends on the bits of the result.
/// Source: Robbins (1970), Ann. Math. Stat. 41, 1397-1409; Howard, Ramdas, McAuliffe, Sekhon (2021), Ann. Stat. 49,
/// 1055-1080.
class ConfidenceSequence {
 public:
  explicit ConfidenceSequence(double concentration);  ///< c > 0

  /// ln M for 0 < p < 1. Absolute error about 1e-14 n.
  [[nodiscard]] double log_martingale(const Proportion& counts, double p) const;

  /// The p with M < 1/significance(p). The ends are computed with a relative error of 2^-40 and rounded outwards.
  /// Contains successes/trials; [0, 1] without trials. Cost: about 80 values of ln M.
  [[nodiscard]] Interval interval(const Proportion& counts, const Significance& significance) const;

 private:
  double concentration_;
};

/// The concentration that makes the interval narrowest at about this number of trials: n/r, r = 2 ln(1/significance) +
/// ln(1 + 2 ln(1/significance)), at least 1. If the actual number is four times larger or smaller, the interval is 5 %
/// wider. Source: Howard et al. (2021), section 3.5, to the first order.
[[nodiscard]] double concentration_for(double trials, double significance);

/// Number of trials at which the interval of one such concentration has this half-width at p = 1/2, the worst case: (1
/// + 1/r)(2 ln(1/significance) + ln(1 + r))/(4 half_width^2), to first order. The average of three needs 6 % more.
[[nodiscard]] double trials_for(double half_width, double significance);

/// How the half-width of an interval is measured: as a probability, or relative to the estimate k/n. Relative to an
/// estimate of 0 no half-width is narrow.
enum class HalfWidthScale : std::uint8_t { absolute, relative };

/// Goal of a stopping rule: the wanted precision and the largest number of trials.
struct StoppingGoal {
  double half_width = 0.0;  ///< wanted half-width, in (0, 1/2); relative: in (0, 1)
  HalfWidthScale scale = HalfWidthScale::absolute;
  std::uint64_t at_most = 0;  ///< trials, >= 1
  Family family;
};

/// Determines at which numbers of trials to look and, from the counts there, whether the interval of every category, or
/// that of one, is as narrow as wanted. The intervals are confidence sequences: all of them cover at once, at all n at
/// once, with the confidence of the family. They therefore remain valid if sampling stops because of them, whichever of
/// them the decision uses.
///
/// A pure function of goal and counts, with the same bits on every machine: where a run stops does not depend on
/// threads, compilers or libraries.
class StoppingRule {
 public:
  explicit StoppingRule(const StoppingGoal& goal);

  /// The next number of trials at which to look, after `trials` of them: 50, 60, ..., 100, then 10 % more each time, in
  /// whole tens, at most `at_most`. It depends on the number of trials only, so that a resumed run looks at the same
  /// numbers as an uninterrupted one. A look comes at most 10 % late (at 50, 20 %). The intervals are valid for any
  /// schedule.
  [[nodiscard]] std::uint64_t next_look(std::uint64_t trials) const;

  /// Whether all intervals have the wanted half-width: those of the prespecified categories, of the others that
  /// occurred, and of any category that has not occurred.
  [[nodiscard]] bool narrow_enough(const CategoryCounts& counts) const;

  /// Whether one interval, that of these counts, has the wanted half-width.
  [[nodiscard]] bool narrow_enough(const Proportion& counts, const Interval& interval) const;

  /// The intervals that the rule uses; these are the ones to report.
  [[nodiscard]] Interval interval_of_prespecified(const Proportion& counts) const;
  [[nodiscard]] Interval interval_of_others(const Proportion& counts) const;
  /// For a part of a category, whose significance the parts divide.
  [[nodiscard]] Interval interval(const Proportion& counts, const Significance& significance) const {
    return sequence_.interval(counts, significance);
  }

 private:
  StoppingGoal goal_;
  ConfidenceSequence sequence_;
};

}  // namespace rocking::stats
