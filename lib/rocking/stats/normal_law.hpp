#pragma once

#include <span>

namespace rocking::stats {

/// Half-width of a two-sided interval in standard errors, by Student's law; by the normal law if the degrees of freedom
/// are infinite. confidence in (0, 1), degrees_of_freedom > 0.
[[nodiscard]] double two_sided_t_quantile(double confidence, double degrees_of_freedom);

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

/// Mean and standard deviation of a law.
struct MeanAndSigma {
  double mean = 0.0;
  double sigma = 0.0;
};

/// Those of a normal number that is moved to `low` or `high` where it lies beyond. sigma > 0, low < high; infinities are
/// allowed.
[[nodiscard]] MeanAndSigma clamped_normal(const MeanAndSigma& law, double low, double high);

/// Those of the smaller of two normal numbers with this correlation.
/// Source: Clark (1961), Oper. Res. 9(2) 145-162, for the larger one.
[[nodiscard]] MeanAndSigma smaller_of_normals(const MeanAndSigma& first, const MeanAndSigma& second,
                                              double correlation);

/// ln Phi(z), and its derivative, the density of z over Phi(z).
struct LogNormalProbability {
  double value = 0.0;
  double slope = 0.0;
};

/// Both to 1e-13 (1 + abs(value)), in a small part of the time of log_normal_cdf: by
/// quintic Hermite interpolation of both between multiples of h = 1/32 from -16 to 9. Their sixth derivatives are below
/// 0.45 and 0.6, so that its error is below 0.6 h^6/46080 = 2e-14. Below -16 by log_normal_cdf; above 9, where the value is
/// above -2e-19, by the first terms of Laplace's series.
[[nodiscard]] LogNormalProbability log_normal_probability(double z);
/// The same of each z, with the same bits, in less time.
void log_normal_probabilities(std::span<const double> z, std::span<LogNormalProbability> found);

/// (1 - Phi(z)) over the density of z, Mills' ratio, for z >= 0, to 5e-13 of it.
[[nodiscard]] double mills_ratio(double z);

}  // namespace rocking::stats
