#pragma once

namespace rocking::stats {

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

/// (1 - Phi(z)) over the density of z, Mills' ratio, for z >= 0, to 5e-13 of it.
[[nodiscard]] double mills_ratio(double z);

}  // namespace rocking::stats
