#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/fields/document.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/ground_motion_facts.hpp"
#include "rocking/studies/motion/motion.hpp"

namespace rocking {

/// Largest responses of a linear oscillator on a moving base.
struct SpectrumEntry {
  double period_s = 0.0;
  double sa_g = 0.0;           ///< omega^2 sd, over gravity: the pseudo-acceleration
  double sa_absolute_g = 0.0;  ///< largest absolute acceleration
  double sv_m_s = 0.0;
  double sd_m = 0.0;
  double psv_m_s = 0.0;  ///< omega sd
};

/// A motion of the base at its samples, and its response spectrum at many periods.
struct MotionSeries {
  std::vector<double> time_s, acceleration_g, velocity_m_s, displacement_m;
  std::vector<SpectrumEntry> spectrum;
};

/// A ground motion as `rocking motion` reports it.
struct ReportedMotion {
  GroundMotionFacts facts;
  std::string sha256;
  IntensityMeasures measures;
  std::optional<double> vertical_pga_g;
  std::optional<std::optional<double>> uplift_scale;  ///< absent: no block; null: no scale
  std::vector<SpectrumEntry> spectrum;
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

}  // namespace rocking
