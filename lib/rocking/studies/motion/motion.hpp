#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rocking/dynamics/excitation/shape.hpp"
#include "rocking/studies/motion/question.hpp"

namespace rocking {

/// The response spectrum of a ground motion whose acceleration is linear between samples:
///
///     u'' + 2 damping omega u' + omega^2 u = -a(t),  u = u' = 0 at the first sample
///
/// The largest values count wherever they are reached: also between samples, and within one period after the last sample.
/// Source: Nigam & Jennings (1969), BSSA 59(2) 909-922, as scene/intensity_measures.hpp tells. `gravity` [m/s^2]: that over
/// which the accelerations are given. `damping`: ratio in [0, 1).
[[nodiscard]] SpectralPoint spectral_point(const std::vector<dynamics::GroundMotionSample>& samples, double gravity,
                                           double period_s, double damping);

/// `count` periods from `first` to `last` with equal ratios.
[[nodiscard]] std::vector<double> spaced_periods(double first, double last, int count);

/// The base at an instant, from rest at the first sample.
struct BasePoint {
  double time;          ///< [s]
  double acceleration;  ///< [m/s^2]
  double velocity;      ///< [m/s]
  double displacement;  ///< [m]
};

/// The horizontal motion of the base at the samples. `gravity` [m/s^2]: that over which the accelerations are given.
[[nodiscard]] std::vector<BasePoint> base_motion_of(const std::vector<dynamics::GroundMotionSample>& samples,
                                                    double gravity);

/// `gravity` [m/s^2]: that over which the accelerations are given. For at least one sample.
[[nodiscard]] IntensityMeasures intensity_measures(const std::vector<dynamics::GroundMotionSample>& samples,
                                                   double gravity);

[[nodiscard]] MeasuredMotion measured(std::shared_ptr<const GroundMotion> motion, std::string sha256,
                                      const MotionQuestion& question);

}  // namespace rocking
