#pragma once

#include <cstdint>
#include <optional>

#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// Trials that were made twice, under two settings with the same draws: in how many something happened.
struct PairedCounts {
  std::uint64_t both = 0;
  std::uint64_t first_only = 0;
  std::uint64_t second_only = 0;
  std::uint64_t neither = 0;

  [[nodiscard]] std::uint64_t discordant() const { return first_only + second_only; }
  [[nodiscard]] std::uint64_t trials() const { return both + discordant() + neither; }
};

/// McNemar's test of whether it happens equally often under both settings: if so, each discordant trial falls on either
/// side with probability 1/2.
struct McNemar {
  double p_value = 1.0;  ///< exact: rejects at a level with at most that probability
  double mid_p = 1.0;    ///< of the outcome itself only half is counted: nearer to the level, may exceed it by a little
};

/// p = min(1, 2 P(K <= min(b, c))), K ~ Binomial(b + c, 1/2); mid-p = 2 P(K <= min(b, c)) - P(K = min(b, c)). 1 where
/// no trial is discordant.
/// Source: McNemar (1947), Psychometrika 12, 153-157; Fagerland, Lydersen, Laake (2013), BMC Med. Res. Methodol. 13,
/// 91.
[[nodiscard]] McNemar mcnemar(const PairedCounts& counts);

/// How much more often it happens under the first setting than under the second, in [-1, 1]. At least one trial.
[[nodiscard]] double paired_difference(const PairedCounts& counts);

/// The score interval for it: those d for which (b - c - n d) over its standard deviation under d, with the likeliest
/// nuisance parameter, is at most z. Covers about as often as promised: the one to plot. [-1, 1] without trials.
/// Source: Tango (1998), Stat. Med. 17, 891-908.
[[nodiscard]] Interval paired_difference_score(const PairedCounts& counts, double confidence);

/// An interval that covers at least as often as promised, for every n and all probabilities: the one to claim. [-1, 1]
/// without trials.
///
/// d = r (2 q - 1), where r is the probability that a trial is discordant and q that such a one falls on the first
/// side. Exact intervals (Clopper & Pearson) for r, with a tenth of the doubt, and for q, with the rest (given the
/// number of discordant trials, hence also without it), hold at once; all d that they allow are taken.
[[nodiscard]] Interval paired_difference_exact(const PairedCounts& counts, double confidence);

/// What common draws are worth: variance of one trial's difference, as it is and as it were with independent draws.
struct VarianceReduction {
  double paired = 0.0;           ///< (b + c)/n - d^2
  double independent = 0.0;      ///< p (1 - p) of the first setting, and of the second
  std::optional<double> factor;  ///< independent/paired: so many times fewer trials; absent where no two trials differ
};

/// Needs at least one trial.
[[nodiscard]] VarianceReduction variance_reduction(const PairedCounts& counts);

}  // namespace rocking::stats
