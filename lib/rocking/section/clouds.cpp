#include "rocking/section/clouds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rocking/base/error.hpp"
#include "rocking/section/period.hpp"

namespace rocking::section {
namespace {

// Allows for strays: up to a tenth of the points are excluded from the scatter.
constexpr double kept_share = 0.9;

// For a normal law in the plane the squared distance is exponential with mean 2. The mean below its 90 % point, 2 ln
// 10, is 2 (1 - 0.1 (1 + ln 10))/0.9 = 2 x 0.744157...; this factor corrects the trimming.
constexpr double trimming_correction = 1.0 / 0.74415721411178;

// Median of the squared distance from the centre, in units of the scatter, for a normal law in the plane: 2 ln 2.
constexpr double median_of_squares = 2.0 * std::numbers::ln2;

double median(std::vector<double>& values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

/// Squares of the median absolute deviations of the coordinates, at least `floor`: the initial value of the scatter.
Covariance typical_size(std::span<const PlanePoint> deviations, double floor) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const PlanePoint& d : deviations) {
    xs.push_back(std::abs(d.x));
    ys.push_back(std::abs(d.y));
  }
  const double x = median(xs);
  const double y = median(ys);
  return {x * x + floor, 0.0, y * y + floor};
}

/// Covariance about 0 of the deviations without the ones that are largest in the given metric.
Covariance trimmed_covariance(std::span<const PlanePoint> deviations, const Covariance& metric) {
  std::vector<double> distances;
  distances.reserve(deviations.size());
  for (const PlanePoint& d : deviations) distances.push_back(squared_distance(d, metric));
  std::vector<double> ordered = distances;
  const auto last = static_cast<std::ptrdiff_t>(kept_share * static_cast<double>(ordered.size() - 1));
  std::nth_element(ordered.begin(), ordered.begin() + last, ordered.end());
  const double limit = ordered[static_cast<std::size_t>(last)];
  Covariance sum;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    if (distances[k] > limit) continue;
    sum.add(deviations[k]);
    ++kept;
  }
  return sum.scaled(trimming_correction / static_cast<double>(kept));
}

/// The scatter that is its own metric for trimming, iterated from the sizes along the axes. An iteration leaves less
/// than half of the error in the direction, so that four leave less than a twentieth. This is far below the sampling
/// error of 600 points.
Covariance robust_scatter(std::span<const PlanePoint> deviations, double floor) {
  Covariance scatter = typical_size(deviations, floor);
  for (int round = 0; round < 4; ++round) {
    scatter = trimmed_covariance(deviations, scatter);
    scatter.xx += floor;
    scatter.yy += floor;
  }
  return scatter;
}

/// Smallest variance of `a` in units of that of `b` over all directions: the smaller root of det(A - z B) = 0.
double least_ratio(const Covariance& a, const Covariance& b) {
  const double half_trace = 0.5 * (a.xx * b.yy - 2.0 * a.xy * b.xy + a.yy * b.xx) / b.determinant();
  const double product = a.determinant() / b.determinant();
  return half_trace - std::sqrt(std::max(half_trace * half_trace - product, 0.0));
}

double farthest_turn(const Clouds& clouds, std::size_t divisor) {
  double farthest = 0.0;
  const std::size_t n = clouds.centres.size();
  for (std::size_t k = 0; k < n; ++k) {
    const PlanePoint step = clouds.centres[k] - clouds.centres[(k + divisor) % n];
    farthest = std::max(farthest, squared_distance(step, clouds.scatter));
  }
  return std::sqrt(farthest);
}

}  // namespace

Classes classes_by_phase(std::size_t points, std::size_t n) { return classes_by_phase_and_time(points, n, 1); }

Classes classes_by_phase_and_time(std::size_t points, std::size_t n, std::size_t parts) {
  Classes classes{std::vector<std::uint32_t>(points), n * parts};
  for (std::size_t k = 0; k < points; ++k) {
    classes.of[k] = static_cast<std::uint32_t>(k % n + n * (parts * k / points));
  }
  return classes;
}

std::vector<PlanePoint> centres_of(std::span<const PlanePoint> points, const Classes& classes) {
  std::vector<std::vector<double>> xs(classes.count);
  std::vector<std::vector<double>> ys(classes.count);
  for (std::size_t k = 0; k < points.size(); ++k) {
    xs[classes.of[k]].push_back(points[k].x);
    ys[classes.of[k]].push_back(points[k].y);
  }
  std::vector<PlanePoint> centres(classes.count);
  for (std::size_t c = 0; c < classes.count; ++c) centres[c] = {median(xs[c]), median(ys[c])};
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
  Clouds clouds;
  clouds.centres = centres_of(points, classes);
  clouds.deviations = deviations_of(points, classes, clouds.centres);
  const auto all = static_cast<double>(points.size());
  const double correction = all / (all - static_cast<double>(classes.count));
  clouds.scatter = robust_scatter(clouds.deviations, resolution * resolution).scaled(correction);
  return clouds;
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

double longest_memory(const Clouds& clouds, double resolution) {
  const double unknown = 2.0 * resolution * resolution;  // resolution of the difference of two points
  double longest = 0.0;
  for (std::size_t lag = 1; lag <= static_cast<std::size_t>(longest_period); ++lag) {
    std::vector<PlanePoint> steps;
    std::vector<double> squares;
    for (std::size_t k = lag; k < clouds.deviations.size(); ++k) {
      steps.push_back(clouds.deviations[k] - clouds.deviations[k - lag]);
      squares.push_back(squared_distance(steps.back(), clouds.scatter));
    }
    Covariance step = trimmed_covariance(steps, clouds.scatter);
    step.xx += unknown;
    step.yy += unknown;
    const double least = least_ratio(step, clouds.scatter);
    longest = std::max({longest, 1.0 - 0.5 * least, 1.0 - 0.5 * median(squares) / median_of_squares});
  }
  return longest;
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

}  // namespace rocking::section
