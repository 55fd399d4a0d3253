#include "rocking/section/recurrence.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "rocking/base/error.hpp"

namespace rocking::section {
namespace {

/// Largest distances between points n apart in the first, middle and last third of the window.
struct Returns {
  std::array<double, 3> thirds{};
  double last_half = 0.0;
};

Returns returns_after(std::span<const Period> periods, std::size_t n) {
  Returns returns;
  const std::size_t count = periods.size() - n;
  for (std::size_t k = 0; k < count; ++k) {
    const double d = distance(periods[k].point, periods[k + n].point);
    double& third = returns.thirds[3 * k / count];
    third = std::max(third, d);
    if (2 * k >= count) returns.last_half = std::max(returns.last_half, d);
  }
  return returns;
}

/// Whether they shrink by a factor from third to third; not if one is 0.
bool is_shrinking(const Returns& returns, double slowest_ratio) {
  const auto& [first, middle, last] = returns.thirds;
  return std::max(middle / first, last / middle) < slowest_ratio;
}

/// Smallest of the distances after a proper divisor of n periods; infinite for n = 1.
double distance_of_divisors(std::span<const Period> periods, int n) {
  double least = std::numeric_limits<double>::infinity();
  for (int divisor = 1; divisor < n; ++divisor) {
    if (n % divisor == 0) least = std::min(least, returns_after(periods, static_cast<std::size_t>(divisor)).last_half);
  }
  return least;
}

/// A motion that tends to an orbit of a divisor of n by a factor r per period comes back after n periods, too, but misses by
/// at least (1 - r^n)/2 of its distance after the divisor. Returns that are closer by `clear_divisors` exclude that down to
/// 1 - r^n = 2e-5, which is nearer to a bifurcation than the resolution of any parameter.
Classification coinciding(std::span<const Period> periods, int n, double margin, std::size_t unfinished) {
  // Impacts of the first half may belong to the transient; only the last half, at least one cycle, is counted.
  const std::size_t half = std::max(periods.size() / 2, static_cast<std::size_t>(n));
  const std::size_t finished = half - std::min(unfinished, half);
  Rocks rocks = count_rocks(periods.last(half), n);
  if (rocks.regular_share < 1.0 && finished >= static_cast<std::size_t>(n)) {
    rocks = count_rocks(periods.last(half).first(finished), n);
  }
  if (rocks.regular_share < 1.0) return unresolved(Reason::impacts_irregular);
  return {periodic(rocks.rocks, n), Reason::points_coincide, false, std::clamp(margin, 1.0, largest_margin)};
}

struct Cycle {
  int impacts = 0;
  bool moved = false;
};

std::vector<Cycle> cycles_of(std::span<const Period> periods, int length) {
  const auto step = static_cast<std::size_t>(length);
  std::vector<Cycle> cycles(periods.size() / step);
  const auto used = periods.last(cycles.size() * step);
  for (std::size_t k = 0; k < used.size(); ++k) {
    Cycle& cycle = cycles[k / step];
    cycle.impacts += used[k].impacts;
    cycle.moved = cycle.moved || used[k].moved;
  }
  return cycles;
}

int median_impacts(std::vector<Cycle> cycles) {
  const auto middle = cycles.begin() + static_cast<std::ptrdiff_t>(cycles.size() / 2);
  std::nth_element(cycles.begin(), middle, cycles.end(),
                   [](const Cycle& a, const Cycle& b) { return a.impacts < b.impacts; });
  return middle->impacts;
}

}  // namespace

Recurrence find_recurrence(std::span<const Period> periods, double resolution, const Thresholds& thresholds,
                           std::size_t unfinished) {
  ROCKING_EXPECT(periods.size() >= 2 * static_cast<std::size_t>(longest_period));
  const double threshold = thresholds.coincidence * resolution;
  Recurrence found;
  for (int n = 1; n <= longest_period; ++n) {
    const Returns returns = returns_after(periods, static_cast<std::size_t>(n));
    const bool coincide = returns.last_half <= threshold;
    const double needed = thresholds.clear_divisors * returns.last_half;
    const double margin =
        coincide ? std::min(threshold / returns.last_half, distance_of_divisors(periods, n) / needed) : 0.0;
    if (coincide && !(margin < 1.0)) {
      found.classification = coinciding(periods, n, returns.last_half > 0.0 ? margin : largest_margin, unfinished);
      return found;
    }
    const bool is_multiple = std::ranges::any_of(found.candidates, [n](int candidate) { return n % candidate == 0; });
    if (!is_multiple && (coincide || is_shrinking(returns, thresholds.slowest_ratio))) found.candidates.push_back(n);
  }
  return found;
}

bool come_closer(std::span<const StrobePoint> points) {
  constexpr double slowest = 0.95;
  std::vector<Period> periods;
  for (const StrobePoint& point : points) periods.push_back({.point = point});
  for (std::size_t n = 1; n <= static_cast<std::size_t>(longest_period) && 2 * n < periods.size(); ++n) {
    if (is_shrinking(returns_after(periods, n), slowest)) return true;
  }
  return false;
}

Rocks count_rocks(std::span<const Period> periods, int length) {
  const std::vector<Cycle> cycles = cycles_of(periods, length);
  ROCKING_EXPECT(!cycles.empty());
  const int typical = median_impacts(cycles);

  std::size_t irregular = 0;
  int ahead = 0;  // running total minus the typical number, since the last irregular cycle
  int lowest = 0;
  int highest = 0;
  for (const Cycle& cycle : cycles) {
    ahead += cycle.impacts - typical;
    lowest = std::min(lowest, ahead);
    highest = std::max(highest, ahead);
    const bool off_pace = highest - lowest > 1;
    const bool stood_still = typical == 0 && !cycle.moved;
    if (off_pace || stood_still) ++irregular;
    if (off_pace) ahead = lowest = highest = 0;
  }
  const double share = 1.0 - static_cast<double>(irregular) / static_cast<double>(cycles.size());
  return {(typical + 1) / 2, share};
}

}  // namespace rocking::section
