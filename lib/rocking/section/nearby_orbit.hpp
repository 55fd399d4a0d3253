#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rocking/section/classification.hpp"
#include "rocking/section/thresholds.hpp"

namespace rocking::section {

/// A periodic orbit of the motion without what is random along the way.
struct NearbyOrbit {
  /// One each period; their number is the smallest period. The first, which lies next to the start of the search, is closer
  /// to the orbit than the others.
  std::vector<StrobePoint> points;
  int impacts = 0;     ///< in this period, that changed the edge; a chatter counts once
  bool moved = false;  ///< false: the block rests
  double decay = 0.0;  ///< -ln abs(largest multiplier) per period; > 0 if the orbit attracts
  /// Of the map over the period at the first point: derivative of Theta, Theta', V (rows) with respect to them (columns).
  std::array<std::array<double, 3>, 3> derivative{};

  [[nodiscard]] int period() const { return static_cast<int>(points.size()); }
};

/// Newton's method from a point for a fixed point of the Poincare map over so many periods, to a twentieth of the distance
/// from the start. Absent if it does not converge, or if the map has no derivative there.
using OrbitSource = std::function<std::optional<NearbyOrbit>(const StrobePoint& near, int periods)>;

/// False if no orbit of period n can be so near the points that `approached_orbit` takes it, which is seen without a search:
/// points that are within a distance of it in the mean square move by at most twice that from cycle to cycle.
[[nodiscard]] bool may_approach_orbit(std::span<const Period> periods, int n, double resolution,
                                      const Thresholds& thresholds);

/// The same of an orbit whose period is a proper divisor of n.
[[nodiscard]] bool may_approach_orbit_of_divisor(std::span<const Period> periods, int n, double resolution,
                                                 const Thresholds& thresholds);

/// The periodic response whose stable orbit noise-free points tend to. It is sought from a point that the motion passes at
/// the end of the window, over `n` periods: the orbit may have a period that divides n. Absent if none is found, or if
/// the points of the last half do not go from cycle to cycle as the map's derivative at the orbit says, or do not shrink.
[[nodiscard]] std::optional<Classification> approached_orbit(std::span<const Period> periods, int n,
                                                             const OrbitSource& find_orbit, double resolution,
                                                             const Thresholds& thresholds);

/// The periodic response of noisy points about a stable orbit of the motion without noise, sought over `n` periods from the
/// middle of a cloud. Absent if none passes within the clouds of its period, or if too many points or impacts are out of
/// their order. It holds if the exponent is negative.
[[nodiscard]] std::optional<Classification> clouds_about_orbit(std::span<const Period> periods, int n,
                                                               const OrbitSource& find_orbit, double resolution,
                                                               const Thresholds& thresholds);

/// Whether a point is near a stable orbit whose period is longer than any that a label names, up to twice that: its points
/// look like closed curves while the motion tends to it slowly.
[[nodiscard]] bool is_near_longer_orbit(const StrobePoint& point, const OrbitSource& find_orbit,
                                        const Thresholds& thresholds);

}  // namespace rocking::section
