#include "rocking/section/clouds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/section/order_statistics.hpp"

namespace rocking::section {
namespace {

double farthest_turn(const Clouds& clouds, std::size_t divisor) {
  double farthest = 0.0;
  const std::size_t n = clouds.centres.size();
  for (std::size_t k = 0; k < n; ++k) {
    const PlanePoint step = clouds.centres[k] - clouds.centres[(k + divisor) % n];
    farthest = std::max(farthest, squared_distance(step, clouds.scatter));
  }
  return std::sqrt(farthest);
}

/// The points divided into classes, with the coordinates of each class next to each other.
class PointsByClass {
 public:
  PointsByClass(std::span<const PlanePoint> points, const Classes& classes)
      : starts_(classes.count + 1), numbers_(3 * points.size()) {
    for (const std::uint32_t c : classes.of) ++starts_[c + 1];
    for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    std::vector<std::uint32_t> ends(starts_.begin(), starts_.end() - 1);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const std::size_t place = ends[classes.of[k]]++;
      numbers_[place] = points[k].x;
      numbers_[points.size() + place] = points[k].y;
    }
  }

  [[nodiscard]] PlanePoint median(std::size_t c) {
    const std::size_t points = starts_.back();
    const std::size_t count = starts_[c + 1] - starts_[c];
    const std::span<double> all(numbers_);
    const Scratch scratch = all.last(points);
    return {median_of(all.subspan(starts_[c], count), scratch),
            median_of(all.subspan(points + starts_[c], count), scratch)};
  }

 private:
  std::vector<std::uint32_t> starts_;  ///< by class; then the number of points
  std::vector<double> numbers_;        ///< x of all, y of all, scratch
};

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

Classes classes_by_phase(std::size_t points, std::size_t n) { return classes_by_phase_and_time(points, n, 1); }

Classes classes_by_phase_and_time(std::size_t points, std::size_t n, std::size_t parts) {
  Classes classes{std::vector<std::uint32_t>(points), n * parts};
  std::size_t phase = 0;
  std::size_t part = 0;
  for (std::size_t k = 0; k < points; ++k) {
    if (parts * k >= (part + 1) * points) ++part;
    classes.of[k] = static_cast<std::uint32_t>(phase + n * part);
    phase = phase + 1 == n ? 0 : phase + 1;
  }
  return classes;
}

std::vector<PlanePoint> centres_of(std::span<const PlanePoint> points, const Classes& classes) {
  PointsByClass by_class(points, classes);
  std::vector<PlanePoint> centres(classes.count);
  for (std::size_t c = 0; c < classes.count; ++c) centres[c] = by_class.median(c);
  return centres;
}

std::vector<PlanePoint> deviations_of(std::span<const PlanePoint> points, const Classes& classes,
                                      std::span<const PlanePoint> centres) {
  std::vector<PlanePoint> deviations;
  deviations.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) deviations.push_back(points[k] - centres[classes.of[k]]);
  return deviations;
}

Clouds gather(std::span<const PlanePoint> points, const Classes& classes, double resolution) {
  ROCKING_EXPECT(points.size() > classes.count && classes.of.size() == points.size());
  std::vector<PlanePoint> centres = centres_of(points, classes);
  std::vector<PlanePoint> deviations = deviations_of(points, classes, centres);
  return clouds_about(std::move(centres), std::move(deviations), resolution);
}

Clouds clouds_about(std::vector<PlanePoint> centres, std::vector<PlanePoint> deviations, double resolution) {
  const auto all = static_cast<double>(deviations.size());
  const double correction = all / (all - static_cast<double>(centres.size()));
  const Covariance scatter = robust_scatter(deviations, resolution * resolution).scaled(correction);
  return {std::move(centres), std::move(deviations), scatter};
}

std::vector<Separation> separations(const Clouds& clouds) {
  std::vector<Separation> result;
  const std::size_t n = clouds.centres.size();
  for (const std::size_t prime : {2U, 3U, 5U, 7U, 11U}) {
    if (n % prime == 0) result.push_back({n / prime, farthest_turn(clouds, n / prime)});
  }
  return result;
}

std::vector<bool> strays(std::span<const PlanePoint> points, const Clouds& clouds, double scatters, double least) {
  const std::size_t n = clouds.centres.size();
  std::vector<bool> result(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const PlanePoint& d = clouds.deviations[k];
    const double own = squared_distance(d, clouds.scatter);
    if (own <= scatters * scatters || d.x * d.x + d.y * d.y <= least * least) continue;
    bool nearer_elsewhere = n == 1;
    for (const PlanePoint& centre : clouds.centres) {
      nearer_elsewhere = nearer_elsewhere || squared_distance(points[k] - centre, clouds.scatter) < own;
    }
    result[k] = nearer_elsewhere;
  }
  return result;
}

double extent_of(const Clouds& clouds) {
  double extent = 0.0;
  for (const PlanePoint& c : clouds.centres) extent = std::max(extent, std::sqrt(c.x * c.x + c.y * c.y));
  return extent;
}

double largest_deviation(const Covariance& scatter) {
  const double half_sum = 0.5 * (scatter.xx + scatter.yy);
  const double half_difference = 0.5 * (scatter.xx - scatter.yy);
  return std::sqrt(half_sum + std::sqrt(half_difference * half_difference + scatter.xy * scatter.xy));
}

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
