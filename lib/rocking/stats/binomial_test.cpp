#include "rocking/stats/binomial_test.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/binomial.hpp>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

/// The first count from `low` on for which `holds` is true; `high` if there is none before it. `holds` must be
/// monotone.
template <class Predicate>
std::uint64_t first_where(std::uint64_t low, std::uint64_t high, Predicate holds) {
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (holds(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

}  // namespace

double two_sided_binomial_p_value(const Proportion& observed, double probability) {
  ROCKING_EXPECT(observed.successes <= observed.trials);
  ROCKING_EXPECT(0.0 <= probability && probability <= 1.0);
  const std::uint64_t n = observed.trials;
  const std::uint64_t k = observed.successes;
  const boost::math::binomial_distribution<double> law(static_cast<double>(n), probability);
  const auto density = [&law](std::uint64_t count) { return pdf(law, static_cast<double>(count)); };
  const auto at_most = [&law](std::uint64_t count) { return cdf(law, static_cast<double>(count)); };
  const auto at_least = [&law](std::uint64_t count) {
    return count == 0 ? 1.0 : cdf(complement(law, static_cast<double>(count - 1)));
  };
  const double bound = density(k) * (1.0 + 1e-7);
  const auto mode = std::min(n, static_cast<std::uint64_t>(std::floor(static_cast<double>(n + 1) * probability)));
  // The density rises up to the mode and falls after it, so that each tail is a range of counts.
  if (density(mode) <= bound) return 1.0;
  if (k < mode) {
    const std::uint64_t upper = first_where(mode, n + 1, [&](std::uint64_t count) { return density(count) <= bound; });
    return std::min(1.0, at_most(k) + (upper <= n ? at_least(upper) : 0.0));
  }
  const std::uint64_t inside = first_where(0, mode, [&](std::uint64_t count) { return density(count) > bound; });
  return std::min(1.0, (inside > 0 ? at_most(inside - 1) : 0.0) + at_least(k));
}

}  // namespace rocking::stats
