#include "rocking/stats/mean_share.hpp"

#include <algorithm>
#include <limits>

#include <boost/math/special_functions/beta.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

/// n*, at least the number of clusters.
double effective_trials(const ClusteredProportion& proportion, double p, double confidence) {
  const auto n = static_cast<double>(proportion.clusters);
  const auto each = static_cast<double>(proportion.trials_each);
  if (proportion.clusters < 2) return n;
  const double of_one = (proportion.squares / (each * each) - n * p * p) / (n - 1.0);
  const double variance = std::max(0.0, of_one) / n;
  if (variance <= 1e-14 * p * (1.0 - p)) return n;  // nothing but rounding
  const double z = two_sided_t_quantile(confidence, std::numeric_limits<double>::infinity());
  const double t = two_sided_t_quantile(confidence, n - 1.0);
  return std::clamp(p * (1.0 - p) / variance * (z / t) * (z / t), n, n * each);
}

}  // namespace

double ClusteredProportion::share() const {
  if (clusters == 0) return 0.0;
  return successes / (static_cast<double>(clusters) * static_cast<double>(trials_each));
}

Interval korn_graubard(const ClusteredProportion& proportion, double confidence) {
  ROCKING_EXPECT(0.0 < confidence && confidence < 1.0);
  ROCKING_EXPECT(proportion.trials_each >= 1);
  if (proportion.clusters == 0) return {0.0, 1.0};
  const double p = proportion.share();
  ROCKING_EXPECT(0.0 <= p && p <= 1.0);
  const double n = effective_trials(proportion, p, confidence);
  const double k = p * n;
  const double tail = 0.5 * (1.0 - confidence);
  const double low = p > 0.0 ? boost::math::ibeta_inv(k, n - k + 1.0, tail) : 0.0;
  const double high = p < 1.0 ? boost::math::ibetac_inv(k + 1.0, n - k, tail) : 1.0;
  return {std::clamp(low, 0.0, p), std::clamp(high, p, 1.0)};
}

Interval interval_of_equal_shares(double share, std::uint64_t clusters, double confidence) {
  const double sum = share * static_cast<double>(clusters);
  return korn_graubard({.clusters = clusters, .trials_each = 1, .successes = sum, .squares = sum * share}, confidence);
}

}  // namespace rocking::stats
