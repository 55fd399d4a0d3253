#pragma once

#include <cstdint>
#include <optional>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Counts of trials that were run under two settings with common random numbers, by the setting in which an event
/// happened.
struct PairedCounts {
  std::uint64_t both = 0;
  std::uint64_t first_only = 0;
  std::uint64_t second_only = 0;
  std::uint64_t neither = 0;

  [[nodiscard]] std::uint64_t discordant() const { return first_only + second_only; }
  [[nodiscard]] std::uint64_t trials() const { return both + discordant() + neither; }
};

/// McNemar's test of equal probability under both settings. Under that hypothesis each discordant trial falls on either
/// side with probability 1/2.
struct McNemar {
  double p_value = 1.0;  ///< exact: rejects at a level with at most that probability
  /// Counts half of the probability of the outcome itself: nearer to the level, may exceed it slightly.
  double mid_p = 1.0;
};

/// p = min(1, 2 P(K <= min(b, c))), K ~ Binomial(b + c, 1/2); mid-p = 2 P(K <= min(b, c)) - P(K = min(b, c)). Both are
/// 1 if no trial is discordant. Source: McNemar (1947), Psychometrika 12, 153-157; Fagerland, Lydersen, Laake (2013),
/// BMC Med. Res. Methodol. 13, 91.
[[nodiscard]] McNemar mcnemar(const PairedCounts& counts);

/// Probability under the first setting minus that under the second, estimated; in [-1, 1]. Needs at least one trial.
[[nodiscard]] double paired_difference(const PairedCounts& counts);

/// Score interval for this difference d: those d for which (b - c - n d) is at most z times its standard deviation
/// under d, with the maximum-likelihood nuisance parameter. Covers about as often as promised; recommended for figures.
/// [-1, 1] without trials. Source: Tango (1998), Stat. Med. 17, 891-908.
[[nodiscard]] Interval paired_difference_score(const PairedCounts& counts, double confidence);

/// Interval for the difference that covers at least as often as promised, for every n and all probabilities;
/// recommended for statements. [-1, 1] without trials.
///
/// d = r (2 q - 1), where r is the probability that a trial is discordant and q the probability that a discordant trial
/// falls on the first side. Two exact intervals (Clopper & Pearson) hold at once: one for r with a tenth of the
/// significance level, one for q with the rest. (The latter holds given the number of discordant trials, hence also
/// unconditionally.) The result contains all d that they allow.
[[nodiscard]] Interval paired_difference_exact(const PairedCounts& counts, double confidence);

/// Gain from common random numbers: variance of the difference of one trial with them, and with independent random
/// numbers. Their ratio `factor` is the factor by which fewer trials suffice.
struct VarianceReduction {
  double paired = 0.0;           ///< (b + c)/n - d^2
  double independent = 0.0;      ///< p (1 - p) of the first setting plus that of the second
  std::optional<double> factor;  ///< independent/paired; absent if no trial is discordant
};

/// Needs at least one trial.
[[nodiscard]] VarianceReduction variance_reduction(const PairedCounts& counts);

}  // namespace rocking::stats
