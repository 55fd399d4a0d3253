#pragma once

#include <vector>

#include "rocking/dynamics/excitation/ground_motion_sample.hpp"

namespace rocking {

/// Largest response of a linear oscillator on a base that moves horizontally.
struct SpectralPoint {
  double period_s = 0.0;  ///< undamped
  double sd_m = 0.0;      ///< largest abs(u), displacement relative to the base
  double sv_m_s = 0.0;    ///< largest abs(u'), velocity relative to the base
  double sa_m_s2 = 0.0;   ///< largest absolute acceleration, abs(u'' + a)
};

/// The response spectrum of a ground motion whose acceleration is linear between samples:
///
///     u'' + 2 damping omega u' + omega^2 u = -a(t),  u = u' = 0 at the first sample
///
/// by the exact solution of each linear piece (Nigam & Jennings 1969, BSSA 59(2) 909-922). Unlike there the largest
/// values count wherever they are reached: also between samples, and within one period after the last sample. `gravity`
/// [m/s^2]: that over which the accelerations are given. `damping`: ratio in [0, 1).
[[nodiscard]] SpectralPoint spectral_point(const std::vector<dynamics::GroundMotionSample>& samples, double gravity,
                                           double period_s, double damping);

/// `count` periods from `first` to `last` with equal ratios.
[[nodiscard]] std::vector<double> spaced_periods(double first, double last, int count);

}  // namespace rocking
