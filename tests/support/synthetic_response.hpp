#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "rocking/base/elementary.hpp"
#include "rocking/section/classification.hpp"
#include "support/split_mix.hpp"

namespace rocking::support {

/// Distance below which two strobe points coincide, for tests that need no other value.
inline constexpr double point_accuracy = 1e-7;

/// Fluctuation of a synthetic response about its orbit: x' = memory R(angle) x + noise, per period, with the stationary
/// standard deviation `scatter` in Theta and `stretch` times that in Theta'.
struct Wander {
  double scatter = 0.0;
  double stretch = 2.0;
  double memory = 0.0;       ///< modulus per period
  double angle = 0.0;        ///< rotation per period [rad]
  double stray_share = 0.0;  ///< share of the points that are displaced by ten scatters
};

/// A synthetic response: its orbit, its fluctuation, and the number of impacts in each period of a cycle.
struct Synthetic {
  std::vector<section::StrobePoint> orbit;
  std::vector<std::uint16_t> impacts;
  Wander wander;

  [[nodiscard]] std::vector<section::Period> periods(std::size_t count, SplitMix& draw) const {
    std::vector<section::Period> result;
    const auto turn = base::sin_cos(wander.angle);
    const double kick = std::sqrt(1.0 - wander.memory * wander.memory);
    double x = draw.normal();
    double y = draw.normal();
    for (std::size_t k = 0; k < count; ++k) {
      const double next = wander.memory * (turn.cosine * x - turn.sine * y) + kick * draw.normal();
      y = wander.memory * (turn.sine * x + turn.cosine * y) + kick * draw.normal();
      x = next;
      const bool stray = draw.uniform() < wander.stray_share;
      const double size = wander.scatter * (stray ? 10.0 : 1.0);
      section::StrobePoint point = orbit[k % orbit.size()];
      point.tilt += size * (0.8 * x + 0.6 * y);
      point.tilt_rate += size * wander.stretch * y;
      result.push_back({point, impacts[k % impacts.size()], true});
    }
    return result;
  }
};

/// An orbit of n random points in the part of the plane where blocks rock, with mutual distances of at least `gap`
/// (Theta' has half weight); 2m impacts, distributed in turn.
inline Synthetic random_orbit(int n, int m, double gap, SplitMix& draw) {
  Synthetic made;
  while (made.orbit.size() < static_cast<std::size_t>(n)) {
    const section::StrobePoint p{draw.uniform(-0.6, 0.6), draw.uniform(-1.2, 1.2), 0.0};
    bool clear = std::hypot(p.tilt, p.tilt_rate) > 0.1;
    for (const auto& q : made.orbit)
      clear = clear && std::hypot(p.tilt - q.tilt, 0.5 * (p.tilt_rate - q.tilt_rate)) > gap;
    if (clear) made.orbit.push_back(p);
  }
  made.impacts.assign(static_cast<std::size_t>(n), 0);
  for (int i = 0; i < 2 * m; ++i) ++made.impacts[static_cast<std::size_t>(i % n)];
  return made;
}

}  // namespace rocking::support
