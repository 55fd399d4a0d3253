#pragma once

#include <cstdint>

namespace rocking::section {

/// State at a strobe instant, after the events of that instant: a Poincare point and the slip rate.
struct StrobePoint {
  double tilt = 0.0;       ///< Theta [-]
  double tilt_rate = 0.0;  ///< Theta' [-]
  double slip_rate = 0.0;  ///< V [-]
};

/// One excitation period and the strobe point at its end.
struct Period {
  StrobePoint point;
  std::uint16_t impacts = 0;  ///< impacts that changed the edge; a chatter counts once
  bool moved = false;         ///< false: in full contact without sliding throughout the period
};

/// The largest n of a periodic response (m, n). Longer periods are not tested.
inline constexpr int longest_period = 12;

}  // namespace rocking::section
