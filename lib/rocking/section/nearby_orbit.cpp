#include "rocking/section/nearby_orbit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "rocking/base/natural_logarithm.hpp"
#include "rocking/section/clouds.hpp"
#include "rocking/section/noisy_response.hpp"
#include "rocking/section/order_statistics.hpp"
#include "rocking/section/recurrence.hpp"

namespace rocking::section {
namespace {

/// Points of an orbit by the number of a period, one of which passes its first point.
class Passage {
 public:
  Passage(const NearbyOrbit& orbit, std::size_t at_first) : orbit_(&orbit), at_first_(at_first) {}

  [[nodiscard]] const StrobePoint& operator[](std::size_t period) const {
    const std::size_t n = orbit_->points.size();
    return orbit_->points[(period + n - at_first_ % n) % n];
  }

 private:
  const NearbyOrbit* orbit_;
  std::size_t at_first_;
};

using Deviation = std::array<double, 3>;

Deviation difference(const StrobePoint& a, const StrobePoint& b) {
  return {a.tilt - b.tilt, a.tilt_rate - b.tilt_rate, a.slip_rate - b.slip_rate};
}

double square_of(const Deviation& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; }

/// Deviations of the last point and of those whole cycles before it from that of the orbit, in their order.
std::vector<Deviation> deviations_from(const NearbyOrbit& orbit, std::span<const Period> periods) {
  std::vector<Deviation> deviations;
  const std::size_t n = orbit.points.size();
  for (std::size_t k = (periods.size() - 1) % n; k < periods.size(); k += n) {
    deviations.push_back(difference(periods[k].point, orbit.points.front()));
  }
  return deviations;
}

/// Whether deviations go from cycle to cycle as the derivative takes them, to a share of how far they go.
bool follow(std::span<const Deviation> deviations, const NearbyOrbit& orbit, double largest_share) {
  double missed = 0.0;
  double gone = 0.0;
  for (std::size_t k = 0; k + 1 < deviations.size(); ++k) {
    Deviation miss = deviations[k + 1];
    Deviation step = deviations[k + 1];
    for (std::size_t row = 0; row < 3; ++row) {
      step[row] -= deviations[k][row];
      for (std::size_t column = 0; column < 3; ++column)
        miss[row] -= orbit.derivative[row][column] * deviations[k][column];
    }
    missed += square_of(miss);
    gone += square_of(step);
  }
  return missed <= largest_share * largest_share * gone;
}

/// Mean square of the deviations. (The largest one of a spiral that is an ellipse depends on where the points lie on it.)
double mean_square(std::span<const Deviation> deviations) {
  double sum = 0.0;
  for (const Deviation& deviation : deviations) sum += square_of(deviation);
  return sum / static_cast<double>(deviations.size());
}

/// Whether mean squares shrink as the slowest multiplier says, within a factor in the logarithm. An orbit of three times the
/// period about a slow focus, say, goes from cycle to cycle nearly as motions about the focus do, but does not shrink.
bool shrink(double before, double after, double decay, double least_share) {
  return after > 0.0 && after < before && 0.5 * base::natural_logarithm(before / after) >= least_share * decay;
}

/// Medians of the points of a phase.
StrobePoint middle_of_phase(std::span<const Period> periods, std::size_t first, std::size_t n) {
  std::vector<double> values;
  std::vector<double> scratch(periods.size());
  const auto median = [&](double StrobePoint::*coordinate) {
    values.clear();
    for (std::size_t k = first; k < periods.size(); k += n) values.push_back(periods[k].point.*coordinate);
    return median_of(values, scratch);
  };
  return {.tilt = median(&StrobePoint::tilt),
          .tilt_rate = median(&StrobePoint::tilt_rate),
          .slip_rate = median(&StrobePoint::slip_rate)};
}

std::optional<NearbyOrbit> stable_orbit(const OrbitSource& find_orbit, const StrobePoint& near, int n,
                                        const Thresholds& thresholds) {
  if (!find_orbit) return std::nullopt;
  auto orbit = find_orbit(near, n);
  const bool attracts = orbit && orbit->moved && orbit->decay > thresholds.least_decay;
  return attracts ? orbit : std::nullopt;
}

/// Largest distance of a point of the orbit from the centre of its cloud, in scatters or, where clouds are tiny, in units of
/// the size below which they are.
double distance_from_centres(const Clouds& clouds, const std::vector<PlanePoint>& orbit, double tiny_share) {
  const double tiny = tiny_share * extent_of(clouds);
  double largest = 0.0;
  for (std::size_t k = 0; k < orbit.size(); ++k) {
    const PlanePoint d = orbit[k] - clouds.centres[k];
    const double in_scatters = std::sqrt(squared_distance(d, clouds.scatter));
    largest = std::max(largest, std::min(in_scatters, std::sqrt(d.x * d.x + d.y * d.y) / tiny));
  }
  return largest;
}

/// The points of the orbit in the plane of those of the window, by their phase.
std::vector<PlanePoint> in_plane(const NearbyOrbit& orbit, std::size_t at_first, std::span<const Period> periods) {
  const Passage passage(orbit, at_first);
  std::vector<Period> phases;
  for (std::size_t k = 0; k < orbit.points.size(); ++k) {
    phases.push_back({.point = passage[k], .impacts = periods[k].impacts, .moved = true});
  }
  return plane_points(phases);
}

}  // namespace

bool may_approach_orbit(std::span<const Period> periods, int n, double resolution, const Thresholds& thresholds) {
  const auto cycle = static_cast<std::size_t>(n);
  const std::size_t all = (periods.size() - 1) / cycle + 1;
  const std::size_t last_half = all - all / 2;
  const std::size_t last_quarter = last_half - last_half / 2;
  const auto point_from_end = [periods](std::size_t k) { return periods[periods.size() - 1 - k].point; };
  double sum = 0.0;
  for (std::size_t k = cycle; k < last_quarter * cycle; k += cycle) {
    sum += square_of(difference(point_from_end(k - cycle), point_from_end(k)));
  }
  const double arrived = thresholds.coincidence * resolution;
  const double farthest = last_half >= thresholds.fewest_cycles ? std::max(thresholds.reach, arrived) : arrived;
  return sum <= 4.0 * farthest * farthest * static_cast<double>(last_quarter);
}

bool may_approach_orbit_of_divisor(std::span<const Period> periods, int n, double resolution,
                                   const Thresholds& thresholds) {
  for (int divisor = 1; divisor < n; ++divisor) {
    if (n % divisor == 0 && may_approach_orbit(periods, divisor, resolution, thresholds)) return true;
  }
  return false;
}

std::optional<Classification> approached_orbit(std::span<const Period> periods, int n, const OrbitSource& find_orbit,
                                               double resolution, const Thresholds& thresholds) {
  const auto orbit = stable_orbit(find_orbit, periods.back().point, n, thresholds);
  if (!orbit) return std::nullopt;
  const std::vector<Deviation> all = deviations_from(*orbit, periods);
  const auto last_half = std::span(all).last(all.size() - all.size() / 2);
  const auto first_quarter = last_half.first(last_half.size() / 2);
  const auto last_quarter = last_half.last(last_half.size() - first_quarter.size());
  const double last = std::sqrt(mean_square(last_quarter));
  const bool has_arrived = last <= thresholds.coincidence * resolution;
  const double decay =
      orbit->decay * 0.25 * static_cast<double>(periods.size());  // from quarter to quarter of the window
  const bool approaches = last <= thresholds.reach && last_half.size() >= thresholds.fewest_cycles &&
                          shrink(mean_square(first_quarter), last * last, decay, thresholds.least_decay_share) &&
                          follow(last_half, *orbit, thresholds.largest_miss);
  if (!has_arrived && !approaches) return std::nullopt;
  const double margin = last > 0.0 ? std::clamp(thresholds.reach / last, 1.0, largest_margin) : largest_margin;
  return Classification{periodic((orbit->impacts + 1) / 2, orbit->period()), Reason::stable_orbit, !has_arrived,
                        margin};
}

std::optional<Classification> clouds_about_orbit(std::span<const Period> periods, int n, const OrbitSource& find_orbit,
                                                 double resolution, const Thresholds& thresholds) {
  const auto cycle = static_cast<std::size_t>(n);
  const std::size_t at_first = (periods.size() - 1) % cycle;
  const auto orbit = stable_orbit(find_orbit, middle_of_phase(periods, at_first, cycle), n, thresholds);
  if (!orbit) return std::nullopt;
  const std::vector<PlanePoint> points = plane_points(periods);
  const Clouds clouds = gather(points, classes_by_phase(points.size(), orbit->points.size()), resolution);
  const double away = distance_from_centres(clouds, in_plane(*orbit, at_first, periods), thresholds.tiny_share);
  if (away > thresholds.orbit_distance || are_out_of_order(points, clouds, thresholds)) return std::nullopt;
  const Rocks rocks = count_rocks(periods, orbit->period());
  if (rocks.regular_share < thresholds.least_regular_share) return std::nullopt;
  const double margin = std::clamp(thresholds.orbit_distance / away, 1.0, largest_margin);
  return Classification{periodic(rocks.rocks, orbit->period()), Reason::clouds_about_orbit, false, margin};
}

bool is_near_longer_orbit(const StrobePoint& point, const OrbitSource& find_orbit, const Thresholds& thresholds) {
  for (int n = longest_period + 1; n <= 2 * longest_period; ++n) {
    const auto orbit = stable_orbit(find_orbit, point, n, thresholds);
    if (orbit && orbit->period() > longest_period && distance(orbit->points.front(), point) <= thresholds.reach) {
      return true;
    }
  }
  return false;
}

}  // namespace rocking::section
