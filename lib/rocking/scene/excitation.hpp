#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/excitation/shape.hpp"
#include "rocking/scene/building.hpp"
#include "rocking/scene/quantity.hpp"

namespace rocking::dynamics {
class Clock;
class Excitation;
}  // namespace rocking::dynamics

namespace rocking {

/// Accelerations of a recorded ground motion, as data.
struct GroundMotion {
  /// The largest acceleration that the header states.
  struct Peak {
    double m_s2 = 0.0;
    bool is_that_of_samples = true;  ///< to 1 % and the digits that are printed
  };

  std::vector<dynamics::GroundMotionSample> samples;  ///< time [s]; accelerations over g, before scaling
  bool has_vertical = false;
  std::string name = {};                               ///< of its file; empty: not from a file
  std::string format = {};                             ///< of its file: `columns`, `peer_at2`, `esm_asc`, `knet`, ...
  std::string unit = {};                               ///< of the accelerations in its file: `g`, `m/s2`, `cm/s2`, ...
  bool unit_is_assumed = false;                        ///< neither the file nor the experiment states it
  std::vector<std::string_view> columns = {};          ///< of a file of numbers: what each was taken for
  std::string component = {};                          ///< that the header names: `180`, `UP`; empty: none
  bool is_of_borehole = false;                         ///< by its header
  std::string origin = {};                             ///< earthquake and station, as the header names both; empty: not
  std::vector<std::string> components = {};            ///< among which it was chosen; empty: the file holds one
  std::optional<Peak> header_peak = std::nullopt;      ///< absent: the header states none
  std::string vertical_file = {};                      ///< from which the vertical component was read; empty: none
  std::optional<double> time_step = std::nullopt;      ///< [s]; absent: the times of the file are not evenly spaced
  std::optional<std::size_t> declared = std::nullopt;  ///< samples that the file says it has
  std::vector<std::string> warnings = {};              ///< about the file, which was read nonetheless
};

/// When a fluctuating amplitude is drawn: at each excitation period, or once in a realisation. `refused`: a fluctuation
/// of the amplitude is not allowed.
enum class AmplitudeDraws : std::uint8_t { each_period, once, refused };

/// Unit of a physical amplitude: the block's gravity g (SceneBlock::gravity), or m/s^2.
enum class AccelerationUnit : std::uint8_t { gravity, m_s2 };

/// Amplitude of the base acceleration, the same for blocks of every size; A_h follows from each block.
struct PhysicalAmplitude {
  Quantity value = 0.0;
  AccelerationUnit unit = AccelerationUnit::gravity;
  friend bool operator==(const PhysicalAmplitude&, const PhysicalAmplitude&) = default;
};

/// Whether a physical frequency is given in Hz, or by its period in s.
enum class FrequencyUnit : std::uint8_t { hertz, period_s };

/// Frequency of the base motion, the same for blocks of every size; Omega_h follows from each block.
struct PhysicalFrequency {
  Quantity value = 1.0;
  FrequencyUnit unit = FrequencyUnit::hertz;
  friend bool operator==(const PhysicalFrequency&, const PhysicalFrequency&) = default;
};

/// psi g of a block in the unit of the amplitude: the amplitude over it is A_h. 1 where A_h itself is given.
[[nodiscard]] inline double amplitude_unit(const std::optional<PhysicalAmplitude>& physical,
                                           const dynamics::Geometry& block, double gravity) {
  if (!physical) return 1.0;
  return physical->unit == AccelerationUnit::gravity ? block.shape_angle : block.shape_angle * gravity;
}

/// Omega_h of a block under a physical frequency, or under its mean.
[[nodiscard]] inline double frequency_ratio(const PhysicalFrequency& physical, const dynamics::Geometry& block) {
  constexpr double two_pi = 0x1.921fb54442d18p+2;
  const double value = mean_of(physical.value);
  return physical.unit == FrequencyUnit::hertz ? two_pi * value / block.frequency_parameter
                                               : two_pi / (value * block.frequency_parameter);
}

/// What a realisation has drawn of its base motion.
struct DrawnShaking {
  double size = 0.0;  ///< amplitude, or scale of a ground motion, as it is given
  dynamics::VerticalSine vertical = {};
  std::optional<Building> building = std::nullopt;  ///< of numbers without laws; absent: the block stands on the ground
  friend bool operator==(const DrawnShaking&, const DrawnShaking&) = default;
};

/// Vertical part of a harmonic excitation: a_v/g = A_v psi sin(Omega_v tau + Phi_v), > 0 upwards.
struct VerticalHarmonic {
  Quantity amplitude = 0.0;        ///< A_v [-]; not used with a physical amplitude
  Quantity frequency_ratio = 1.0;  ///< Omega_v over p [-]; not used with a physical frequency
  Quantity phase = 0.0;            ///< Phi_v [rad]
  std::optional<PhysicalAmplitude> physical_amplitude = std::nullopt;  ///< in place of A_v
  std::optional<PhysicalFrequency> physical_frequency = std::nullopt;  ///< in place of Omega_v

