#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Mean vertical sine of a base motion, for the mean block of a scene.
struct VerticalShaking {
  double amplitude_g = 0.0;   ///< peak acceleration over the gravity of the scene [-]
  double frequency_hz = 1.0;  ///< [Hz]
  double phase_rad = 0.0;     ///< at the start of the run
  friend bool operator==(const VerticalShaking&, const VerticalShaking&) = default;
};

/// Amplitude and frequency of the base motion in every unit, for the mean block of a scene. Numbers that the scene
/// gives are exactly those; the others follow from them.
struct Shaking {
  double amplitude = 0.0;        ///< A_h [-]
  double amplitude_g = 0.0;      ///< peak acceleration over the gravity of the scene [-]
  double amplitude_m_s2 = 0.0;   ///< peak acceleration [m/s^2]
  double frequency_ratio = 1.0;  ///< Omega_h [-]
  double frequency_hz = 1.0;     ///< [Hz]
  double period_s = 1.0;         ///< [s]
  /// Keys that the scene gives: `amplitude`, `amplitude_g` or `amplitude_m_s2`; `frequency_ratio`, `frequency_hz` or
  /// `period_s`.
  std::string_view given_amplitude = "amplitude";
  std::string_view given_frequency = "frequency_ratio";
  std::optional<VerticalShaking> vertical = std::nullopt;  ///< beside a harmonic excitation
  bool has_drawn_amplitude = false;                        ///< whether amplitudes are means of what is drawn
  bool has_drawn_frequency = false;                        ///< whether frequencies and the period are
};

/// A number of a Shaking with the key that it has in files.
struct ShakingNumber {
  std::string_view key;
  double Shaking::*number;
};

/// In the order of files: amplitudes, then frequencies. In each half the first is the normalised one.
inline constexpr std::array<ShakingNumber, 6> shaking_numbers{{{"amplitude", &Shaking::amplitude},
                                                               {"amplitude_g", &Shaking::amplitude_g},
                                                               {"amplitude_m_s2", &Shaking::amplitude_m_s2},
                                                               {"frequency_ratio", &Shaking::frequency_ratio},
                                                               {"frequency_hz", &Shaking::frequency_hz},
                                                               {"period_s", &Shaking::period_s}}};

/// psi of the sides of blocks, at which they are in balance [rad]; of drawn blocks that of the mean one, at a wall of one side.
struct BalanceAngles {
  double least = 0.0;
  double largest = 0.0;
  bool is_of_mean_block = false;  ///< whether a block is drawn
};
[[nodiscard]] BalanceAngles balance_of(const Scene& scene);
/// Of both.
[[nodiscard]] BalanceAngles joined(const std::optional<BalanceAngles>& first, const BalanceAngles& second);

/// Absent under a ground motion, which has neither.
[[nodiscard]] std::optional<Shaking> shaking_of(const Scene& scene);

}  // namespace rocking
