#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/scene/quantity.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {

/// Accelerations of a recorded ground motion, as data.
struct GroundMotion {
  std::vector<dynamics::GroundMotionSample> samples;  ///< time [s]; accelerations over g, before scaling
  bool has_vertical = false;
};

/// When a fluctuating amplitude is drawn: at each excitation period, or once in a realisation. `refused`: a fluctuation
/// of the amplitude is not allowed.
enum class AmplitudeDraws : std::uint8_t { each_period, once, refused };

/// Harmonic excitation as asked for: a_h/g = A_h psi sin(Omega_h tau + Phi).
struct Harmonic {
  static constexpr std::string_view name = "harmonic";
  static constexpr std::string_view in_words = "shakes harmonically";
  static constexpr bool is_periodic = true;
  static constexpr AmplitudeDraws amplitude_draws = AmplitudeDraws::each_period;

  double amplitude = 0.0;        ///< A_h [-]
  double frequency_ratio = 1.0;  ///< Omega_h = omega/p [-]
  Quantity phase = 0.0;          ///< Phi [rad]

  friend bool operator==(const Harmonic&, const Harmonic&) = default;

  /// The default horizon depends on the kind only.
  static constexpr std::array<std::string_view, 1> horizon_follows_from{"/excitation/kind"};

  [[nodiscard]] double size() const { return amplitude; }
  [[nodiscard]] const Quantity& start_phase() const { return phase; }
  [[nodiscard]] static double end_of_shaking(double) { return std::numeric_limits<double>::infinity(); }
  [[nodiscard]] std::vector<std::string_view> effects() const { return {}; }
  [[nodiscard]] dynamics::Excitation motion(const dynamics::Geometry&, const dynamics::Clock&) const {
    return dynamics::HarmonicExcitation{};
  }
  template <class Check>
  void check(const Check& number) const {
    number("/excitation/amplitude", amplitude, rules::amplitude);
    number("/excitation/frequency_ratio", frequency_ratio, rules::frequency_ratio);
    number("/excitation/phase_rad", phase, rules::phase);
  }
};

/// Recorded excitation as asked for: a ground motion times a scale.
struct Recorded {
  static constexpr std::string_view name = "recorded";
  static constexpr std::string_view in_words = "moves as recorded";
  static constexpr bool is_periodic = false;
  static constexpr AmplitudeDraws amplitude_draws = AmplitudeDraws::refused;

  std::shared_ptr<const GroundMotion> ground_motion{};  ///< null only if its file was found to be unreadable
  double scale = 1.0;                                   ///< factor on all accelerations [-]
  double frequency_ratio = 1.0;                         ///< frequency of the strobe over p [-]

  friend bool operator==(const Recorded&, const Recorded&) = default;

  static constexpr std::array<std::string_view, 6> horizon_follows_from{"/block",
                                                                        "/formulation",
                                                                        "/restitution",
                                                                        "/excitation/kind",
                                                                        "/excitation/time_step_s",
                                                                        "/excitation/frequency_ratio"};

  [[nodiscard]] double size() const { return scale; }
  [[nodiscard]] static Quantity start_phase() { return 0.0; }
  [[nodiscard]] double end_of_shaking(double frequency_parameter) const {
    return ground_motion ? ground_motion->samples.back().time * frequency_parameter : 0.0;
  }
  [[nodiscard]] std::vector<std::string_view> effects() const {
    std::vector<std::string_view> names{"recorded horizontal motion of the base"};
    if (ground_motion->has_vertical) names.emplace_back("recorded vertical motion of the base");
    return names;
  }
  [[nodiscard]] dynamics::Excitation motion(const dynamics::Geometry& block, const dynamics::Clock& clock) const {
    const auto knots = std::make_shared<const dynamics::NormalisedGroundMotion>(ground_motion->samples,
                                                                                block.frequency_parameter, clock);
    if (ground_motion->has_vertical) return dynamics::RecordedExcitation<true>(knots, scale);
    return dynamics::RecordedExcitation<false>(knots, scale);
  }
  template <class Check>
  void check(const Check& number) const {
    number("/excitation/file", ground_motion);
    number("/excitation/scale", scale, rules::scale);
    number("/excitation/frequency_ratio", frequency_ratio, rules::frequency_ratio);
  }
};

/// A pulse as asked for: one pulse of a given shape, from tau = 0 on.
struct Pulse {
  static constexpr std::string_view name = "pulse";
  static constexpr std::string_view in_words = "moves in one pulse";
  static constexpr bool is_periodic = false;
  static constexpr AmplitudeDraws amplitude_draws = AmplitudeDraws::once;
  static constexpr std::array<std::string_view, 6> horizon_follows_from{
      "/block", "/formulation", "/restitution", "/excitation/kind", "/excitation/shape", "/excitation/frequency_ratio"};

  dynamics::PulseShape shape = dynamics::PulseShape::sine;
  double amplitude = 0.0;        ///< A_h [-]
  double frequency_ratio = 1.0;  ///< Omega_h = omega/p, of the pulse and the strobe [-]

  friend bool operator==(const Pulse&, const Pulse&) = default;

  [[nodiscard]] double size() const { return amplitude; }
  [[nodiscard]] static Quantity start_phase() { return 0.0; }
  [[nodiscard]] double end_of_shaking(double) const {
    constexpr double two_pi = 0x1.921fb54442d18p+2;
    return dynamics::pulse_length(shape) * two_pi / frequency_ratio;
  }
  [[nodiscard]] static std::vector<std::string_view> effects() { return {"one pulse of the base"}; }
  [[nodiscard]] dynamics::Excitation motion(const dynamics::Geometry&, const dynamics::Clock& clock) const {
    return dynamics::PulseExcitation(shape, clock);
  }
  template <class Check>
  void check(const Check& number) const {
    number("/excitation/amplitude", amplitude, rules::amplitude);
    number("/excitation/frequency_ratio", frequency_ratio, rules::frequency_ratio);
  }
};

/// The requested base motion. Every kind has: `name` as in files; `in_words`, what the base does; `is_periodic`;
/// `amplitude_draws`; `frequency_ratio` of the clock and the strobe [-]; `horizon_follows_from`, the places of the file
/// from which the default horizon is computed; size(), the mean of a fluctuating amplitude [-]; start_phase() [rad];
/// end_of_shaking(p), a normalised time; effects() as described to users; motion() of a realisation; and check(), which
/// hands each number with its place and rule to a NumberChecker.
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
[[nodiscard]] inline double frequency_ratio(const Excitation& excitation) {
  return std::visit([](const auto& kind) { return kind.frequency_ratio; }, excitation);
}
[[nodiscard]] inline double size_of(const Excitation& excitation) {
  return std::visit([](const auto& kind) { return kind.size(); }, excitation);
}
[[nodiscard]] inline Quantity start_phase(const Excitation& excitation) {
  return std::visit([](const auto& kind) -> Quantity { return kind.start_phase(); }, excitation);
}

}  // namespace rocking