  friend bool operator==(const VerticalHarmonic&, const VerticalHarmonic&) = default;
};

/// Harmonic excitation as asked for: a_h/g = A_h psi sin(Omega_h tau + Phi).
struct Harmonic {
  static constexpr std::string_view name = "harmonic";
  static constexpr std::string_view in_words = "shakes harmonically";
  static constexpr bool is_periodic = true;
  static constexpr AmplitudeDraws amplitude_draws = AmplitudeDraws::each_period;

  Quantity amplitude = 0.0;        ///< A_h [-]; not used with a physical amplitude
  Quantity frequency_ratio = 1.0;  ///< Omega_h = omega/p [-]; not used with a physical frequency
  Quantity phase = 0.0;            ///< Phi [rad]
  std::optional<PhysicalAmplitude> physical_amplitude = std::nullopt;  ///< in place of A_h
  std::optional<PhysicalFrequency> physical_frequency = std::nullopt;  ///< in place of Omega_h
  std::optional<VerticalHarmonic> vertical = std::nullopt;             ///< absent: the base moves horizontally only

  friend bool operator==(const Harmonic&, const Harmonic&) = default;

  /// The default horizon depends on the kind only.
  static constexpr std::array<std::string_view, 1> horizon_follows_from{"/excitation/kind"};

  [[nodiscard]] double size() const { return mean_of(physical_amplitude ? physical_amplitude->value : amplitude); }
  [[nodiscard]] double size_unit(const dynamics::Geometry& own, double gravity) const {
    return amplitude_unit(physical_amplitude, own, gravity);
  }
  [[nodiscard]] double frequency_ratio_for(const dynamics::Geometry& own, const dynamics::Geometry&) const {
    return physical_frequency ? rocking::frequency_ratio(*physical_frequency, own) : mean_of(frequency_ratio);
  }
  [[nodiscard]] const Quantity& start_phase() const { return phase; }
  [[nodiscard]] static double end_of_shaking(const dynamics::Geometry&) {
    return std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] std::vector<std::string_view> effects() const {
    if (vertical) return {"vertical harmonic motion of the base"};
    return {};
  }
  /// Of a block; of quantities without laws.
  [[nodiscard]] dynamics::VerticalSine vertical_sine(const dynamics::Geometry& own, double gravity) const;
  [[nodiscard]] dynamics::Excitation motion(const dynamics::Geometry& block, const dynamics::Clock& clock,
                                            const DrawnShaking& drawn) const;
};

/// Keys that give how strong a ground motion is made; all but the first are measures of its intensity.
inline constexpr std::array<std::string_view, 7> all_strengths{"scale",  "pga_g",   "pgv_m_s",      "sa_g",
                                                               "sa_p_g", "avgsa_g", "sa_absolute_g"};

/// Recorded excitation as asked for: a ground motion times a scale.
struct Recorded {
  static constexpr std::string_view name = "recorded";
  static constexpr std::string_view in_words = "moves as recorded";
  static constexpr bool is_periodic = false;
  static constexpr AmplitudeDraws amplitude_draws = AmplitudeDraws::refused;

