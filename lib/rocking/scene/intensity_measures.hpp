#pragma once

#include <cstdint>
#include <vector>

#include "rocking/dynamics/excitation/shape.hpp"

namespace rocking {

/// Largest horizontal acceleration of a ground motion in absolute value, over g.
[[nodiscard]] double peak_acceleration(const std::vector<dynamics::GroundMotionSample>& samples);

/// Largest horizontal velocity of a ground motion in absolute value [m/s], from rest at its first sample to its last.
///
/// The acceleration is linear between samples, so that the velocity is quadratic; its extremes lie at samples and where
/// the acceleration passes 0, and all of them count. `gravity` [m/s^2]: that over which the accelerations are given.
[[nodiscard]] double peak_velocity(const std::vector<dynamics::GroundMotionSample>& samples, double gravity);

/// Horizontal velocity at the last sample [m/s], likewise.
[[nodiscard]] double final_velocity(const std::vector<dynamics::GroundMotionSample>& samples, double gravity);

/// Largest absolute values of a linear oscillator on a moving base, over g where they have the unit of an acceleration.
struct OscillatorPeaks {
  double displacement = 0.0;  ///< relative to the base, over g [s^2]
  double velocity = 0.0;      ///< relative to the base, over g [s]
  double acceleration = 0.0;  ///< absolute, over g [-]
};

/// The peaks of u'' + 2 damping omega u' + omega^2 u = -a(t), u = u' = 0 at the first sample, for a base acceleration a
/// that is linear between samples: by the exact solution of each linear piece (Nigam & Jennings 1969, BSSA 59(2)
/// 909-922). Unlike there the largest values count wherever they are reached: also between samples, and within one period
/// after the last sample. `damping`: ratio in [0, 1). The bits are the same on every machine.
[[nodiscard]] OscillatorPeaks oscillator_peaks(const std::vector<dynamics::GroundMotionSample>& samples,
                                               double period_s, double damping);

/// Which acceleration of an oscillator: `pseudo`, omega^2 times its largest displacement relative to the base, as hazard
/// and ground-motion models have it; or `absolute`, the largest of its mass. They are equal without damping.
enum class OscillatorAcceleration : std::uint8_t { pseudo, absolute };

/// Spectral acceleration over g with 5 % damping.
[[nodiscard]] double spectral_acceleration(const std::vector<dynamics::GroundMotionSample>& samples, double period_s,
                                           OscillatorAcceleration which);

/// Geometric mean of the pseudo-accelerations at ten periods with equal ratios from `first_s` to `last_s`.
[[nodiscard]] double average_spectral_acceleration(const std::vector<dynamics::GroundMotionSample>& samples,
                                                   double first_s, double last_s);

}  // namespace rocking
