#include "rocking/section/noisy_response.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "rocking/section/clouds.hpp"

namespace rocking::section {
namespace {

constexpr std::size_t parts = 8;
constexpr std::size_t fewest = 4 * static_cast<std::size_t>(longest_period);  // periods, for find_clouds

// In units of the root-mean-square spread of all points. In an interrupted response most returns are within a tenth of
// the spread; the failed ones differ by more than half of it.
constexpr double near_return = 0.1;
constexpr double missed_return = 0.5;

struct Regime {
  Classification classification;
  std::size_t first = 0;  ///< its first period in the window
  std::size_t count = 0;
};

/// Number of points outside a regime that are away from the cloud that should come next, and how many of these are on
/// another cloud.
struct Outside {
  std::size_t away = 0;
  std::size_t on_another = 0;
};

Outside look_outside(std::span<const PlanePoint> points, const Regime& regime, double resolution,
                     const Thresholds& thresholds) {
  const auto n = static_cast<std::size_t>(regime.classification.mode.periods);
  const auto inside = points.subspan(regime.first, regime.count);
  const Clouds clouds = gather(inside, classes_by_phase(regime.count, n), resolution);
  const double least = thresholds.tiny_share * extent_of(clouds);
  const auto is_at = [&](const PlanePoint& point, const PlanePoint& centre) {
    const PlanePoint d = point - centre;
    return squared_distance(d, clouds.scatter) <= thresholds.stray_distance * thresholds.stray_distance ||
           d.x * d.x + d.y * d.y <= least * least;
  };
  Outside outside;
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (k == regime.first) k += regime.count;
    if (k >= points.size() || is_at(points[k], clouds.centres[(k + (n - 1) * regime.first) % n])) continue;
    ++outside.away;
    const bool on_another =
        std::ranges::any_of(clouds.centres, [&](const PlanePoint& centre) { return is_at(points[k], centre); });
    if (on_another) ++outside.on_another;
  }
  return outside;
}

enum class End : std::uint8_t { first, last };

/// The longest part at one end of the window that is one periodic response by itself; at the last end, with tight
/// clouds.
std::optional<Regime> longest_regime(std::span<const Period> periods, End end, double resolution,
                                     const Thresholds& thresholds) {
  for (std::size_t part = parts - 1; part > 0; --part) {
    const std::size_t count = periods.size() * part / parts;
    const double share = static_cast<double>(count) / static_cast<double>(periods.size());
    if (count < fewest || share < thresholds.least_held) return std::nullopt;
    const std::size_t first = end == End::first ? 0 : periods.size() - count;
    const Finding finding = find_clouds(periods.subspan(first, count), resolution, thresholds);
    Classification classification = finding.classification;
    if (classification.mode.kind != ResponseKind::periodic) continue;
    if (end == End::last && finding.need != ExponentNeed::none) continue;
    classification.held = share;
    return Regime{classification, first, count};
  }
  return std::nullopt;
}

/// Whether for some lag most points return, while in each half of the window at least one does not.
bool is_interrupted(std::span<const PlanePoint> points, double resolution) {
  Covariance all;
  for (const PlanePoint& d : gather(points, classes_by_phase(points.size(), 1), resolution).deviations) all.add(d);
  const double spread = (all.xx + all.yy) / static_cast<double>(points.size());
  for (std::size_t lag = 1; lag <= static_cast<std::size_t>(longest_period); ++lag) {
    const std::size_t returns = points.size() - lag;
    std::size_t near = 0;
    std::size_t missed_early = 0;
    std::size_t missed_late = 0;
    for (std::size_t k = 0; k < returns; ++k) {
      const PlanePoint step = points[k + lag] - points[k];
      const double square = (step.x * step.x + step.y * step.y) / spread;
      if (square <= near_return * near_return) ++near;
      if (square > missed_return * missed_return) ++(2 * k < returns ? missed_early : missed_late);
    }
    if (2 * near > returns && missed_early > 0 && missed_late > 0) return true;
  }
  return false;
}

}  // namespace

RegimeChange find_regimes(std::span<const Period> periods, double resolution, const Thresholds& thresholds) {
  const std::vector<PlanePoint> points = plane_points(periods);
  // The response has changed if more points are away from a regime than a window may have strays. Otherwise the regime
  // is part of a slower motion, or of one that the whole window shows better.
  const double enough = thresholds.largest_stray_share * static_cast<double>(points.size());
  for (const End end : {End::last, End::first}) {
    const auto regime = longest_regime(periods, end, resolution, thresholds);
    if (!regime) continue;
    const Outside outside = look_outside(points, *regime, resolution, thresholds);
    if (static_cast<double>(outside.away) <= enough) continue;
    if (end == End::last) return {regime->classification, {}};
    return {{}, 2 * outside.on_another > outside.away ? Reason::phase_jump : Reason::changed_regime};
  }
  if (is_interrupted(points, resolution)) return {{}, Reason::interrupted};
  return {};
}

}  // namespace rocking::section
