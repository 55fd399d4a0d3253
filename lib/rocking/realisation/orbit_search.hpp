#pragma once

#include <optional>

#include "rocking/random/draws.hpp"
#include "rocking/realisation/poincare_map.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/nearby_orbit.hpp"

namespace rocking {

/// Finds periodic orbits of a realisation with the numbers that it drew at its start, and the means of what is random along
/// the way. Deterministic: the same bits on every machine.
class OrbitSearch {
 public:
  OrbitSearch(const Condition& condition, const random::Draws& draws);

  /// A point near a fixed point of the map, with the map over the period from the last point before it.
  struct Found {
    section::StrobePoint point;
    PoincareImage image;
  };

  /// As section::OrbitSource. Absent too where strobe points do not repeat with the base.
  [[nodiscard]] std::optional<section::NearbyOrbit> find(const section::StrobePoint& near, int periods) const;

 private:
  [[nodiscard]] std::optional<Found> newton_from(const section::StrobePoint& near, int periods) const;
  [[nodiscard]] std::optional<section::NearbyOrbit> of_smallest_period(const Found& found,
                                                                       const section::StrobePoint& near) const;

  std::optional<PoincareMap> map_;
};

}  // namespace rocking
