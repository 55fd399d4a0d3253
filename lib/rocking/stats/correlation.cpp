#include "rocking/stats/correlation.hpp"

#include <cmath>

#include "rocking/base/error.hpp"
#include "rocking/stats/compensated_sum.hpp"

namespace rocking::stats {
namespace {

/// Mean product of the scores `lag` apart, the first of them at 0, stride, 2 stride, ...
Moment mean_product(std::span<const double> sample, const NormalLaw& law, std::size_t lag, std::size_t stride) {
  ROCKING_EXPECT(lag >= 1 && sample.size() > lag && law.sigma > 0.0);
  CompensatedSum sum;
  std::size_t products = 0;
  for (std::size_t i = 0; i + lag < sample.size(); i += stride) {
    sum.add(law.score(sample[i]) * law.score(sample[i + lag]));
    ++products;
  }
  const auto m = static_cast<double>(products);
  const double standard_error = 1.0 / std::sqrt(m);
  const double value = sum.value() / m;
  return {value, standard_error, value / standard_error};
}

}  // namespace

Moment lag_correlation(std::span<const double> sample, const NormalLaw& law, std::size_t lag) {
  return mean_product(sample, law, lag, 1);
}

Moment pair_correlation(std::span<const double> sample, const NormalLaw& law) {
  return mean_product(sample, law, 1, 2);
}

}  // namespace rocking::stats
