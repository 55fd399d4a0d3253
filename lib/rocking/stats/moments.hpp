#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {

/// Mean and central moments sum (x - mean)^k/n of a sample, by two passes with compensated sums, in the order of the
/// sample.
struct CentralMoments {
  std::uint64_t n = 0;
  double mean = 0.0;
  double second = 0.0;
  double third = 0.0;
  double fourth = 0.0;

  /// g1 = m3/m2^(3/2); m2 > 0.
  [[nodiscard]] double skewness() const;
  /// b2 = m4/m2^2, near 3 for a normal law; m2 > 0.
  [[nodiscard]] double kurtosis() const;
};

/// Needs n >= 1.
[[nodiscard]] CentralMoments central_moments(std::span<const double> sample);

/// A statistic of a sample, compared with its law if the sample is normal: z = (value - its mean)/standard_error.
struct Moment {
  double value = 0.0;
  double standard_error = 0.0;  ///< its standard deviation under the law
  double z = 0.0;
};

/// The first four moments of a sample, each with its exact mean and standard deviation for n independent draws from a
/// normal law:
///
/// - mean: N(mean, sigma^2/n);
/// - standard deviation s, with n - 1: mean c4 sigma, variance (1 - c4^2) sigma^2, c4 = sqrt(2/(n-1))
///   Gamma(n/2)/Gamma((n-1)/2);
/// - skewness g1: mean 0, variance 6(n-2)/((n+1)(n+3));
/// - kurtosis b2 (3 for a normal law): mean 3(n-1)/(n+1), variance 24n(n-2)(n-3)/((n+1)^2(n+3)(n+5)).
///
/// The z of the mean is normal. The others tend to a normal law as n grows, the kurtosis most slowly.
/// Source: Fisher (1930), Proc. R. Soc. A 130, 16-28, for the last two.
struct SampleMoments {
  std::uint64_t n = 0;
  Moment mean;
  Moment standard_deviation;
  Moment skewness;
  Moment kurtosis;
};

/// Absent for fewer than four numbers, or if all are equal: skewness and kurtosis are then undefined.
[[nodiscard]] std::optional<SampleMoments> sample_moments(std::span<const double> sample, const NormalLaw& law);

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

/// Correlation of draws that should be independent: the mean of the products of their scores under the given law.
///
/// The law is given, not estimated. Therefore the mean of the statistic is 0 and its standard error is exactly
/// 1/sqrt(products); z tends to a normal law as the number of products grows.

/// Correlation of each number with the number `lag` places later; lag >= 1. Needs more than `lag` numbers.
[[nodiscard]] Moment lag_correlation(std::span<const double> sample, const NormalLaw& law, std::size_t lag);

/// Correlation within the pairs (0, 1), (2, 3), ..., each of which is computed from one Box-Muller block. A last number
/// without a partner is omitted. Needs two numbers.
[[nodiscard]] Moment pair_correlation(std::span<const double> sample, const NormalLaw& law);

/// As pair_correlation, for (score^2 - 1)/sqrt(2), whose mean is 0 and whose variance is 1. The two members of a pair
/// have the same radius. They are independent only if the law of the radius is right; this test can detect that it is
/// not.
///
/// z tends to a normal law slowly: for 20000 numbers, z > 4.9 is 2.4 times as frequent as its normal p-value says.
[[nodiscard]] Moment pair_correlation_of_squares(std::span<const double> sample, const NormalLaw& law);

/// Correlation of the numbers of two samples at equal places. Both samples have the same length >= 1.
[[nodiscard]] Moment cross_correlation(std::span<const double> sample, std::span<const double> other,
                                       const NormalLaw& law);

}  // namespace rocking::stats
