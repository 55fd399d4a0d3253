#include "rocking/stats/interval.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/beta.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/outer_end.hpp"

namespace rocking::stats {
namespace {

/// The interval, changed by no more than its rounding error so that it lies in [0, 1] and contains the estimate.
Interval around_estimate(const Interval& interval, double successes, double trials) {
  const double estimate = successes / trials;
  return {std::clamp(interval.low, 0.0, estimate), std::clamp(interval.high, estimate, 1.0)};
}

/// The smaller root p of (n + z^2) p^2 - (2k + z^2) p + k^2/n = 0, computed from the larger root and the product of
/// both. It is then 0 for k = 0 and loses no digits for small k.
double lower_score_bound(double k, double n, double z) {
  if (k == 0.0) return 0.0;  // also if z is 0
  const double larger = (k + 0.5 * z * z + z * std::sqrt(k * (1.0 - k / n) + 0.25 * z * z)) / (n + z * z);
  return k * k / (n * (n + z * z) * larger);
}

/// The p for which neither tail has a probability below `tail`.
Interval equal_tailed_interval(const Proportion& proportion, double tail) {
  ROCKING_EXPECT(proportion.successes <= proportion.trials);
  ROCKING_EXPECT(0.0 < tail && tail <= 0.5);  // 0.5: a confidence that rounds to 0
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
  const double tail = 0.5 * (1.0 - confidence);
  ROCKING_EXPECT(0.0 < tail && tail <= 0.5);  // 0.5: a confidence that rounds to 0
  if (proportion.trials == 0) return {0.0, 1.0};
  const boost::math::normal_distribution<double> normal;
  const double z = quantile(complement(normal, tail));
  const auto k = static_cast<double>(proportion.successes);
  const auto n = static_cast<double>(proportion.trials);
  return around_estimate({lower_score_bound(k, n, z), 1.0 - lower_score_bound(n - k, n, z)}, k, n);
}

Interval clopper_pearson(const Proportion& proportion, double confidence) {
  return equal_tailed_interval(proportion, 0.5 * (1.0 - confidence));
}

Interval exact_interval(const Proportion& proportion, const Significance& significance) {
  ROCKING_EXPECT(proportion.successes <= proportion.trials);
  ROCKING_EXPECT(significance.fixed >= 0.0 && significance.proportional >= 0.0 && 0.0 < significance.at(1.0) &&
                 significance.at(1.0) < 1.0);
  if (significance.proportional == 0.0) return equal_tailed_interval(proportion, 0.5 * significance.fixed);
  if (proportion.trials == 0) return {0.0, 1.0};
  const auto k = static_cast<double>(proportion.successes);
  const auto n = static_cast<double>(proportion.trials);
  const auto below = [&](double p) { return boost::math::ibeta(k, n - k + 1.0, p) < 0.5 * significance.at(p); };
  const auto above = [&](double p) { return boost::math::ibetac(k + 1.0, n - k, p) < 0.5 * significance.at(p); };
  Interval interval{0.0, 1.0};
  if (k > 0.0 && below(nearly_zero)) interval.low = outer_end(k / n, nearly_zero, std::not_fn(below));
  if (k < n && above(nearly_one)) interval.high = outer_end(k / n, nearly_one, std::not_fn(above));
  return interval;
}

Interval bonferroni_clopper_pearson(const Proportion& proportion, double confidence, std::size_t categories) {
  ROCKING_EXPECT(categories >= 1);
  return equal_tailed_interval(proportion, 0.5 * (1.0 - confidence) / static_cast<double>(categories));
}

}  // namespace rocking::stats
