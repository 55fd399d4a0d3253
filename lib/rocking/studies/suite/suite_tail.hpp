#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rocking/studies/suite/suite_curve.hpp"

namespace rocking {

/// Rare estimates of a suite below its lowest level with ten events, record by record: sampling that is stratified by
/// records, each with its weight.
class SuiteTail {
 public:
  explicit SuiteTail(const SuiteCurve& curve);

  [[nodiscard]] std::size_t size() const { return intensities_.size(); }
  [[nodiscard]] const std::vector<double>& intensities() const { return intensities_; }
  /// The level from which on the shares count; absent: there is no tail.
  [[nodiscard]] std::optional<double> end() const { return end_; }
  /// ln x of the estimates, and of the end; empty without a tail.
  [[nodiscard]] const std::vector<double>& y() const { return y_; }
  /// Of one record; 0 where it has no estimate.
  [[nodiscard]] const std::vector<double>& of_record(std::size_t record) const { return of_records_[record]; }
  /// Means over the records with these weights, >= 0, not all 0.
  [[nodiscard]] std::vector<double> means(const std::vector<double>& weights) const;

 private:
  std::vector<double> intensities_;
  std::optional<double> end_;
  std::vector<double> y_;
  std::vector<std::vector<double>> of_records_;
};

}  // namespace rocking
