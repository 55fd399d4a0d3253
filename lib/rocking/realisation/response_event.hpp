#pragma once

#include <cmath>
#include <cstdint>

#include "rocking/realisation/measures.hpp"

namespace rocking {

/// What of a realisation must exceed a threshold.
enum class EventName : std::uint8_t {
  overturning,   ///< no threshold
  tilt,          ///< largest abs(Theta) [-]
  slip,          ///< largest abs(X) [m]
  displacement,  ///< abs(X) at the end [m]
};

/// What a probability is about. An overturned block has every event: it is lost, and no slip of it is known after its fall.
struct ResponseEvent {
  EventName name = EventName::overturning;
  double threshold = 0.0;  ///< >= 0; not used by overturning

  friend bool operator==(const ResponseEvent&, const ResponseEvent&) = default;

  [[nodiscard]] bool is_overturning() const { return name == EventName::overturning; }
  /// Whether it is about sliding, which needs friction.
  [[nodiscard]] bool is_of_slip() const { return name == EventName::slip || name == EventName::displacement; }
  /// What the threshold is compared with; of an overturning the largest tilt.
  [[nodiscard]] double measured(const PeakValues& peaks) const {
    if (name == EventName::slip) return peaks.slip_m;
    return name == EventName::displacement ? std::abs(peaks.final_slip_m) : peaks.tilt;
  }
  /// Whether a realisation that has not overturned has it.
  [[nodiscard]] bool is_exceeded(const PeakValues& peaks) const {
    return !is_overturning() && measured(peaks) > threshold;
  }
};

}  // namespace rocking
