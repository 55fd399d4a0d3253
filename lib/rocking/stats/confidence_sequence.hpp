#pragma once

#include "rocking/stats/family.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Intervals for a probability that cover it at all numbers of trials at once, so that looking at them after every
/// trial, and stopping because of what they show, spoils nothing. For one n alone `clopper_pearson` is narrower.
///
/// If each trial succeeds with probability p, the likelihood of the counts averaged over q ~ Beta(c p, c (1 - p)), over
/// their likelihood at p,
///
///     M_c = B(c p + k, c (1 - p) + n - k)/(B(c p, c (1 - p)) p^k (1 - p)^(n - k)),
///
/// is a martingale that starts at 1, and so is the average M of several: with probability 1 - d or more it stays below
/// 1/d for ever (Ville's inequality). The interval at n holds the p for which it is still below. ln M_c is convex in p
/// and in ln p, hence so is ln M; therefore the set is an interval, also where d is proportional to p.
///
/// Three concentrations are averaged: c, with weight 1/2, makes the interval narrow about the number of trials that are
/// expected; c/8 and c/64, with 1/4 each, make it so for the fewer trials that do where p is near 0 or 1.
///
/// All is computed from IEEE operations and base/elementary.hpp alone: where a run stops depends on it, to the bit.
/// Source: Robbins (1970), Ann. Math. Stat. 41, 1397-1409; Howard, Ramdas, McAuliffe, Sekhon (2021), Ann. Stat. 49,
/// 1055-1080.
class ConfidenceSequence {
 public:
  explicit ConfidenceSequence(double concentration);  ///< c > 0

  /// ln M for 0 < p < 1, with an error of about 1e-14 n.
  [[nodiscard]] double log_martingale(const Proportion& counts, double p) const;

  /// The p with M < 1/doubt(p), to 2^-40 of an end, rounded outwards. [0, 1] without trials; contains successes/trials.
  /// Cost: some 80 values of ln M.
  [[nodiscard]] Interval interval(const Proportion& counts, const Doubt& doubt) const;

 private:
  double concentration_;
};

/// The concentration that makes the interval narrowest about so many trials: n/r, r = 2 ln(1/doubt) + ln(1 + 2
/// ln(1/doubt)), at least 1. Four times too few or too many trials cost 5 % of width.
/// Source: Howard et al. (2021), section 3.5, to the first order.
[[nodiscard]] double concentration_for(double trials, double doubt);

/// How many trials the interval of one such concentration needs for a half-width at p = 1/2, the worst case:
/// (1 + 1/r)(2 ln(1/doubt) + ln(1 + r))/(4 half_width^2), to the first order. The average of three needs 6 % more.
[[nodiscard]] double trials_for(double half_width, double doubt);

}  // namespace rocking::stats
