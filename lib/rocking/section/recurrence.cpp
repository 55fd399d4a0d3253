#include "rocking/section/recurrence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "rocking/base/error.hpp"

namespace rocking::section {
namespace {

double distance(const StrobePoint& a, const StrobePoint& b) {
  return std::max(
      {std::abs(a.tilt - b.tilt), std::abs(a.tilt_rate - b.tilt_rate), std::abs(a.slip_rate - b.slip_rate)});
}

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

/// Remaining drift if the distances continue to shrink at the same ratio r; nothing if they do not shrink. A third has
/// N/(3n) returns. In the j-th third to come each is at most D3 r^j. The sum is (N/3n) D3 (r + r^2 + ...).
std::optional<double> remaining_drift(const Returns& returns, double returns_per_third, double slowest_ratio) {
  const auto& [first, middle, last] = returns.thirds;
  const double ratio = std::max(middle / first, last / middle);
  if (!(ratio < slowest_ratio)) return std::nullopt;  // also if a distance is 0
  return returns_per_third * last * ratio / (1.0 - ratio);
}

/// Margin of a coincidence: the factor by which these distances are below the threshold and those of the divisors above
/// it.
double margin_of(std::span<const Period> periods, int n, double separation, double threshold) {
  double margin = separation > 0.0 ? threshold / separation : largest_margin;
  for (int divisor = 1; divisor < n; ++divisor) {
    if (n % divisor != 0) continue;
    margin = std::min(margin, returns_after(periods, static_cast<std::size_t>(divisor)).last_half / threshold);
  }
  return std::clamp(margin, 1.0, largest_margin);
}

Classification periodic_classification(std::span<const Period> periods, int n, Reason reason, double margin) {
  // Impacts of the first half may belong to the transient; only the last half, at least one cycle, is counted.
  const std::size_t half = std::max(periods.size() / 2, static_cast<std::size_t>(n));
  const Rocks rocks = count_rocks(periods.last(half), n);
  if (rocks.regular_share < 1.0) return unresolved(Reason::impacts_irregular);
  return {periodic(rocks.rocks, n), reason, false, margin};
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

std::optional<Classification> find_recurrence(std::span<const Period> periods, double resolution,
                                              const Thresholds& thresholds) {
  ROCKING_EXPECT(periods.size() >= 2 * static_cast<std::size_t>(longest_period));
  const double threshold = thresholds.coincidence * resolution;
  bool converging = false;
  for (int n = 1; n <= longest_period; ++n) {
    const Returns returns = returns_after(periods, static_cast<std::size_t>(n));
    if (returns.last_half <= threshold) {
      const double margin = margin_of(periods, n, returns.last_half, threshold);
      return periodic_classification(periods, n, Reason::points_coincide, margin);
    }
    const double returns_per_third = static_cast<double>(periods.size()) / (3.0 * n);
    const std::optional<double> drift = remaining_drift(returns, returns_per_third, thresholds.slowest_ratio);
    if (drift && *drift <= thresholds.small_drift) {
      return periodic_classification(periods, n, Reason::points_converge,
                                     std::min(thresholds.small_drift / *drift, largest_margin));
    }
    converging = converging || drift.has_value();
  }
  if (converging) return unresolved(Reason::still_converging, true);
  return std::nullopt;
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
