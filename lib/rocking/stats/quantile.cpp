#include "rocking/stats/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <boost/math/special_functions/beta.hpp>

#include "rocking/base/error.hpp"

namespace rocking::stats {
namespace {

/// P(K >= k) for K binomial (n, p).
double at_least(std::uint64_t k, std::uint64_t n, double p) {
  if (k == 0) return 1.0;
  if (k > n) return 0.0;
  return boost::math::ibeta(static_cast<double>(k), static_cast<double>(n - k + 1), p);
}

/// P(K < k).
double below(std::uint64_t k, std::uint64_t n, double p) {
  if (k == 0) return 0.0;
  if (k > n) return 1.0;
  return boost::math::ibetac(static_cast<double>(k), static_cast<double>(n - k + 1), p);
}

/// The first rank from 1 to n for which a condition does not hold that holds for all ranks before it; n + 1 if it holds
/// for all. By bisection.
template <class Condition>
std::uint64_t first_without(std::uint64_t n, Condition holds) {
  std::uint64_t low = 1;
  std::uint64_t high = n + 1;
  while (low < high) {
    const std::uint64_t middle = low + (high - low) / 2;
    if (holds(middle)) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

/// Nearest rank (Hyndman & Fan 1996, definition 1), from 1; n >= 1.
std::uint64_t nearest_rank(std::uint64_t n, double level) {
  // 0.55 of 100 is the 55th, though 0.55 * 100.0 > 55: level and product are both rounded, with a relative error of at
  // most 2^-53.
  const double rank = std::ceil(level * static_cast<double>(n) * (1.0 - 0x1p-51));
  return std::clamp<std::uint64_t>(static_cast<std::uint64_t>(rank), 1, n);
}

}  // namespace

std::optional<double> censored_quantile(const std::map<std::int64_t, std::uint64_t>& tally, std::uint64_t later,
                                        double level) {
  ROCKING_EXPECT(0.0 < level && level <= 1.0);
  std::uint64_t all = later;
  for (const auto& [value, count] : tally) all += count;
  if (all == 0) return std::nullopt;
  const std::uint64_t rank = nearest_rank(all, level);
  std::uint64_t passed = 0;
  for (const auto& [value, count] : tally) {
    passed += count;
    if (passed >= rank) return static_cast<double>(value);
  }
  return std::nullopt;
}

std::optional<double> lower_median(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

QuantileRanks quantile_ranks(std::uint64_t n, double level, double confidence) {
  ROCKING_EXPECT(0.0 < level && level < 1.0);
  ROCKING_EXPECT(0.0 < confidence && confidence < 1.0);
  const double tail = 0.5 * (1.0 - confidence);
  const std::uint64_t after_low = first_without(n, [&](std::uint64_t rank) { return below(rank, n, level) <= tail; });
  const std::uint64_t high = first_without(n, [&](std::uint64_t rank) { return at_least(rank, n, level) > tail; });
  QuantileRanks result;
  if (after_low > 1) result.low = after_low - 1;
  if (high <= n) result.high = high;
  return result;
}

QuantileEstimate quantile_estimate(std::span<const double> ascending, std::uint64_t beyond, double level,
                                   double confidence) {
  ROCKING_EXPECT(std::ranges::is_sorted(ascending));
  const std::uint64_t n = ascending.size() + beyond;
  QuantileEstimate estimate{.level = level, .value = {}, .low = {}, .high = {}};
  if (n == 0) return estimate;
  const auto value_of = [&](const std::optional<std::uint64_t>& rank) {
    return rank && *rank <= ascending.size() ? std::optional(ascending[*rank - 1]) : std::nullopt;
  };
  const QuantileRanks ranks = quantile_ranks(n, level, confidence);
  estimate.value = value_of(nearest_rank(n, level));
  estimate.low = value_of(ranks.low);
  estimate.high = value_of(ranks.high);
  return estimate;
}

}  // namespace rocking::stats
