#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rocking/stats/fit_suite.hpp"

namespace rocking::stats {

/// Shares of the trials of each record with the event, and their means over records: without a law.
class RecordShares {
 public:
  /// What trials whose outcome is not known count as.
  enum class Unresolved : std::uint8_t { as_not_happened, as_happened };

  /// Of a suite whose records have the same intensities, by growing intensity.
  explicit RecordShares(const SuiteLevels& suite, Unresolved unresolved = Unresolved::as_not_happened);

  [[nodiscard]] std::size_t records() const { return shares_.size(); }
  [[nodiscard]] const std::vector<double>& intensities() const { return intensities_; }
  /// The shares of one record at the intensities.
  [[nodiscard]] const std::vector<double>& of_record(std::size_t record) const { return shares_[record]; }
  /// Means at the intensities, each record with its weight, >= 0, not all 0.
  [[nodiscard]] std::vector<double> mean(const std::vector<double>& weights) const;
  /// The values that do not decrease and are nearest to these means by squares.
  [[nodiscard]] std::vector<double> isotonic(const std::vector<double>& weights) const;

 private:
  std::vector<double> intensities_;
  std::vector<std::vector<double>> shares_;
};

}  // namespace rocking::stats
