#pragma once

namespace rocking::stats {

/// N(mean, sigma^2) with given parameters, not estimated from the sample; sigma > 0.
struct NormalLaw {
  double mean = 0.0;
  double sigma = 1.0;

  /// Distance of `x` from the mean in units of sigma.
  [[nodiscard]] constexpr double score(double x) const { return (x - mean) / sigma; }
};

/// Density of the standard normal law.
[[nodiscard]] double normal_density(double z);

/// Probability that a standard normal number is at most z. Keeps its relative accuracy down to z = -37.
[[nodiscard]] double normal_cdf(double z);

/// Probability that the absolute value of a standard normal number is at least abs(z).
[[nodiscard]] double two_sided_normal_p_value(double z);

/// ln of `normal_cdf(z)`, for z > -1e150, also if the probability itself is too small for a double.
[[nodiscard]] double log_normal_cdf(double z);

}  // namespace rocking::stats
