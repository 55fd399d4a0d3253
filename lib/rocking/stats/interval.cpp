#include "rocking/stats/interval.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/beta.hpp>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

/// The interval moved, by no more than its rounding, to lie in [0, 1] and contain the estimate.
Interval around_estimate(const Interval& interval, double successes, double trials) {
  const double estimate = successes / trials;
  return {std::clamp(interval.low, 0.0, estimate), std::clamp(interval.high, estimate, 1.0)};
}

/// The smaller root p of (n + z^2) p^2 - (2k + z^2) p + k^2/n = 0, from the larger one and the product of both, so that
/// it is 0 for k = 0 and loses no digits for small k.
double lower_score_bound(double k, double n, double z) {
  const double larger = (k + 0.5 * z * z + z * std::sqrt(k * (1.0 - k / n) + 0.25 * z * z)) / (n + z * z);
  return k * k / (n * (n + z * z) * larger);
}

Interval exact_interval(const Proportion& proportion, double tail) {
  if (proportion.trials == 0) return {0.0, 1.0};
  const auto k = static_cast<double>(proportion.successes);
  const auto n = static_cast<double>(proportion.trials);
  const double low = k > 0.0 ? boost::math::ibeta_inv(k, n - k + 1.0, tail) : 0.0;
  const double high = k < n ? boost::math::ibetac_inv(k + 1.0, n - k, tail) : 1.0;
  return around_estimate({low, high}, k, n);
}

}  // namespace

Interval wilson(const Proportion& proportion, double confidence) {
  ROCKING_EXPECT(proportion.successes <= proportion.trials);
  ROCKING_EXPECT(0.0 < confidence && confidence < 1.0);
  if (proportion.trials == 0) return {0.0, 1.0};
  const boost::math::normal_distribution<double> normal;
  const double z = quantile(complement(normal, 0.5 * (1.0 - confidence)));
  const auto k = static_cast<double>(proportion.successes);
  const auto n = static_cast<double>(proportion.trials);
  return around_estimate({lower_score_bound(k, n, z), 1.0 - lower_score_bound(n - k, n, z)}, k, n);
}

Interval clopper_pearson(const Proportion& proportion, double confidence) {
  return bonferroni_clopper_pearson(proportion, confidence, 1);
}

Interval bonferroni_clopper_pearson(const Proportion& proportion, double confidence, std::size_t categories) {
  ROCKING_EXPECT(proportion.successes <= proportion.trials);
  ROCKING_EXPECT(0.0 < confidence && confidence < 1.0);
  ROCKING_EXPECT(categories >= 1);
  return exact_interval(proportion, 0.5 * (1.0 - confidence) / static_cast<double>(categories));
}

}  // namespace rocking::stats
