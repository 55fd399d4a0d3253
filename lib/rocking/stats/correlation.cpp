#include "rocking/stats/correlation.hpp"

#include <cmath>

#include "rocking/base/error.hpp"
#include "rocking/stats/compensated_sum.hpp"

namespace rocking::stats {
namespace {

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
