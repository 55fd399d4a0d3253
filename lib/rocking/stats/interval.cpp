#include "rocking/stats/interval.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/gamma.hpp>

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

Interval score_interval(const Proportion& proportion, double tail) {
  ROCKING_EXPECT(proportion.successes <= proportion.trials);
  ROCKING_EXPECT(0.0 < tail && tail <= 0.5);  // 0.5: a confidence that rounds to 0
  if (proportion.trials == 0) return {0.0, 1.0};
  const boost::math::normal_distribution<double> normal;
  const double z = quantile(complement(normal, tail));
  const auto k = static_cast<double>(proportion.successes);
  const auto n = static_cast<double>(proportion.trials);
  return around_estimate({lower_score_bound(k, n, z), 1.0 - lower_score_bound(n - k, n, z)}, k, n);
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

/// P(Z = k) where Z ~ Poisson(k).
double poisson_at_its_mean(double k) { return k > 0.0 ? boost::math::gamma_p_derivative(k + 1.0, k) : 1.0; }

/// A Poisson law truncated to an interval: the probability of the interval, the mean and the central moments.
struct TruncatedPoisson {
  double kept = 0.0;
  double mean = 0.0;
  double second = 0.0;
  double third = 0.0;
  double fourth = 0.0;
};

/// Poisson(k) truncated to `first` ... `last` around k, by summation. The moments are those of the distance from k,
/// which is small; the factorial moments used by the authors would suffer from cancellation.
TruncatedPoisson truncated_poisson(double k, double first, double last) {
  std::array<double, 5> sum{};
  // Returns whether the term changed a sum. Beyond the maximum of the fourth moment, all terms after an ineffective one
  // are ineffective.
  const auto add = [&](double j, double probability) {
    const std::array<double, 5> before = sum;
    for (double& moment : sum) {
      moment += probability;
      probability *= j - k;
    }
    return sum != before;
  };
  const double middle = poisson_at_its_mean(k);
  add(k, middle);
  double probability = middle;
  for (double j = k + 1.0; j <= last && add(j, probability *= k / j); j += 1.0) {
  }
  probability = middle;
  for (double j = k - 1.0; j >= first && add(j, probability *= (j + 1.0) / k); j -= 1.0) {
  }
  const double m = sum[1] / sum[0];
  const double second = sum[2] / sum[0];
  const double third = sum[3] / sum[0];
  const double fourth = sum[4] / sum[0];
  return {.kept = sum[0],
          .mean = k + m,
          .second = second - m * m,
          .third = third - 3.0 * m * second + 2.0 * m * m * m,
          .fourth = fourth - 4.0 * m * third + 6.0 * m * m * second - 3.0 * m * m * m * m};
}

/// Density at `total` of a sum of such laws, by Edgeworth's expansion to the fourth moment.
double edgeworth_density(const TruncatedPoisson& sum, double fourth_cumulant, double total) {
  const double deviation = std::sqrt(sum.second);
  const double skewness = sum.third / (sum.second * deviation);
  const double excess = fourth_cumulant / (sum.second * sum.second);
  const double x = (total - sum.mean) / deviation;
  const double y = x * x;
  const double series = 1.0 + skewness * x * (y - 3.0) / 6.0 + excess * (y * y - 6.0 * y + 3.0) / 24.0 +
                        skewness * skewness * (y * y * y - 15.0 * y * y + 45.0 * y - 15.0) / 72.0;
  return std::exp(-0.5 * y) / std::sqrt(2.0 * std::numbers::pi) * series / deviation;
}

/// nu(c) for c >= 1: a sum of independent truncated Poisson laws, conditioned on being n, has the multinomial law
/// conditioned on all counts lying within c of the observed ones.
double probability_within(std::span<const std::uint64_t> counts, double n, double c) {
  TruncatedPoisson sum{.kept = 1.0};
  double fourth_cumulant = 0.0;
  for (const std::uint64_t count : counts) {
    const auto k = static_cast<double>(count);
    const TruncatedPoisson part = truncated_poisson(k, std::max(k - c, 0.0), std::min(k + c, n));
    sum.kept *= part.kept;
    sum.mean += part.mean;
    sum.second += part.second;
    sum.third += part.third;
    fourth_cumulant += part.fourth - 3.0 * part.second * part.second;
  }
  return sum.kept * edgeworth_density(sum, fourth_cumulant, n) / poisson_at_its_mean(n);
}

/// nu(0): the multinomial probability of the observed counts.
double probability_of_the_same(std::span<const std::uint64_t> counts, double n) {
  double probability = 1.0 / poisson_at_its_mean(n);
  for (const std::uint64_t count : counts) probability *= poisson_at_its_mean(static_cast<double>(count));
  return probability;
}

}  // namespace

Interval wilson(const Proportion& proportion, double confidence) {
  return score_interval(proportion, 0.5 * (1.0 - confidence));
}

Interval goodman(const Proportion& proportion, double confidence, std::size_t categories) {
  ROCKING_EXPECT(categories >= 1);
  return score_interval(proportion, 0.5 * (1.0 - confidence) / static_cast<double>(categories));
}

Interval jeffreys(const Proportion& proportion, double confidence) {
  ROCKING_EXPECT(proportion.successes <= proportion.trials);
  ROCKING_EXPECT(0.0 < confidence && confidence < 1.0);
  if (proportion.trials == 0) return {0.0, 1.0};
  const double tail = 0.5 * (1.0 - confidence);
  const auto k = static_cast<double>(proportion.successes);
  const auto n = static_cast<double>(proportion.trials);
  const double low = k > 0.0 ? boost::math::ibeta_inv(k + 0.5, n - k + 0.5, tail) : 0.0;
  const double high = k < n ? boost::math::ibetac_inv(k + 0.5, n - k + 0.5, tail) : 1.0;
  return around_estimate({low, high}, k, n);
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

std::optional<std::vector<Interval>> sison_glaz(std::span<const std::uint64_t> counts, double confidence) {
  ROCKING_EXPECT(0.0 < confidence && confidence < 1.0);
  const auto n = static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
  if (n == 0.0) return std::vector<Interval>(counts.size(), {0.0, 1.0});
  const double far =
      2.0 * std::sqrt(n) + 50.0;  // beyond every maximum: from here on a constant probability stays constant
  double within = probability_of_the_same(counts, n);
  for (double c = 0.0; c <= n; c += 1.0) {
    const double within_next = probability_within(counts, n, c + 1.0);
    if (within <= confidence && confidence < within_next) {
      const double upper = c + 2.0 * (confidence - within) / (within_next - within);
      std::vector<Interval> intervals;
      for (const std::uint64_t count : counts) {
        const auto k = static_cast<double>(count);
        intervals.push_back({std::max(0.0, (k - c) / n), std::min(1.0, (k + upper) / n)});
      }
      return intervals;
    }
    if (within_next == within && c > far) return std::nullopt;
    within = within_next;
  }
  return std::nullopt;
}

}  // namespace rocking::stats
