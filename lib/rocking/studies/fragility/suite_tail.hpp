#pragma once

#include <cstddef>
#include <vector>

#include "rocking/studies/fragility/rare_tail.hpp"
#include "rocking/studies/fragility/suite_curve.hpp"

namespace rocking {

/// The rare estimates that give the lower tail of a suite (used_rare), record by record: sampling that is stratified by
/// records, each with its weight.
class SuiteTail {
 public:
  explicit SuiteTail(const SuiteCurve& curve);

  [[nodiscard]] std::size_t size() const { return used_.estimates.size(); }
  [[nodiscard]] const UsedRare& used() const { return used_; }
  /// ln x of the estimates, and of the end; empty without a tail.
  [[nodiscard]] const std::vector<double>& y() const { return y_; }
  /// Of one record; 0 where it has no estimate.
  [[nodiscard]] const std::vector<double>& of_record(std::size_t record) const { return of_records_[record]; }
  /// Means over the records with these weights, >= 0, not all 0.
  [[nodiscard]] std::vector<double> means(const std::vector<double>& weights) const;

 private:
  UsedRare used_;
  std::vector<double> y_;
  std::vector<std::vector<double>> of_records_;
};

}  // namespace rocking
