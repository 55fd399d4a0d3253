#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/stats/fit_suite.hpp"
#include "rocking/stats/interval.hpp"

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

/// Shares of the trials of each record with the event, and their means over records: without a law.
class RecordShares {
 public:
  /// What trials whose outcome is not known count as.
  enum class Unresolved : std::uint8_t { as_not_happened, as_happened };

  /// Of a suite whose records have the same intensities, or some of them, by growing intensity.
  explicit RecordShares(const SuiteLevels& suite, Unresolved unresolved = Unresolved::as_not_happened);

  [[nodiscard]] std::size_t records() const { return shares_.size(); }
  [[nodiscard]] const std::vector<double>& intensities() const { return intensities_; }
  /// The shares of one record at the intensities; the mean over the others at those that it has not.
  [[nodiscard]] const std::vector<double>& of_record(std::size_t record) const { return shares_[record]; }
  /// Means at the intensities, each record with its weight, >= 0, not all 0 at any intensity.
  [[nodiscard]] std::vector<double> mean(const std::vector<double>& weights) const;
  /// At each intensity the share of a further record with this weight in the sum of the weights.
  [[nodiscard]] std::vector<double> shares_of_another(const std::vector<double>& weights, double weight) const;
  /// The values that do not decrease and are nearest to these means by squares.
  [[nodiscard]] std::vector<double> isotonic(const std::vector<double>& weights) const;

 private:
  /// Whether a record has an intensity.
  [[nodiscard]] bool has(std::size_t record, std::size_t place) const { return !is_absent_[record][place]; }

  std::vector<double> intensities_;
  std::vector<std::vector<double>> shares_;
  std::vector<std::vector<bool>> is_absent_;
};

}  // namespace rocking::stats
