#include "rocking/stats/normal_law.hpp"

#include <cmath>
#include <numbers>

#include <boost/math/special_functions/erf.hpp>

namespace rocking::stats {

double normal_density(double z) { return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi); }

double normal_cdf(double z) { return 0.5 * boost::math::erfc(-z / std::numbers::sqrt2); }

double two_sided_normal_p_value(double z) { return 2.0 * normal_cdf(-std::abs(z)); }

double log_normal_cdf(double z) {
  if (z > 0.0) return std::log1p(-normal_cdf(-z));
  if (z > -30.0) return std::log(normal_cdf(z));
  // Laplace's series; at z = -30 the first omitted term, 105/z^8, is 2e-10 of a value of 454.
  const double y = 1.0 / (z * z);
  const double series = -y * (1.0 - y * (3.0 - 15.0 * y));
  return -0.5 * z * z - std::log(-z * std::sqrt(2.0 * std::numbers::pi)) + std::log1p(series);
}

}  // namespace rocking::stats
