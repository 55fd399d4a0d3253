#pragma once

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

}  // namespace rocking
