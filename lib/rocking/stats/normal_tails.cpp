#include "rocking/stats/normal_check.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/base/error.hpp"
#include "rocking/stats/binomial_test.hpp"

namespace rocking::stats {
namespace {

TailCount tail_beyond(double sigmas, std::span<const double> sample, const NormalLaw& law) {
  const auto outside = [&](double x) { return std::abs(law.score(x)) > sigmas; };
  const auto count = std::count_if(sample.begin(), sample.end(), outside);
  const Proportion beyond{static_cast<std::uint64_t>(count), sample.size()};
  const double probability = 2.0 * normal_cdf(-sigmas);
  return {sigmas, beyond, static_cast<double>(sample.size()) * probability,
          two_sided_binomial_p_value(beyond, probability)};
}

}  // namespace

std::array<TailCount, 3> normal_tails(std::span<const double> sample, const NormalLaw& law) {
  ROCKING_EXPECT(law.sigma > 0.0);
  return {tail_beyond(3.0, sample, law), tail_beyond(4.0, sample, law), tail_beyond(5.0, sample, law)};
}

}  // namespace rocking::stats
