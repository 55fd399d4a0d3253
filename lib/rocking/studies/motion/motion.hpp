#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/excitation/shape.hpp"
#include "rocking/scene/excitation.hpp"

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

/// What is asked about ground motions.
struct MotionQuestion {
  double gravity = 9.81;                                ///< [m/s^2]: 1 g
  double damping = 0.05;                                ///< of the response spectrum, in [0, 1)
  std::vector<double> periods;                          ///< of the response spectrum [s]
  std::optional<dynamics::Block> block = std::nullopt;  ///< whose least scale of uplift is wanted
};

/// A ground motion and its intensity measures.
struct MeasuredMotion {
  std::shared_ptr<const GroundMotion> motion;
  std::string sha256;  ///< of its file
  IntensityMeasures measures;
  std::vector<SpectralPoint> spectrum;                ///< one for each period
  std::optional<double> uplift_scale = std::nullopt;  ///< absent: no block, or no scale uplifts it
};

[[nodiscard]] MeasuredMotion measured(std::shared_ptr<const GroundMotion> motion, std::string sha256,
                                      const MotionQuestion& question);

}  // namespace rocking
