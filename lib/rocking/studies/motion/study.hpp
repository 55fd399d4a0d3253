#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/dynamics/excitation/shape.hpp"
#include "rocking/fields/document.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/ground_motion_facts.hpp"
#include "rocking/studies/motion/question.hpp"
#include "rocking/study/study.hpp"

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

/// A motion of the base at its samples, and its response spectrum at many periods.
struct MotionSeries {
  std::vector<double> time_s, acceleration_g, velocity_m_s, displacement_m;
  std::optional<std::vector<double>> vertical_g = std::nullopt;  ///< absent: no vertical component
  std::vector<SpectralPoint> spectrum;
};

/// A ground motion as `rocking motion` reports it.
struct ReportedMotion {
  GroundMotionFacts facts;
  std::string sha256;
  IntensityMeasures measures;
  std::optional<double> vertical_pga_g;
  std::optional<std::optional<double>> uplift_scale;  ///< absent: no block; null: no scale
  std::optional<double> floor_peak_g;                 ///< of the ground below a floor
  std::vector<SpectralPoint> spectrum;
  std::optional<MotionSeries> series;
};

struct BlockSize {
  double width_m = 0.0;
  double height_m = 0.0;
};

struct MotionReport {
  double gravity_m_s2 = 0.0;
  double damping = 0.0;
  std::optional<BlockSize> block;
  std::vector<ReportedMotion> motions;
};

[[nodiscard]] const StructType& fields_of(const MotionReport*);

/// The output of `rocking motion --json`.
[[nodiscard]] const DocumentOf<MotionReport>& motion_document();

/// Whether the report contains what a figure needs: the motions sample by sample, and a fine response spectrum.
enum class MotionDetail : std::uint8_t { measures, series };

[[nodiscard]] MotionReport motion_report(const std::vector<MeasuredMotion>& motions, const MotionQuestion& question,
                                         MotionDetail detail);

/// The report for a terminal: measures, what was read, response spectra; on one screen of many motions their first measures
/// and the range of their spectra.
[[nodiscard]] std::string motion_table(const MotionReport& report, Extent extent = Extent::all);

[[nodiscard]] const StructType& fields_of(const MotionQuestion*);

[[nodiscard]] const Study& motion_study();

}  // namespace rocking

namespace rocking::analysis {

/// Figures of ground motions: for each motion with a series its acceleration, velocity and displacement
/// (`ground_motion`), and the response spectra of all of them (`response_spectra`). None without series.
[[nodiscard]] std::vector<Figure> motion_figures(const MotionReport& report);

}  // namespace rocking::analysis
