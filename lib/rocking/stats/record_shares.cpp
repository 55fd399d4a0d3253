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
  for (const auto& record : suite) {
    for (const RecordLevel& level : record) intensities_.push_back(level.intensity);
  }
  std::ranges::sort(intensities_);
  intensities_.erase(std::unique(intensities_.begin(), intensities_.end()), intensities_.end());
  for (const auto& record : suite) {
    std::vector<double>& shares = shares_.emplace_back(intensities_.size(), 0.0);
    std::vector<bool>& is_absent = is_absent_.emplace_back(intensities_.size(), true);
    for (const RecordLevel& level : record) {
      const auto found = std::ranges::lower_bound(intensities_, level.intensity);
      const auto place = static_cast<std::size_t>(found - intensities_.begin());
      const std::uint64_t more = unresolved == Unresolved::as_happened ? level.unresolved : 0;
      is_absent[place] = false;
      shares[place] = static_cast<double>(level.happened.successes + more) / static_cast<double>(level.happened.trials);
    }
  }
  const std::vector<double> means = mean(std::vector<double>(records(), 1.0));
  for (std::size_t r = 0; r < records(); ++r) {
    for (std::size_t k = 0; k < means.size(); ++k) {
      if (!has(r, k)) shares_[r][k] = means[k];
    }
  }
}

std::vector<double> RecordShares::mean(const std::vector<double>& weights) const {
  ROCKING_EXPECT(weights.size() == records());
  std::vector<double> means(intensities_.size(), 0.0);
  std::vector<double> sums(intensities_.size(), 0.0);
  for (std::size_t r = 0; r < records(); ++r) {
    for (std::size_t k = 0; k < means.size(); ++k) {
      if (!has(r, k)) continue;
      sums[k] += weights[r];
      means[k] += weights[r] * shares_[r][k];
    }
  }
  for (std::size_t k = 0; k < means.size(); ++k) means[k] /= sums[k];
  return means;
}

std::vector<double> RecordShares::shares_of_another(const std::vector<double>& weights, double weight) const {
  double all = 0.0;
  for (const double each : weights) all += each;
  std::vector<double> shares(intensities_.size(), weight);
  for (std::size_t k = 0; k < shares.size(); ++k) {
    double sum = 0.0;
    for (std::size_t r = 0; r < records(); ++r) sum += has(r, k) ? weights[r] : 0.0;
    if (sum != all) shares[k] = weight / (weight + sum);
  }
  return shares;
}

std::vector<double> RecordShares::isotonic(const std::vector<double>& weights) const {
  return isotonic_regression(mean(weights), std::vector<double>(intensities_.size(), 1.0));
}

}  // namespace rocking::stats
