#include "rocking/stats/record_shares.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "rocking/base/error.hpp"

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

RecordShares::RecordShares(const SuiteLevels& suite, Unresolved unresolved) {
  ROCKING_EXPECT(!suite.empty());
  for (const RecordLevel& level : suite.front()) intensities_.push_back(level.intensity);
  for (const auto& record : suite) {
    ROCKING_EXPECT(record.size() == intensities_.size());
    std::vector<double>& shares = shares_.emplace_back();
    for (std::size_t k = 0; k < record.size(); ++k) {
      ROCKING_EXPECT(record[k].intensity == intensities_[k]);
      const std::uint64_t more = unresolved == Unresolved::as_happened ? record[k].unresolved : 0;
      shares.push_back(static_cast<double>(record[k].happened.successes + more) /
                       static_cast<double>(record[k].happened.trials));
    }
  }
}

std::vector<double> RecordShares::mean(const std::vector<double>& weights) const {
  ROCKING_EXPECT(weights.size() == records());
  std::vector<double> means(intensities_.size(), 0.0);
  double sum = 0.0;
  for (std::size_t r = 0; r < records(); ++r) {
    sum += weights[r];
    for (std::size_t k = 0; k < means.size(); ++k) means[k] += weights[r] * shares_[r][k];
  }
  for (double& mean : means) mean /= sum;
  return means;
}

std::vector<double> RecordShares::isotonic(const std::vector<double>& weights) const {
  return isotonic_regression(mean(weights), std::vector<double>(intensities_.size(), 1.0));
}

}  // namespace rocking::stats
