#include "rocking/section/trimmed_scatter.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "rocking/section/order_statistics.hpp"

namespace rocking::section {
namespace {

constexpr double kept_share = 0.9;

/// Squares of the median absolute deviations of the coordinates, at least `floor`: the initial value of the scatter.
Covariance typical_size(std::span<const PlanePoint> deviations, double floor, std::span<double> memory) {
  const std::span<double> sizes = memory.first(deviations.size());
  const Scratch scratch = memory.subspan(sizes.size());
  std::ranges::transform(deviations, sizes.begin(), [](const PlanePoint& d) { return std::abs(d.x); });
  const double x = median_of(sizes, scratch);
  std::ranges::transform(deviations, sizes.begin(), [](const PlanePoint& d) { return std::abs(d.y); });
  const double y = median_of(sizes, scratch);
  return {x * x + floor, 0.0, y * y + floor};
}

}  // namespace

std::size_t last_kept(std::size_t count) {
  return static_cast<std::size_t>(kept_share * static_cast<double>(count - 1));
}

Covariance trimmed_covariance(std::span<const PlanePoint> deviations, const Covariance& metric,
                              std::span<double> memory, double& limit) {
  const std::span<double> distances = memory.first(deviations.size());
  for (std::size_t k = 0; k < distances.size(); ++k) distances[k] = squared_distance(deviations[k], metric);
  limit = value_of_rank(distances, last_kept(distances.size()), memory.subspan(distances.size()), limit);
  // Adding 0 does not change a sum; which deviations are kept cannot be predicted, so that a branch takes longer.
  Covariance sum;
  double kept = 0.0;
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    const PlanePoint& d = deviations[k];
    const bool keeps = !(distances[k] > limit);
    sum.xx += keeps ? d.x * d.x : 0.0;
    sum.xy += keeps ? d.x * d.y : 0.0;
    sum.yy += keeps ? d.y * d.y : 0.0;
    kept += keeps ? 1.0 : 0.0;
  }
  return sum.scaled(trimming_correction / kept);
}

Covariance robust_scatter(std::span<const PlanePoint> deviations, double floor) {
  std::vector<double> memory(2 * deviations.size());
  Covariance scatter = typical_size(deviations, floor, memory);
  double limit = expected_limit;
  for (int round = 0; round < 4; ++round) {
    scatter = trimmed_covariance(deviations, scatter, memory, limit);
    scatter.xx += floor;
    scatter.yy += floor;
  }
  return scatter;
}

}  // namespace rocking::section
