#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/motion_series.hpp"

namespace rocking::dynamics {

/// How the base moves. Values are base accelerations over g; `amplitude` is the one in force times `unit`.
template <class Motion>
concept BaseExcitation = requires(Motion motion, const Clock& clock, const Geometry& block, double amplitude,
                                  MotionSeries<double>& series) {
  { Motion::has_vertical } -> std::convertible_to<bool>;
  { motion.unit(block) } -> std::convertible_to<double>;                   // alpha for amplitude 1
  { motion.horizontal(clock, amplitude) } -> std::convertible_to<double>;  // alpha now
  { motion.most_horizontal(amplitude) } -> std::convertible_to<double>;    // abs(alpha) is at most that at any time
  { motion.weight(clock) } -> std::convertible_to<double>;                 // 1 + alpha_v now
  { motion.next_change(clock) } -> std::same_as<std::optional<Instant>>;   // until which the series hold
  { motion.segments_looked_up() } -> std::same_as<std::uint64_t>;          // of a record
  motion.template expand<full_order>(series, clock, amplitude);            // series of alpha and, if vertical, 1 + alpha_v
};

/// alpha = A_h psi sin(Omega_h tau + Phi), no vertical motion (Jeong & Yang 2012, Eq. 17).
struct HarmonicExcitation {
  static constexpr bool has_vertical = false;

  [[nodiscard]] static double unit(const Geometry& block) { return block.shape_angle; }
  [[nodiscard]] static double horizontal(const Clock& clock, double amplitude) {
    return amplitude * base::sin_cos(clock.angle()).sine;
  }
  [[nodiscard]] static double most_horizontal(double amplitude) { return amplitude < 0.0 ? -amplitude : amplitude; }
  [[nodiscard]] static double weight(const Clock&) { return 1.0; }
  [[nodiscard]] static std::optional<Instant> next_change(const Clock&) { return std::nullopt; }
  [[nodiscard]] static std::uint64_t segments_looked_up() { return 0; }

  template <int order>
  static void expand(MotionSeries<double>& series, const Clock& clock, double amplitude) {
    expand_harmonic<order>(series.base, amplitude, clock.frequency(), base::sin_cos(clock.angle()));
  }
};

}  // namespace rocking::dynamics
