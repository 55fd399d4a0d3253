#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rocking/api/experiment.hpp"
#include "rocking/scene/excitation.hpp"

/// Ground motions and their intensity measures.
namespace rocking {

/// Largest response of a linear oscillator on a base that moves horizontally.
struct SpectralPoint {
  double period_s = 0.0;       ///< undamped
  double sa_g = 0.0;           ///< omega^2 sd, over gravity: the pseudo-acceleration
  double sa_absolute_g = 0.0;  ///< largest absolute acceleration, abs(u'' + a), over gravity
  double sv_m_s = 0.0;         ///< largest abs(u'), velocity relative to the base
  double sd_m = 0.0;           ///< largest abs(u), displacement relative to the base
  double psv_m_s = 0.0;        ///< omega sd
};

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

/// A ground motion and its intensity measures.
struct MeasuredMotion {
  std::shared_ptr<const GroundMotion> motion;
  std::string sha256;  ///< of its file
  IntensityMeasures measures;
  std::vector<SpectralPoint> spectrum;                ///< one for each period
  std::optional<double> uplift_scale = std::nullopt;  ///< absent: no block, or no scale uplifts it
  std::optional<double> floor_peak_g = std::nullopt;  ///< of the ground: that of the floor, which is the next motion
};

/// Files with recorded accelerations, how to read them, and what is measured.
struct MotionQuestion {
  std::vector<std::string> files;
  std::optional<std::string> component = {};           ///< of files that hold several; absent: the only one
  std::optional<std::string> vertical = std::nullopt;  ///< file with the vertical component of a single file
  std::string format = "auto";                         ///< `auto`, `columns`, `peer_at2`, `esm_asc`, `knet`, `smc`
  std::optional<std::string> units = std::nullopt;     ///< as `excitation.units`; absent: that of the file, or m/s^2
  std::optional<double> time_step = std::nullopt;      ///< of columns without times [s], positive
  std::vector<std::string> columns = {};               ///< as `excitation.columns`; empty: not given
  bool series = true;     ///< the JSON text also has the motions sample by sample, which draw() needs
  double gravity = 9.81;  ///< [m/s^2]: 1 g
  double damping = 0.05;  ///< of the response spectrum, in [0, 1)
  std::vector<double> periods = {0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 5.0};  ///< of the response spectrum [s]
  /// Width and height [m] of a block whose least scale of uplift is wanted.
  std::optional<std::vector<double>> block = {};
  /// Frequency [Hz] and damping ratio of a uniform shear building, and height of a floor over that of the building: its
  /// motion is wanted, too.
  std::optional<std::vector<double>> building = {};
};

/// The ground motions with their intensity measures, in the order of the files, each with that of the floor behind it where a
/// building is given. Throws base::InputError with the file,
/// line and value of each fault, also for an unknown format or unit, and std::system_error where a file cannot be read.
[[nodiscard]] ROCKING_API std::vector<MeasuredMotion> motion(const MotionQuestion& question);

}  // namespace rocking
