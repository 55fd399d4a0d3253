#pragma once

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

}  // namespace rocking::stats
