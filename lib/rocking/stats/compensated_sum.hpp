#pragma once

#include <cmath>

namespace rocking::stats {

/// A sum with compensation of its rounding errors. Its error is at most 1 ulp plus n^2 eps^2 times the sum of absolute
/// values.
///
/// Source: Neumaier (1974), Z. Angew. Math. Mech. 54, 39-51.
class CompensatedSum {
 public:
  void add(double term) {
    const double sum = sum_ + term;
    error_ += std::abs(sum_) >= std::abs(term) ? (sum_ - sum) + term : (term - sum) + sum_;
    sum_ = sum;
  }

  [[nodiscard]] double value() const { return sum_ + error_; }

 private:
  double sum_ = 0.0;
  double error_ = 0.0;
};

}  // namespace rocking::stats