  std::shared_ptr<const GroundMotion> ground_motion{};  ///< null only if its file was found to be unreadable
  Quantity scale = 1.0;                                 ///< factor on all accelerations [-]
  double frequency_ratio = 1.0;                         ///< frequency of the strobe over p [-]
  /// Of the spectral acceleration by which a file gives the scale [s]: one, or the ends of a range. Empty: none.
  std::vector<double> measure_periods{};
  std::optional<double> level{};          ///< of intensity, of a record that is selected for one
  std::optional<double> return_period{};  ///< likewise in place of the level [years]
  std::optional<double> magnitude{};      ///< of the earthquake
  std::optional<double> distance_km{};    ///< from the station to the rupture
  std::optional<Building> building{};     ///< on a floor of which the block stands; absent: on the ground

  friend bool operator==(const Recorded&, const Recorded&) = default;

  static constexpr std::array<std::string_view, 10> horizon_follows_from{"/block",
                                                                         "/formulation",
                                                                         "/restitution",
                                                                         "/excitation/building",
                                                                         "/excitation/kind",
                                                                         "/excitation/file",
                                                                         "/excitation/component",
                                                                         "/excitation/time_step_s",
                                                                         "/excitation/columns",
                                                                         "/excitation/frequency_ratio"};

  [[nodiscard]] double size() const { return mean_of(scale); }
  [[nodiscard]] static double size_unit(const dynamics::Geometry&, double) { return 1.0; }
  [[nodiscard]] double frequency_ratio_for(const dynamics::Geometry& own, const dynamics::Geometry& mean) const {
    return frequency_ratio * (mean.frequency_parameter / own.frequency_parameter);
  }
  [[nodiscard]] static Quantity start_phase() { return 0.0; }
  [[nodiscard]] double end_of_shaking(const dynamics::Geometry& block) const {
    if (!ground_motion) return 0.0;
    const double more = building ? settling_time(*building) : 0.0;
    return (ground_motion->samples.back().time + more) * block.frequency_parameter;
  }
  [[nodiscard]] std::vector<std::string_view> effects() const {
    std::vector<std::string_view> names{"recorded horizontal motion of the base"};
    if (ground_motion->has_vertical) names.emplace_back("recorded vertical motion of the base");
    if (building) names.emplace_back("a building between the ground and the base");
    return names;
  }
  [[nodiscard]] dynamics::Excitation motion(const dynamics::Geometry& block, const dynamics::Clock& clock,
                                            const DrawnShaking& drawn) const;
};

/// The accelerations of the base over g, before scaling: those of the ground, or of the floor of the mean building.
[[nodiscard]] inline std::vector<dynamics::GroundMotionSample> base_motion(const Recorded& recorded) {
  const auto& ground = recorded.ground_motion->samples;
  return recorded.building ? floor_motion(ground, *recorded.building) : ground;
}

/// A pulse as asked for: one pulse of a given shape, from tau = 0 on.
struct Pulse {
  static constexpr std::string_view name = "pulse";
  static constexpr std::string_view in_words = "moves in one pulse";
  static constexpr bool is_periodic = false;
  static constexpr AmplitudeDraws amplitude_draws = AmplitudeDraws::once;
  static constexpr std::array<std::string_view, 9> horizon_follows_from{"/block",
                                                                        "/formulation",
                                                                        "/restitution",
                                                                        "/excitation/kind",
                                                                        "/excitation/shape",
                                                                        "/excitation/cycles",
                                                                        "/excitation/frequency_ratio",
                                                                        "/excitation/frequency_hz",
                                                                        "/excitation/period_s"};

