#pragma once

#include <cstdint>

namespace rocking::section {

/// State at a strobe instant, after the events of that instant: a Poincare point and the slip rate beside it.
struct StrobePoint {
  double tilt = 0.0;       ///< Theta [-]
  double tilt_rate = 0.0;  ///< Theta' [-]
  double slip_rate = 0.0;  ///< V [-]
};

/// One excitation period, the one that ends at its strobe point.
struct Period {
  StrobePoint point;
  std::uint16_t impacts = 0;  ///< those that changed the edge; a chatter counts once
  bool moved = false;         ///< false: in full contact without sliding all through
};

/// The largest n of a periodic response (m, n). Beyond it a response is not called periodic.
inline constexpr int longest_period = 12;

}  // namespace rocking::section
