#include "rocking/section/noisy_response.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/base/elementary.hpp"
#include "rocking/base/error.hpp"
#include "rocking/section/clouds.hpp"
#include "rocking/section/line_bounds.hpp"
#include "rocking/section/recurrence.hpp"

namespace rocking::section {
namespace {

struct Phases {
  int n = 1;
  AllChanceBounds bounds;              ///< of the chances of the lines that were not accepted
  std::vector<PlanePoint> centres;     ///< of the n classes
  std::vector<PlanePoint> deviations;  ///< from these

  void find_classes(std::span<const PlanePoint> points) {
    const Classes classes = classes_by_phase(points.size(), static_cast<std::size_t>(n));
    centres = centres_of(points, classes);
    deviations = deviations_of(points, classes, centres);
  }
};

std::vector<PlanePoint> deviations_from_mean(std::span<const PlanePoint> points) {
  PlanePoint sum;
  for (const PlanePoint& p : points) sum = {sum.x + p.x, sum.y + p.y};
  const PlanePoint mean = sum.scaled(1.0 / static_cast<double>(points.size()));
  std::vector<PlanePoint> deviations;
  deviations.reserve(points.size());
  for (const PlanePoint& p : points) deviations.push_back(p - mean);
  return deviations;
}

/// Least common period of all lines, found one by one. Each line is removed with the class means before the next is
/// sought, so that a strong line does not hide a weak one.
std::optional<Phases> find_phases(std::span<const PlanePoint> points, double resolution, double line_chance) {
  Phases phases;
  const std::vector<PlanePoint> about_mean = deviations_from_mean(points);
  LineSearch search(about_mean, 1, resolution);
  while (true) {
    phases.bounds = search.bounds();
    std::optional<LineFrequency> accepted = certain_line(phases.bounds, phases.n, line_chance);
    if (!accepted) {
      if (phases.n == 1) phases.find_classes(points);
      if (least_chance(phases.bounds, phases.n) >= line_chance) return phases;
      const auto line = strongest_line(phases.deviations, phases.n, resolution, phases.bounds);
      if (!line || line->chance >= line_chance) return phases;
      accepted = line->frequency;
    }
    phases.n = std::lcm(phases.n, accepted->denominator);
    if (phases.n > longest_period) return std::nullopt;
    phases.find_classes(points);
    search.remove_classes(phases.deviations, phases.n);
  }
}

/// The smallest of the separations that distinguish n from its divisors; infinite for n = 1.
double least_distance(std::span<const Separation> apart) {
  double least = std::numeric_limits<double>::infinity();
  for (const Separation& s : apart) least = std::min(least, s.distance);
  return least;
}

/// Whether dividing the window into parts explains more of the scatter than chance does.
bool moves_with_time(std::span<const PlanePoint> points, const Clouds& clouds, double resolution,
                     double chance_per_cut) {
  const std::size_t n = clouds.centres.size();
  const std::size_t cycles = points.size() / n;
  const std::size_t parts = cycles >= 16 ? 4 : 2;
  const Clouds cut = gather(points, classes_by_phase_and_time(points.size(), n, parts), resolution);
  const double ratio = std::sqrt(clouds.scatter.determinant() / cut.scatter.determinant());
  return ratio > 1.0 + chance_per_cut * static_cast<double>(parts - 1) / static_cast<double>(cycles);
}

/// Factor by which the separation of the clouds exceeds the required one; the smallest over the largest proper divisors
/// d of n, of which the window holds N/d cycles. If there are few cycles, noise with memory from cycle to cycle can
/// look like separate clouds.
/// `memory_of(divisor)`: correlation of deviations from cycle to cycle.
template <class Memory>
double separation_margin(std::span<const Separation> apart, std::size_t periods, const Thresholds& thresholds,
                         Memory memory_of) {
  double margin = largest_margin;
  for (const Separation& s : apart) {
    const double cycles = static_cast<double>(periods) / static_cast<double>(s.divisor);
    const double independence = (1.0 - memory_of(s.divisor)) / (1.0 - thresholds.usual_memory);
    const double grown =
        base::natural_logarithm(std::max(0.5 * s.distance, 1.0)) * cycles * independence / thresholds.separation_growth;
    margin = std::min({margin, s.distance / thresholds.least_separation, grown});
  }
  return margin;
}

bool are_tiny(const Clouds& clouds, std::span<const Separation> apart, double resolution, double tiny_share) {
  const double deviation = largest_deviation(clouds.scatter);
  const double extent = extent_of(clouds);
  const bool at_resolution = deviation <= 10.0 * resolution;
  return (at_resolution || deviation <= tiny_share * extent) && least_distance(apart) >= 1.0 / tiny_share;
}

struct Strays {
  double share = 0.0;
  bool at_the_end = false;  ///< most of the last two cycles: the response has changed
};

Strays find_strays(std::span<const PlanePoint> points, const Clouds& clouds, const Thresholds& thresholds) {
  const std::vector<bool> stray =
      strays(points, clouds, thresholds.stray_distance, thresholds.tiny_share * extent_of(clouds));
  const auto count = static_cast<double>(std::ranges::count(stray, true));
  const auto last = static_cast<std::ptrdiff_t>(std::max<std::size_t>(2 * clouds.centres.size(), 4));
  const auto at_end = std::count(stray.end() - last, stray.end(), true);
  return {count / static_cast<double>(points.size()), 2 * at_end > last};
}

}  // namespace

std::vector<PlanePoint> plane_points(std::span<const Period> periods) {
  const bool rocks = std::ranges::any_of(
      periods, [](const Period& p) { return p.impacts != 0 || p.point.tilt != 0.0 || p.point.tilt_rate != 0.0; });
  std::vector<PlanePoint> points;
  points.reserve(periods.size());
  for (const Period& p : periods) {
    points.push_back(rocks ? PlanePoint{p.point.tilt, p.point.tilt_rate} : PlanePoint{p.point.slip_rate, 0.0});
  }
  return points;
}

bool are_apart(const Finding& finding, std::size_t periods, double decay, const Thresholds& thresholds) {
  const auto memory = [decay](std::size_t divisor) {
    return base::exponential(std::max(-decay * static_cast<double>(divisor), -700.0));
  };
  return separation_margin(finding.apart, periods, thresholds, memory) >= 1.0;
}

bool are_out_of_order(std::span<const PlanePoint> points, const Clouds& clouds, const Thresholds& thresholds) {
  const Strays astray = find_strays(points, clouds, thresholds);
  return astray.at_the_end || astray.share > thresholds.largest_stray_share;
}

Finding find_clouds(std::span<const Period> periods, double resolution, const Thresholds& thresholds) {
  ROCKING_EXPECT(periods.size() >= 4 * static_cast<std::size_t>(longest_period));
  const std::vector<PlanePoint> points = plane_points(periods);
  const double line_chance = thresholds.line_chance / line_count;
  std::optional<Phases> phases = find_phases(points, resolution, line_chance);
  if (!phases) return {unresolved(Reason::period_too_long), ExponentNeed::to_find_chaos};

  const Clouds clouds = clouds_about(std::move(phases->centres), std::move(phases->deviations), resolution);
  Finding found{.classification = {}, .periods = phases->n, .apart = separations(clouds)};
  const auto without = [&found](Reason reason, ExponentNeed need, bool in_transient = false) {
    found.classification = unresolved(reason, in_transient);
    found.need = need;
    return found;
  };
  const double apart =
      separation_margin(found.apart, points.size(), thresholds, [&](std::size_t) { return thresholds.usual_memory; });
  const bool moving = moves_with_time(points, clouds, resolution, thresholds.chance_per_cut);
  const bool tiny = are_tiny(clouds, found.apart, resolution, thresholds.tiny_share);
  if (apart < 1.0) return without(Reason::clouds_overlap, ExponentNeed::to_find_chaos, moving);
  const Strays astray = find_strays(points, clouds, thresholds);
  if (astray.at_the_end) return without(Reason::not_stationary, ExponentNeed::none, true);
  if (astray.share > thresholds.largest_stray_share) {
    return without(Reason::out_of_order, ExponentNeed::to_find_chaos, moving);
  }
  if (moving && !tiny) return without(Reason::not_stationary, ExponentNeed::to_find_orbit, true);
  if (!tiny && has_longer_memory(clouds, resolution, thresholds.longest_memory)) {
    return without(Reason::slow_memory, ExponentNeed::to_find_chaos, true);
  }

  const Rocks rocks = count_rocks(periods, phases->n);
  if (rocks.regular_share < thresholds.least_regular_share) {
    return without(Reason::impacts_irregular, tiny ? ExponentNeed::none : ExponentNeed::to_find_chaos);
  }
  double margin = apart;
  // The chance of the strongest line that was not accepted is computed only if it may decide.
  if (least_chance(phases->bounds, phases->n) / line_chance < apart) {
    const auto line = strongest_line(clouds.deviations, phases->n, resolution, phases->bounds);
    margin = std::min(margin, (line ? line->chance : 1.0) / line_chance);
  }
  margin = std::clamp(margin, 1.0, largest_margin);
  const Reason reason = tiny ? Reason::tight_clouds : Reason::contracting_clouds;
  found.classification = {periodic(rocks.rocks, phases->n), reason, moving, margin};
  found.need = tiny ? ExponentNeed::none : ExponentNeed::to_confirm;
  return found;
}

}  // namespace rocking::section
