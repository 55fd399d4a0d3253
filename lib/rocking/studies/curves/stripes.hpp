#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/realisation/measures.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/shaking.hpp"
#include "rocking/stats/fragility.hpp"

namespace rocking {

class Store;

/// What a fragility function is about.
struct CurveSubject {
  std::string parameter;                                ///< JSON pointer to the intensity
  std::vector<Parameter> others;                        ///< the rest of the sweep, without the ground motion
  double confidence = 0.95;                             ///< that the experiment asks for
  ResponseEvent event;                                  ///< what is counted as overturned
  std::optional<double> least_uplift;                   ///< StripeGroup::least_uplift; not of the curve of one record
  std::optional<BalanceAngles> balance = std::nullopt;  ///< of an event of a tilt
};

/// Measures of the intensity of a recorded motion.
enum class IntensityMeasure : std::uint8_t {
  pga,          ///< peak ground acceleration over g [-]
  pgv,          ///< peak ground velocity [m/s]
  sa_p,         ///< pseudo-acceleration over g with 5 % damping at the period 2 pi/p of the mean block [-]
  sa,           ///< the same at the period by which the experiment gives the strength of its motions
  avgsa,        ///< geometric mean of the same over the periods by which it does, or else over 0.1 to 1 times 2 pi/p
  sa_absolute,  ///< largest absolute acceleration of the oscillator over g, where it is swept [-]
};
inline constexpr std::array all_intensity_measures{IntensityMeasure::pga,   IntensityMeasure::pgv,
                                                   IntensityMeasure::sa_p,  IntensityMeasure::sa,
                                                   IntensityMeasure::avgsa, IntensityMeasure::sa_absolute};

/// In files: `pga_g`, `pgv_m_s`, `sa_p_g`, `sa_g`, `avgsa_g`, `sa_absolute_g`.
inline constexpr std::array<std::string_view, 6> intensity_measure_names{"pga_g", "pgv_m_s", "sa_p_g",
                                                                         "sa_g",  "avgsa_g", "sa_absolute_g"};
[[nodiscard]] constexpr std::string_view to_string(IntensityMeasure measure) {
  return intensity_measure_names[static_cast<std::size_t>(measure)];
}

/// What a stripe of a multiple-stripe analysis holds: all realisations of one block under one motion at one level.
struct Stripe {
  std::string record;      ///< name of the ground motion; empty: the experiment has one only
  double intensity = 0.0;  ///< value of the swept intensity, > 0
  std::array<std::optional<double>, all_intensity_measures.size()> measures = {};  ///< by IntensityMeasure
  std::optional<double> pgv_over_pga = std::nullopt;  ///< of the motion, whatever its scale [s]
  std::vector<bool> overturned;                       ///< by number of the realisation
  std::vector<PeakValues> peaks;                      ///< likewise
  std::vector<bool> without_answer = {};              ///< likewise: Summary::has_no_answer; empty: none
  std::optional<Shaking> shaking = std::nullopt;      ///< of its scene
  std::optional<double> uplift = std::nullopt;        ///< rocking::least_uplift of its scene
  std::optional<double> sliding = std::nullopt;       ///< rocking::least_sliding of its scene

  [[nodiscard]] bool has_no_answer(std::size_t realisation) const {
    return !without_answer.empty() && without_answer[realisation];
  }
  [[nodiscard]] std::optional<double> measure(IntensityMeasure which) const {
    return measures[static_cast<std::size_t>(which)];
  }
};

/// Stripes of conditions that differ in the ground motion and the intensity alone.
struct StripeGroup {
  std::string parameter;          ///< JSON pointer to the intensity
  std::vector<Parameter> others;  ///< the rest of the sweep, without the ground motion
  double confidence = 0.95;
  std::vector<Stripe> stripes;  ///< records in the order of the sweep; of a record by growing intensity
  std::optional<BalanceAngles> balance = std::nullopt;

  [[nodiscard]] bool is_suite() const { return !stripes.empty() && !stripes.front().record.empty(); }
  /// The stripes of each ground motion, in the order of the sweep.
  [[nodiscard]] std::vector<std::span<const Stripe>> by_record() const;
  /// The least intensity at which any of the motions lifts the block, or of an event of slip lifts it or makes it slide;
  /// absent where none is known for one of them, or where no intensity does.
  [[nodiscard]] std::optional<double> least_uplift(const ResponseEvent& event) const;
};

[[nodiscard]] CurveSubject subject_of(const StripeGroup& group, const ResponseEvent& event);

/// Outcomes of a stripe. An overturned block has every event. A realisation without an answer had the event if its tilt, or
/// its slip, exceeded that of the event before it ended; else, and for a displacement at the end, its outcome is not
/// known.
[[nodiscard]] stats::IntensityLevel level_of(const Stripe& stripe, const ResponseEvent& event);

/// Groups by the grid of the other entries of the sweep. An intensity of 0 has no logarithm and is left out. Throws
/// InputError where the run is not finished.
[[nodiscard]] std::vector<StripeGroup> stripes_of(const Experiment& experiment, const Store& store,
                                                  unsigned threads = 1);

}  // namespace rocking
