#include "rocking/stats/diversity.hpp"

#include <numeric>

#include "rocking/base/elementary.hpp"
#include "rocking/base/error.hpp"

namespace rocking::stats {

double probability_of_difference(std::span<const std::uint64_t> counts) {
  const std::uint64_t n = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  ROCKING_EXPECT(n >= 2 && n >> 32U == 0);  // the product of two counts must fit into 64 bits
  std::uint64_t unlike = n * (n - 1);       // ordered pairs
  const auto all = static_cast<double>(unlike);
  for (const std::uint64_t k : counts) {
    if (k > 0) unlike -= k * (k - 1);
  }
  return static_cast<double>(unlike) / all;
}

double entropy(std::span<const std::uint64_t> counts) {
  const std::uint64_t n = std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  ROCKING_EXPECT(n >= 1);
  const auto all = static_cast<double>(n);
  double sum = 0.0;
  for (const std::uint64_t k : counts) {
    const auto part = static_cast<double>(k);
    if (k > 0) sum += part / all * base::natural_logarithm(all / part);
  }
  return sum;
}

}  // namespace rocking::stats
