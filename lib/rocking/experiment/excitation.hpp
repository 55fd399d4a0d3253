#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/experiment/quantity.hpp"

namespace rocking::experiment {

/// A base motion as it was recorded.
struct GroundMotion {
  std::vector<dynamics::RecordSample> samples;  ///< accelerations over g, before scaling
  bool has_vertical = false;
};

/// Asked for: a_h/g = A_h psi sin(Omega_h tau + Phi).
struct Harmonic {
  static constexpr std::string_view name = "harmonic";
  static constexpr bool is_periodic = true;

  double amplitude = 0.0;        ///< A_h [-]
  double frequency_ratio = 1.0;  ///< Omega_h = omega/p [-]
  Quantity phase = 0.0;          ///< Phi [rad]

  friend bool operator==(const Harmonic&, const Harmonic&) = default;

  [[nodiscard]] double size() const { return amplitude; }
  [[nodiscard]] const Quantity& start_phase() const { return phase; }
  [[nodiscard]] double last_second() const { return std::numeric_limits<double>::infinity(); }
  [[nodiscard]] std::vector<std::string_view> effects() const { return {}; }
  [[nodiscard]] dynamics::Excitation motion(const dynamics::Geometry&, const dynamics::Clock&) const {
    return dynamics::HarmonicExcitation{};
  }
  template <class Check>
  void check(const Check& finite) const {
    finite("/excitation/amplitude", amplitude);
    finite("/excitation/phase_rad", phase);
  }
};

/// Asked for: a record times a scale.
struct Recorded {
  static constexpr std::string_view name = "recorded";
  static constexpr bool is_periodic = false;

  std::shared_ptr<const GroundMotion> ground_motion{};  ///< null only while its file is found to be bad
  double scale = 1.0;                                   ///< [-]
  double frequency_ratio = 1.0;                         ///< of the strobe, over p [-]

  friend bool operator==(const Recorded&, const Recorded&) = default;

  [[nodiscard]] double size() const { return scale; }
  [[nodiscard]] static Quantity start_phase() { return 0.0; }
  [[nodiscard]] double last_second() const { return ground_motion ? ground_motion->samples.back().time : 0.0; }
  [[nodiscard]] std::vector<std::string_view> effects() const {
    std::vector<std::string_view> names{"recorded horizontal motion of the base"};
    if (ground_motion->has_vertical) names.emplace_back("recorded vertical motion of the base");
    return names;
  }
  [[nodiscard]] dynamics::Excitation motion(const dynamics::Geometry& block, const dynamics::Clock& clock) const {
    const auto knots =
        std::make_shared<const dynamics::RecordedMotion>(ground_motion->samples, block.frequency_parameter, clock);
    if (ground_motion->has_vertical) return dynamics::RecordedExcitation<true>(knots, scale);
    return dynamics::RecordedExcitation<false>(knots, scale);
  }
  template <class Check>
  void check(const Check& finite) const {
    finite("/excitation/scale", scale);
    for (const dynamics::RecordSample& sample : ground_motion->samples) {
      if (std::isfinite(sample.time) && std::isfinite(sample.horizontal) && std::isfinite(sample.vertical)) continue;
      for (const double number : {sample.time, sample.horizontal, sample.vertical}) finite("/excitation/file", number);
      return;
    }
  }
};

/// How the base is asked to move. Every kind has: `name` as in files, `is_periodic`, `frequency_ratio` of the clock and the
/// strobe, size() that a fluctuating amplitude is about, start_phase(), last_second() of the shaking, effects() as they are
/// told to users, motion() of a realisation, and check(), which calls finite(place, value) for each number.
using Excitation = std::variant<Harmonic, Recorded>;

[[nodiscard]] inline std::string_view name_of(const Excitation& excitation) {
  return std::visit([](const auto& kind) { return kind.name; }, excitation);
}
[[nodiscard]] inline bool is_periodic(const Excitation& excitation) {
  return std::visit([](const auto& kind) { return kind.is_periodic; }, excitation);
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

}  // namespace rocking::experiment
