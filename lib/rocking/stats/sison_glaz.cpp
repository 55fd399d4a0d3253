#include "rocking/stats/sison_glaz.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include <boost/math/special_functions/gamma.hpp>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

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
