#pragma once

#include <cstdint>

namespace rocking::dynamics {

/// Of the base acceleration (PulseExcitation).
enum class PulseShape : std::uint8_t {
  sine,
  cosine,
  ricker,
  half_sine,
  rectangle,
  triangle,
  type_c,
  mavroeidis_papageorgiou
};

/// A pulse up to its size and its frequency.
struct PulseForm {
  PulseShape shape = PulseShape::sine;
  double phase = 0.0;   ///< of sine, cosine and mavroeidis_papageorgiou [rad]
  double cycles = 1.0;  ///< n of type_c, a whole number >= 1; gamma >= 1 of mavroeidis_papageorgiou
};

/// Half the length of a Ricker pulse in 2 pi/Omega_h: its acceleration beyond is below 1e-6 of its peak,
/// (x^2/2 - 1) exp(-x^2/4) = 1e-6 at x = 8.3263 = 2 pi 1.3252.
inline constexpr double ricker_half_length = 1.3251763074617886;

/// Length of a pulse in 2 pi/Omega_h.
[[nodiscard]] double pulse_length(const PulseForm& form);

/// A sample of a recorded base acceleration.
struct GroundMotionSample {
  double time;        ///< [s], from the start of the run; never falls, two equal times are a jump
  double horizontal;  ///< over g
  double vertical;    ///< over g
};

/// alpha_v = amplitude sin(Omega_v tau + phase), with Omega_v = (cycles/periods) Omega_h.
struct VerticalSine {
  double amplitude = 0.0;  ///< over g
  double cycles = 1.0;     ///< in `periods` periods of the horizontal motion; any number where periods = 1
  double periods = 1.0;    ///< a whole number
  double phase = 0.0;      ///< at tau = 0 [rad]
  friend bool operator==(const VerticalSine&, const VerticalSine&) = default;
};

}  // namespace rocking::dynamics
