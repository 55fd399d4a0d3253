#pragma once

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

}  // namespace rocking::stats
