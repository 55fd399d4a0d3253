#include "rocking/stats/paired.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/normal.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/outer_end.hpp"

namespace rocking::stats {
namespace {

/// Tango's statistic. q, the maximum-likelihood probability of the event under the second setting only, is the larger
/// root of 2n q^2 + 2h q - c d (1 - d) = 0 with 2h = (2n - b + c) d - b - c, computed without cancellation.
double score(const PairedCounts& counts, double d) {
  const auto b = static_cast<double>(counts.first_only);
  const auto c = static_cast<double>(counts.second_only);
  const auto n = static_cast<double>(counts.trials());
  const double twice_h = (2.0 * n - b + c) * d - b - c;
  const double product = 8.0 * n * c * d * (1.0 - d);
  const double root = std::sqrt(std::max(0.0, twice_h * twice_h + product));
  const double q = twice_h > 0.0 ? product / (4.0 * n * (root + twice_h)) : (root - twice_h) / (4.0 * n);
  const double variance = n * (2.0 * q + d * (1.0 - d));
  const double distance = b - c - n * d;
  return distance / std::sqrt(std::max(variance, 1e-300));
}

/// Smallest or largest product of a number and a probability in `factor`.
double least_product(const Interval& factor, double number) {
  return number * (number < 0.0 ? factor.high : factor.low);
}
double largest_product(const Interval& factor, double number) { return -least_product(factor, -number); }

}  // namespace

McNemar mcnemar(const PairedCounts& counts) {
  const std::uint64_t discordant = counts.discordant();
  if (discordant == 0) return {};
  const boost::math::binomial_distribution<double> law(static_cast<double>(discordant), 0.5);
  const auto fewer = static_cast<double>(std::min(counts.first_only, counts.second_only));
  const double both_tails = 2.0 * cdf(law, fewer);
  return {.p_value = std::min(1.0, both_tails), .mid_p = std::min(1.0, both_tails - pdf(law, fewer))};
}

double paired_difference(const PairedCounts& counts) {
  ROCKING_EXPECT(counts.trials() > 0);
  return (static_cast<double>(counts.first_only) - static_cast<double>(counts.second_only)) /
         static_cast<double>(counts.trials());
}

Interval paired_difference_score(const PairedCounts& counts, double confidence) {
  ROCKING_EXPECT(0.0 < confidence && confidence < 1.0);
  if (counts.trials() == 0) return {-1.0, 1.0};
  const boost::math::normal_distribution<double> normal;
  const double z = quantile(complement(normal, 0.5 * (1.0 - confidence)));
  // On the scale (1 + d)/2, from 0 to 1.
  const auto contains = [&](double place) { return std::abs(score(counts, 2.0 * place - 1.0)) <= z; };
  const double estimate = 0.5 + 0.5 * paired_difference(counts);
  const double low = estimate > 0.0 ? outer_end(estimate, 0.0, contains) : 0.0;
  const double high = estimate < 1.0 ? outer_end(estimate, 1.0, contains) : 1.0;
  return {2.0 * low - 1.0, 2.0 * high - 1.0};
}

Interval paired_difference_exact(const PairedCounts& counts, double confidence) {
  ROCKING_EXPECT(0.0 < confidence && confidence < 1.0);
  const double significance = 1.0 - confidence;
  const Proportion discordant{.successes = counts.discordant(), .trials = counts.trials()};
  const Proportion first{.successes = counts.first_only, .trials = counts.discordant()};
  const Interval r = exact_interval(discordant, {.fixed = 0.1 * significance, .proportional = 0.0});
  const Interval q = exact_interval(first, {.fixed = 0.9 * significance, .proportional = 0.0});
  return {least_product(r, 2.0 * q.low - 1.0), largest_product(r, 2.0 * q.high - 1.0)};
}

VarianceReduction variance_reduction(const PairedCounts& counts) {
  ROCKING_EXPECT(counts.trials() > 0);
  const auto n = static_cast<double>(counts.trials());
  const double first = static_cast<double>(counts.both + counts.first_only) / n;
  const double second = static_cast<double>(counts.both + counts.second_only) / n;
  const double difference = paired_difference(counts);
  VarianceReduction found;
  found.paired = static_cast<double>(counts.discordant()) / n - difference * difference;
  found.independent = first * (1.0 - first) + second * (1.0 - second);
  const bool all_alike =
      counts.discordant() == 0 || counts.first_only == counts.trials() || counts.second_only == counts.trials();
  if (!all_alike) found.factor = found.independent / found.paired;
  return found;
}

}  // namespace rocking::stats
