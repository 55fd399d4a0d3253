#include "rocking/stats/kolmogorov_smirnov.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

/// P(sqrt(n) D >= x) for n = infinity, by the one of Kolmogorov's two series that converges quickly. Both stop before a
/// negligible term: 1e-20 where the series change.
double limiting_tail(double x) {
  if (x <= 0.0) return 1.0;
  double sum = 0.0;
  if (x < 0.85) {
    const double exponent = std::numbers::pi * std::numbers::pi / (8.0 * x * x);
    for (const double odd : {1.0, 3.0, 5.0, 7.0}) sum += std::exp(-odd * odd * exponent);
    return 1.0 - std::sqrt(2.0 * std::numbers::pi) / x * sum;
  }
  for (const double k : {1.0, 3.0, 5.0}) {
    sum += std::exp(-2.0 * k * k * x * x) - std::exp(-2.0 * (k + 1.0) * (k + 1.0) * x * x);
  }
  return 2.0 * sum;
}

}  // namespace

double kolmogorov_p_value(double distance, std::size_t n) {
  ROCKING_EXPECT(n >= 1);
  const auto size = static_cast<double>(n);
  const double x = std::sqrt(size) * distance;
  return std::clamp(limiting_tail(x + 1.0 / (6.0 * std::sqrt(size)) + (x - 1.0) / (4.0 * size)), 0.0, 1.0);
}

TestOfFit kolmogorov_smirnov(std::span<const double> sample, const NormalLaw& law) {
  ROCKING_EXPECT(!sample.empty() && law.sigma > 0.0);
  std::vector<double> sorted(sample.begin(), sample.end());
  std::sort(sorted.begin(), sorted.end());
  const auto n = static_cast<double>(sorted.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double probability = normal_cdf(law.score(sorted[i]));
    const double below = probability - static_cast<double>(i) / n;
    const double above = static_cast<double>(i + 1) / n - probability;
    distance = std::max({distance, below, above});
  }
  return {distance, kolmogorov_p_value(distance, sorted.size())};
}

}  // namespace rocking::stats
