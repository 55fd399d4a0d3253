#include "rocking/stats/normality.hpp"

#include <cmath>

#include "rocking/base/error.hpp"
#include "rocking/stats/moments.hpp"

namespace rocking::stats {
namespace {

/// Chi-squared of 2 degrees of freedom is an exponential law.
TestOfFit against_chi_squared_of_two(double statistic) { return {statistic, std::exp(-0.5 * statistic)}; }

}  // namespace

// D'Agostino's transformation is Johnson's S_U curve with the same first four moments.
double skewness_score(double skewness, std::size_t size) {
  ROCKING_EXPECT(size >= 8);
  const auto n = static_cast<double>(size);
  const double y = skewness * std::sqrt((n + 1.0) * (n + 3.0) / (6.0 * (n - 2.0)));
  const double kurtosis =
      3.0 * (n * n + 27.0 * n - 70.0) * (n + 1.0) * (n + 3.0) / ((n - 2.0) * (n + 5.0) * (n + 7.0) * (n + 9.0));
  const double w_squared = std::sqrt(2.0 * (kurtosis - 1.0)) - 1.0;
  const double delta = 1.0 / std::sqrt(0.5 * std::log(w_squared));
  const double alpha = std::sqrt(2.0 / (w_squared - 1.0));
  return delta * std::asinh(y / alpha);
}

// Anscombe & Glynn's transformation is the cube root of a chi-squared number of A degrees.
double kurtosis_score(double kurtosis, std::size_t size) {
  ROCKING_EXPECT(size >= 8);
  const auto n = static_cast<double>(size);
  const double variance = 24.0 * n * (n - 2.0) * (n - 3.0) / ((n + 1.0) * (n + 1.0) * (n + 3.0) * (n + 5.0));
  const double x = (kurtosis - 3.0 * (n - 1.0) / (n + 1.0)) / std::sqrt(variance);
  const double beta = 6.0 * (n * n - 5.0 * n + 2.0) / ((n + 7.0) * (n + 9.0)) *
                      std::sqrt(6.0 * (n + 3.0) * (n + 5.0) / (n * (n - 2.0) * (n - 3.0)));
  const double a = 6.0 + 8.0 / beta * (2.0 / beta + std::sqrt(1.0 + 4.0 / (beta * beta)));
  const double ratio = (1.0 - 2.0 / a) / (1.0 + x * std::sqrt(2.0 / (a - 4.0)));  // < 0 only for extremely small b2
  return (1.0 - 2.0 / (9.0 * a) - std::cbrt(ratio)) / std::sqrt(2.0 / (9.0 * a));
}

TestOfFit jarque_bera(std::span<const double> sample) {
  ROCKING_EXPECT(sample.size() >= 4);
  const CentralMoments central = central_moments(sample);
  const double skewness = central.skewness();
  const double excess = central.kurtosis() - 3.0;
  const auto n = static_cast<double>(sample.size());
  return against_chi_squared_of_two(n / 6.0 * (skewness * skewness + 0.25 * excess * excess));
}

TestOfFit dagostino_pearson(std::span<const double> sample) {
  ROCKING_EXPECT(sample.size() >= 8);
  const CentralMoments central = central_moments(sample);
  const double z1 = skewness_score(central.skewness(), sample.size());
  const double z2 = kurtosis_score(central.kurtosis(), sample.size());
  return against_chi_squared_of_two(z1 * z1 + z2 * z2);
}

}  // namespace rocking::stats
