#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"

namespace rocking {

/// What was computed for a realisation, a condition or a run, by effect. If a scene does not use an effect, its
/// counters are 0.
struct OperationCounts {
  std::uint64_t steps = 0;            ///< Taylor steps
  std::uint64_t slip_steps = 0;       ///< of these, steps of the equations with slip (slide, rock_slide)
  std::uint64_t root_isolations = 0;  ///< searches for a zero crossing that the inexpensive bound did not exclude
  std::uint64_t ground_motion_segments = 0;  ///< segments of a ground motion that were looked up
  std::uint64_t exponent_periods = 0;        ///< periods with tangent vectors, for the Lyapunov exponent
  std::uint64_t static_friction_draws = 0;
  std::uint64_t kinetic_friction_draws = 0;
  std::uint64_t restitution_draws = 0;
  std::uint64_t amplitude_draws = 0;
  std::uint64_t initial_draws = 0;                                 ///< draws of block, phase and initial state
  std::array<std::uint64_t, dynamics::event_kind_count> events{};  ///< by EventKind

  OperationCounts& operator+=(const OperationCounts& other);
  /// Random numbers of all sources.
  [[nodiscard]] std::uint64_t draws() const {
    return static_friction_draws + kinetic_friction_draws + restitution_draws + amplitude_draws + initial_draws;
  }
};

/// How often a draw was clamped when its value was used.
struct Clamps {
  /// Of all kinds.
  [[nodiscard]] std::uint64_t all() const;

  std::uint64_t kinetic_at_zero = 0;
  std::uint64_t kinetic_at_static = 0;  ///< mu_k limited to the mu_s in force
  std::uint64_t static_at_zero = 0;
  std::uint64_t restitution = 0;
  std::uint64_t amplitude_at_zero = 0;
  std::uint64_t length_at_bound = 0;  ///< width or height of the block

  Clamps& operator+=(const Clamps& other);
};

/// A member of Clamps, with its names.
struct ClampKind {
  std::string_view column;  ///< of a store
  std::string_view key;     ///< of a report
  std::uint64_t Clamps::*count;
  bool in_every_report = true;  ///< otherwise where it is not 0, so that other reports keep their bytes
};

inline constexpr std::array clamp_kinds{
    ClampKind{"clamped_kinetic_at_zero", "kinetic_friction_at_zero", &Clamps::kinetic_at_zero},
    ClampKind{"clamped_kinetic_at_static", "kinetic_friction_at_static", &Clamps::kinetic_at_static},
    ClampKind{"clamped_static_at_zero", "static_friction_at_zero", &Clamps::static_at_zero},
    ClampKind{"clamped_restitution", "restitution", &Clamps::restitution},
    ClampKind{"clamped_amplitude_at_zero", "amplitude_at_zero", &Clamps::amplitude_at_zero},
    ClampKind{"clamped_length_at_bound", "block_length_at_bound", &Clamps::length_at_bound, false},
};

/// The largest values that a realisation reached, also between strobe points, until it ended, and its slip at the end.
/// Theta and tau are normalised by the realisation's own block.
///
/// Of a realisation that ended before its horizon the peaks are lower bounds: the block went on to fall, or the model
/// had no answer. An overturned one has peak_tilt = (pi/2)/psi, the tilt at which it counts as overturned.
struct PeakValues {
  double tilt = 0.0;          ///< largest abs(Theta) [-]
  double tilt_rate = 0.0;     ///< largest abs(Theta') [-]
  double slip = 0.0;          ///< largest abs(X), over R [-]
  double slip_m = 0.0;        ///< the same [m]
  double final_slip = 0.0;    ///< X at the end, > 0 to the right, over R [-]
  double final_slip_m = 0.0;  ///< the same [m]
};

/// The peaks of a motion (dynamics::BlockMotion) of this block that has ended.
template <class Motion>
[[nodiscard]] PeakValues peaks_of(const Motion& motion, const dynamics::Geometry& block) {
  const double final_slip = motion.final_slip();
  const double slip = std::max(motion.peaks().slip, std::abs(final_slip));
  return {.tilt = motion.peaks().tilt / block.shape_angle,
          .tilt_rate = motion.peaks().tilt_rate / block.shape_angle,
          .slip = slip,
          .slip_m = slip * block.half_diagonal,
          .final_slip = final_slip,
          .final_slip_m = final_slip * block.half_diagonal};
}

/// What of a realisation must exceed a threshold.
enum class EventName : std::uint8_t {
  overturning,   ///< no threshold
  tilt,          ///< largest abs(Theta) [-]
  slip,          ///< largest abs(X) [m]
  displacement,  ///< abs(X) at the end [m]
};

/// Unit of a tilt: psi of the side of the block, at which it is in balance, radians or degrees.
enum class TiltUnit : std::uint8_t { psi, rad, deg };

/// A tilt as it was asked for.
struct AskedTilt {
  double value = 0.0;
  TiltUnit unit = TiltUnit::psi;
};

/// What a probability is about. An overturned block has every event: it is lost, and no slip of it is known after its fall.
struct ResponseEvent {
  EventName name = EventName::overturning;
  double threshold = 0.0;                         ///< >= 0; of a tilt over psi; not used by overturning
  std::optional<AskedTilt> asked = std::nullopt;  ///< in another unit, of which `threshold` must be made
  friend bool operator==(const ResponseEvent& a, const ResponseEvent& b) {
    return a.name == b.name && a.threshold == b.threshold;
  }

  [[nodiscard]] bool is_overturning() const { return name == EventName::overturning; }
  /// Whether it is about sliding, which needs friction.
  [[nodiscard]] bool is_of_slip() const { return name == EventName::slip || name == EventName::displacement; }
  /// What the threshold is compared with; of an overturning the largest tilt.
  [[nodiscard]] double measured(const PeakValues& peaks) const {
    if (name == EventName::slip) return peaks.slip_m;
    return name == EventName::displacement ? std::abs(peaks.final_slip_m) : peaks.tilt;
  }
  /// Whether a realisation that has not overturned has it.
  [[nodiscard]] bool is_exceeded(const PeakValues& peaks) const {
    return !is_overturning() && measured(peaks) > threshold;
  }
};

}  // namespace rocking
