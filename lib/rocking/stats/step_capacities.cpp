#include "rocking/stats/mixed_probit.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

/// Phi(high) - Phi(low) for low < high, without cancellation on either side.
double probability_between(double low, double high) {
  if (low > 0.0) return normal_cdf(-low) - normal_cdf(-high);
  return normal_cdf(high) - normal_cdf(low);
}

}  // namespace

std::optional<std::vector<CapacityRange>> capacity_ranges(const std::vector<RecordCounts>& records) {
  std::vector<CapacityRange> ranges;
  for (const RecordCounts& record : records) {
    if (record.weight == 0.0) continue;
    CapacityRange range;
    range.weight = record.weight;
    for (const ProbitCounts& level : record.counts) {
      if (level.happened > 0.0) range.high = std::min(range.high, level.u);
      if (level.did_not > 0.0) range.low = std::max(range.low, level.u);
    }
    if (!(range.low < range.high)) return std::nullopt;
    ranges.push_back(range);
  }
  return ranges;
}

bool have_a_common_capacity(const std::vector<CapacityRange>& ranges) {
  CapacityRange common;
  for (const CapacityRange& range : ranges) {
    common.low = std::max(common.low, range.low);
    common.high = std::min(common.high, range.high);
  }
  return common.low <= common.high;
}

LocalShape capacity_log_likelihood(const std::vector<CapacityRange>& ranges, const Eigen::Vector2d& line) {
  LocalShape sum{.value = 0.0, .gradient = Eigen::Vector2d::Zero(), .hessian = Eigen::Matrix2d::Zero()};
  if (!(line[1] > 0.0))
    return {.value = -std::numeric_limits<double>::infinity(), .gradient = sum.gradient, .hessian = sum.hessian};
  for (const CapacityRange& range : ranges) {
    const double low = line[0] + line[1] * range.low;
    const double high = line[0] + line[1] * range.high;
    const double probability = probability_between(low, high);
    sum.value += range.weight * std::log(probability);
    Eigen::Vector2d score = Eigen::Vector2d::Zero();
    Eigen::Matrix2d bend = Eigen::Matrix2d::Zero();
    for (const auto& [eta, u, sign] : {std::tuple(high, range.high, 1.0), std::tuple(low, range.low, -1.0)}) {
      if (std::isinf(u)) continue;
      const Eigen::Vector2d along(1.0, u);
      const double density = sign * normal_density(eta) / probability;
      score += density * along;
      bend -= density * eta * along * along.transpose();
    }
    sum.gradient += range.weight * score;
    bend -= score * score.transpose();
    sum.hessian += range.weight * bend;
  }
  return sum;
}

}  // namespace rocking::stats
