#include "rocking/stats/isotonic.hpp"

#include <algorithm>
#include <cstddef>

namespace rocking::stats {
namespace {

/// Successive levels with one probability.
struct Pool {
  Proportion counts;
  std::size_t levels = 1;
};

/// Whether the share of `a` is at least that of `b`, without a division.
bool is_at_least(const Proportion& a, const Proportion& b) {
  return static_cast<double>(a.successes) * static_cast<double>(b.trials) >=
         static_cast<double>(b.successes) * static_cast<double>(a.trials);
}

}  // namespace

std::vector<double> isotonic_regression(std::span<const Proportion> levels) {
  std::vector<Pool> pools;
  for (const Proportion& level : levels) {
    pools.push_back({.counts = level});
    while (pools.size() > 1 && is_at_least(pools[pools.size() - 2].counts, pools.back().counts)) {
      const Pool last = pools.back();
      pools.pop_back();
      pools.back().counts.successes += last.counts.successes;
      pools.back().counts.trials += last.counts.trials;
      pools.back().levels += last.levels;
    }
  }
  std::vector<double> probabilities;
  for (const Pool& pool : pools) {
    const double share = static_cast<double>(pool.counts.successes) / static_cast<double>(pool.counts.trials);
    probabilities.insert(probabilities.end(), pool.levels, share);
  }
  return probabilities;
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