  dynamics::PulseShape shape = dynamics::PulseShape::sine;
  Quantity amplitude = 0.0;        ///< A_h [-]; not used with a physical amplitude
  Quantity frequency_ratio = 1.0;  ///< Omega_h = omega/p, of the pulse and the strobe [-]; likewise
  std::optional<PhysicalAmplitude> physical_amplitude = std::nullopt;  ///< in place of A_h
  std::optional<PhysicalFrequency> physical_frequency = std::nullopt;  ///< in place of Omega_h
  double phase_of_shape = 0.0;                                         ///< see dynamics::PulseForm [rad]
  double cycles = 1.0;                                                 ///< likewise [-]

  friend bool operator==(const Pulse&, const Pulse&) = default;

  [[nodiscard]] double size() const { return mean_of(physical_amplitude ? physical_amplitude->value : amplitude); }
  [[nodiscard]] double size_unit(const dynamics::Geometry& own, double gravity) const {
    return amplitude_unit(physical_amplitude, own, gravity);
  }
  [[nodiscard]] double frequency_ratio_for(const dynamics::Geometry& own, const dynamics::Geometry&) const {
    return physical_frequency ? rocking::frequency_ratio(*physical_frequency, own) : mean_of(frequency_ratio);
  }
  [[nodiscard]] static Quantity start_phase() { return 0.0; }
  [[nodiscard]] double end_of_shaking(const dynamics::Geometry& block) const {
    constexpr double two_pi = 0x1.921fb54442d18p+2;
    return dynamics::pulse_length(form()) * two_pi / frequency_ratio_for(block, block);
  }
  [[nodiscard]] dynamics::PulseForm form() const { return {.shape = shape, .phase = phase_of_shape, .cycles = cycles}; }
  [[nodiscard]] static std::vector<std::string_view> effects() { return {"one pulse of the base"}; }
  [[nodiscard]] dynamics::Excitation motion(const dynamics::Geometry& block, const dynamics::Clock& clock,
                                            const DrawnShaking& drawn) const;
};

/// The requested base motion. Every kind has: `name` as in files; `in_words`, what the base does; `is_periodic`;
/// `amplitude_draws`; `horizon_follows_from`, the places of the file from which the default horizon is computed;
/// size(), the mean of a drawn or fluctuating amplitude as it is given, and size_unit(), by which it is divided for a block, so
/// that the quotient is A_h or the scale [-]; frequency_ratio_for(own, mean), Omega_h of the clock and the strobe for a
/// realisation's own block, where the mean block is that of the scene [-]; start_phase() [rad]; end_of_shaking(block),
/// a normalised time; effects() as described to users; and motion(block, clock, drawn), how the base moves in a
/// realisation. Its keys and its motion: excitation.cpp.
using Excitation = std::variant<Harmonic, Recorded, Pulse>;

[[nodiscard]] inline std::string_view name_of(const Excitation& excitation) {
  return std::visit([](const auto& kind) { return kind.name; }, excitation);
}
[[nodiscard]] inline bool is_periodic(const Excitation& excitation) {
  return std::visit([](const auto& kind) { return kind.is_periodic; }, excitation);
}
[[nodiscard]] inline AmplitudeDraws amplitude_draws(const Excitation& excitation) {
  return std::visit([](const auto& kind) { return kind.amplitude_draws; }, excitation);
}
[[nodiscard]] inline std::span<const std::string_view> horizon_follows_from(const Excitation& excitation) {
  return std::visit([](const auto& kind) { return std::span<const std::string_view>(kind.horizon_follows_from); },
                    excitation);
}
[[nodiscard]] inline double size_of(const Excitation& excitation) {
  return std::visit([](const auto& kind) { return kind.size(); }, excitation);
}
/// Of a harmonic excitation with a vertical part; else null.
[[nodiscard]] inline const VerticalHarmonic* vertical_of(const Excitation& excitation) {
  const auto* harmonic = std::get_if<Harmonic>(&excitation);
  return harmonic != nullptr && harmonic->vertical ? &*harmonic->vertical : nullptr;
}
[[nodiscard]] inline Quantity start_phase(const Excitation& excitation) {
  return std::visit([](const auto& kind) -> Quantity { return kind.start_phase(); }, excitation);
}

}  // namespace rocking
