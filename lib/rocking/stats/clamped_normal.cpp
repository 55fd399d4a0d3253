#include "rocking/stats/clamped_normal.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

/// x times the density, 0 at infinity.
double moment_density(double x) { return std::isfinite(x) ? x * normal_density(x) : 0.0; }

}  // namespace

MeanAndSigma clamped_normal(const MeanAndSigma& law, double low, double high) {
  // In standard units about the mean: E[u] and E[u^2] of u = min(max(z, a), b).
  const double a = (low - law.mean) / law.sigma;
  const double b = (high - law.mean) / law.sigma;
  const double below = normal_cdf(a), above = normal_cdf(-b);
  const auto part = [](double weight, double value) { return weight > 0.0 ? weight * value : 0.0; };
  const double mean = part(below, a) + part(above, b) + normal_density(a) - normal_density(b);
  const double square =
      part(below, a * a) + part(above, b * b) + (1.0 - below - above) + moment_density(a) - moment_density(b);
  return {law.mean + law.sigma * mean, law.sigma * std::sqrt(std::max(0.0, square - mean * mean))};
}

MeanAndSigma smaller_of_normals(const MeanAndSigma& first, const MeanAndSigma& second, double correlation) {
  const double spread = std::sqrt(std::max(
      0.0, first.sigma * first.sigma + second.sigma * second.sigma - 2.0 * correlation * first.sigma * second.sigma));
  if (!(spread > 0.0)) return first.mean <= second.mean ? first : second;
  const double ahead = (second.mean - first.mean) / spread;
  const double is_first = normal_cdf(ahead), is_second = normal_cdf(-ahead);
  const double mean = first.mean * is_first + second.mean * is_second - spread * normal_density(ahead);
  const double square = (first.mean * first.mean + first.sigma * first.sigma) * is_first +
                        (second.mean * second.mean + second.sigma * second.sigma) * is_second -
                        (first.mean + second.mean) * spread * normal_density(ahead);
  return {mean, std::sqrt(std::max(0.0, square - mean * mean))};
}

}  // namespace rocking::stats
