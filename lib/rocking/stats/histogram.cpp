#include "rocking/stats/normal_check.hpp"

#include <algorithm>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

/// Probability between two scores, computed in the tail where it is not a difference of numbers near 1.
double probability_between(double low, double high) {
  return low > 0.0 ? normal_cdf(-low) - normal_cdf(-high) : normal_cdf(high) - normal_cdf(low);
}

}  // namespace

Histogram normal_histogram(std::span<const double> sample, const NormalLaw& law, std::size_t bins, double reach) {
  ROCKING_EXPECT(bins >= 1 && reach > 0.0 && law.sigma > 0.0);
  const auto n = static_cast<double>(sample.size());
  // Integers first, so that edges k and bins - k have exactly opposite scores and the middle edge is the mean.
  const auto score_of_edge = [&](std::size_t k) {
    return reach * ((2.0 * static_cast<double>(k) - static_cast<double>(bins)) / static_cast<double>(bins));
  };
  Histogram histogram;
  for (std::size_t k = 0; k <= bins; ++k) histogram.edges.push_back(law.mean + law.sigma * score_of_edge(k));
  for (std::size_t k = 0; k < bins; ++k) {
    histogram.expected.push_back(n * probability_between(score_of_edge(k), score_of_edge(k + 1)));
  }
  histogram.expected_below = histogram.expected_above = n * normal_cdf(-reach);
  histogram.counts.resize(bins);
  for (const double x : sample) {
    // Compared with the edges as reported, so that a reader who counts again obtains the same counts.
    const auto upper = std::upper_bound(histogram.edges.begin(), histogram.edges.end(), x);
    if (upper == histogram.edges.begin()) {
      ++histogram.below;
    } else if (upper == histogram.edges.end()) {
      ++histogram.above;
    } else {
      ++histogram.counts[static_cast<std::size_t>(upper - histogram.edges.begin()) - 1];
    }
  }
  return histogram;
}

}  // namespace rocking::stats
