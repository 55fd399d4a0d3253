#include "rocking/stats/moments.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/special_functions/gamma.hpp>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

Moment compared(double value, double expected, double standard_error) {
  return {value, standard_error, (value - expected) / standard_error};
}

/// Compares the numbers themselves: because the mean is rounded, equal numbers can have a second moment above 0.
bool all_alike(std::span<const double> sample) {
  const auto [smallest, largest] = std::minmax_element(sample.begin(), sample.end());
  return *smallest == *largest;
}

/// E(s)/sigma of n normal draws. 1 - c4^2 is about 1/(2n) and loses digits as n grows: its relative error is 1e-9 at n
/// = 1e6.
double mean_ratio_of_standard_deviation(double n) {
  const double x = 0.5 * (n - 1.0);
  return 1.0 / (std::sqrt(x) * boost::math::tgamma_delta_ratio(x, 0.5));
}

/// Mean of `products` products; product(k) is number k. Each has mean 0 and variance 1 under the law.
template <class Product>
Moment mean_product(std::size_t products, Product product) {
  ROCKING_EXPECT(products >= 1);
  CompensatedSum sum;
  for (std::size_t k = 0; k < products; ++k) sum.add(product(k));
  const auto m = static_cast<double>(products);
  const double standard_error = 1.0 / std::sqrt(m);
  const double value = sum.value() / m;
  return {value, standard_error, value / standard_error};
}

}  // namespace

double CentralMoments::skewness() const { return third / (second * std::sqrt(second)); }

double CentralMoments::kurtosis() const { return fourth / (second * second); }

CentralMoments central_moments(std::span<const double> sample) {
  ROCKING_EXPECT(!sample.empty());
  const auto n = static_cast<double>(sample.size());
  CompensatedSum sum;
  for (const double x : sample) sum.add(x);
  const double mean = sum.value() / n;
  CompensatedSum second, third, fourth;
  for (const double x : sample) {
    const double d = x - mean;
    second.add(d * d);
    third.add(d * d * d);
    fourth.add(d * d * (d * d));
  }
  return {sample.size(), mean, second.value() / n, third.value() / n, fourth.value() / n};
}

std::optional<SampleMoments> sample_moments(std::span<const double> sample, const NormalLaw& law) {
  ROCKING_EXPECT(law.sigma > 0.0);
  if (sample.size() < 4 || all_alike(sample)) return std::nullopt;
  const CentralMoments central = central_moments(sample);
  const auto n = static_cast<double>(sample.size());
  const double c4 = mean_ratio_of_standard_deviation(n);
  const double skewness_variance = 6.0 * (n - 2.0) / ((n + 1.0) * (n + 3.0));
  const double kurtosis_variance = 24.0 * n * (n - 2.0) * (n - 3.0) / ((n + 1.0) * (n + 1.0) * (n + 3.0) * (n + 5.0));
  return SampleMoments{
      .n = central.n,
      .mean = compared(central.mean, law.mean, law.sigma / std::sqrt(n)),
      .standard_deviation = compared(std::sqrt(central.second * n / (n - 1.0)), c4 * law.sigma,
                                     law.sigma * std::sqrt((1.0 - c4) * (1.0 + c4))),
      .skewness = compared(central.skewness(), 0.0, std::sqrt(skewness_variance)),
      .kurtosis = compared(central.kurtosis(), 3.0 * (n - 1.0) / (n + 1.0), std::sqrt(kurtosis_variance))};
}

Moment lag_correlation(std::span<const double> sample, const NormalLaw& law, std::size_t lag) {
  ROCKING_EXPECT(lag >= 1 && sample.size() > lag && law.sigma > 0.0);
  return mean_product(sample.size() - lag,
                      [&](std::size_t k) { return law.score(sample[k]) * law.score(sample[k + lag]); });
}

Moment pair_correlation(std::span<const double> sample, const NormalLaw& law) {
  ROCKING_EXPECT(law.sigma > 0.0);
  return mean_product(sample.size() / 2,
                      [&](std::size_t k) { return law.score(sample[2 * k]) * law.score(sample[2 * k + 1]); });
}

Moment pair_correlation_of_squares(std::span<const double> sample, const NormalLaw& law) {
  ROCKING_EXPECT(law.sigma > 0.0);
  const auto excess = [&](double x) { return law.score(x) * law.score(x) - 1.0; };
  return mean_product(sample.size() / 2,
                      [&](std::size_t k) { return 0.5 * excess(sample[2 * k]) * excess(sample[2 * k + 1]); });
}

Moment cross_correlation(std::span<const double> sample, std::span<const double> other, const NormalLaw& law) {
  ROCKING_EXPECT(sample.size() == other.size() && law.sigma > 0.0);
  return mean_product(sample.size(), [&](std::size_t k) { return law.score(sample[k]) * law.score(other[k]); });
}

}  // namespace rocking::stats
