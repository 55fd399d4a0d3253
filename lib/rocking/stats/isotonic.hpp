#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rocking/stats/interval.hpp"

/// Probabilities that do not decrease from one level to the next.
namespace rocking::stats {

/// Most likely probabilities that do not decrease, for independent counts at successive levels: shares of the counts,
/// where levels whose shares decrease are pooled until none does. Each level has at least one trial.
/// Source: Ayer, Brunk, Ewing, Reid & Silverman (1955), Ann. Math. Stat. 26, 641-647 (pool adjacent violators).
[[nodiscard]] std::vector<double> isotonic_regression(std::span<const Proportion> levels);

/// The same for means `values` with these positive `weights`, the nearest by weighted squares; without a law of counts.
[[nodiscard]] std::vector<double> isotonic_regression(std::span<const double> values, std::span<const double> weights);

/// Intervals for probabilities that do not decrease; all of them cover at once with probability at least `confidence`,
/// whatever the dependence between the levels.
///
/// The lower end at a level is the largest lower end of the Bonferroni-Clopper-Pearson intervals up to this level; the
/// upper end is the smallest upper end from this level on. Absent where some interval lies above an interval of a later
/// level: the counts then contradict probabilities that do not decrease.
[[nodiscard]] std::optional<std::vector<Interval>> isotonic_band(std::span<const Proportion> levels, double confidence);

}  // namespace rocking::stats
