#pragma once

#include <optional>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/excitation/ground_motion_sample.hpp"

/// Intensity measures of a ground motion whose acceleration is linear between samples, as it is in a simulation. All
/// integrals are exact for such a motion, up to rounding; nothing is filtered and no baseline is corrected.
namespace rocking {

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

/// Of the horizontal component, from the first sample to the last.
struct IntensityMeasures {
  double pga_g = 0.0;               ///< largest abs(acceleration) over gravity
  double pga_time_s = 0.0;          ///< when it is reached first
  double pgv_m_s = 0.0;             ///< largest abs(velocity), also between samples
  double pgd_m = 0.0;               ///< largest abs(displacement), also between samples
  double arias_m_s = 0.0;           ///< pi/(2 g) times the integral of a^2 (Arias 1970)
  double cav_m_s = 0.0;             ///< integral of abs(a): cumulative absolute velocity (EPRI 1988)
  double significant_from_s = 0.0;  ///< when the integral of a^2 reaches 5 % of its final value
  double significant_to_s = 0.0;    ///< and 95 % (Trifunac & Brady 1975)
  double vertical_pga_g = 0.0;      ///< 0 without a vertical component
};

/// `gravity` [m/s^2]: that over which the accelerations are given. For at least one sample.
[[nodiscard]] IntensityMeasures intensity_measures(const std::vector<dynamics::GroundMotionSample>& samples,
                                                   double gravity);

/// The least scale of the motion at which a block leaves full contact by rocking if it cannot slide: abs(alpha) reaches
/// tan(psi) (1 + alpha_v) at some sample. Absent if no scale does.
[[nodiscard]] std::optional<double> least_uplift_scale(const std::vector<dynamics::GroundMotionSample>& samples,
                                                       const dynamics::Geometry& block);

}  // namespace rocking
