#include "rocking/stats/isotonic.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace rocking::stats {
namespace {

/// Successive levels with one mean.
struct Pool {
  double sum = 0.0;  ///< of weight times value
  double weight = 0.0;
  std::size_t levels = 1;
};

/// Whether the mean of `a` is at least that of `b`, without a division.
bool is_at_least(const Pool& a, const Pool& b) { return a.sum * b.weight >= b.sum * a.weight; }

std::vector<double> pooled(std::vector<Pool> levels) {
  std::vector<Pool> pools;
  for (const Pool& level : levels) {
    pools.push_back(level);
    while (pools.size() > 1 && is_at_least(pools[pools.size() - 2], pools.back())) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().sum += last.sum;
      pools.back().weight += last.weight;
      pools.back().levels += last.levels;
    }
  }
  std::vector<double> means;
  for (const Pool& pool : pools) means.insert(means.end(), pool.levels, pool.sum / pool.weight);
  return means;
}

}  // namespace

std::vector<double> isotonic_regression(std::span<const Proportion> levels) {
  std::vector<Pool> pools;
  for (const Proportion& level : levels) {
    pools.push_back({.sum = static_cast<double>(level.successes), .weight = static_cast<double>(level.trials)});
  }
  return pooled(std::move(pools));
}

std::vector<double> isotonic_regression(std::span<const double> values, std::span<const double> weights) {
  std::vector<Pool> pools;
  for (std::size_t i = 0; i < values.size(); ++i) {
    pools.push_back({.sum = weights[i] * values[i], .weight = weights[i]});
  }
  return pooled(std::move(pools));
}

std::optional<std::vector<Interval>> isotonic_band(std::span<const Proportion> levels, double confidence) {
  std::vector<Interval> band;
  for (const Proportion& level : levels) {
    band.push_back(bonferroni_clopper_pearson(level, confidence, levels.size()));
  }
  for (std::size_t i = 1; i < band.size(); ++i) band[i].low = std::max(band[i].low, band[i - 1].low);
  for (std::size_t i = band.size() - 1; i-- > 0;) band[i].high = std::min(band[i].high, band[i + 1].high);
  const bool is_contradicted =
      std::any_of(band.begin(), band.end(), [](const Interval& interval) { return interval.low > interval.high; });
  if (is_contradicted) return std::nullopt;
  return band;
}

}  // namespace rocking::stats
