#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/excitation/base_excitation.hpp"
#include "rocking/dynamics/excitation/shape.hpp"

namespace rocking::dynamics {

/// beta = amplitude sin(omega x + angle), from sine and cosine of the angle, to `order`.
template <int order, base::Lane Real>
inline void expand_harmonic(typename MotionSeries<Real>::Row& base, Real amplitude, Real frequency,
                            const base::SinCos<Real>& angle) {
  using namespace kernel;
  base[0] = amplitude * angle.sine;
  base[1] = amplitude * frequency * angle.cosine;
  const Real curvature = -(frequency * frequency);
  repeat<order - 1>([&](auto index) {
    constexpr int k = index + 2;
    base[k] = base[k - 2] * curvature * Real(over<k> * over<k - 1>);
  });
}

/// alpha = A_h psi sin(Omega_h tau + Phi) (Jeong & Yang 2012, Eq. 17); vertically a sine, where `vertical`.
template <bool vertical>
class HarmonicExcitation {
 public:
  static constexpr bool is_periodic = true;
  static constexpr bool has_vertical = vertical;
  /// The bounds that follow from it hold over a base without vertical motion.
  static constexpr bool bounds_acceleration = !vertical;
  static constexpr bool has_knots = false;
  /// Amplitude, cycles and periods of a VerticalSine, and its argument at the time 0 of period 0.
  static constexpr std::size_t piece_numbers = vertical ? 4 : 0;
  using Numbers = std::array<double, piece_numbers>;

  HarmonicExcitation() = default;
  /// On a clock whose run starts at its start().
  HarmonicExcitation(const VerticalSine& sine, const Clock& clock) requires(vertical)
      : numbers_{sine.amplitude, sine.cycles, sine.periods,
                 sine.phase - sine.cycles / sine.periods * (clock.frequency() * clock.start())} {}

  [[nodiscard]] static double unit(const Geometry& block) { return block.shape_angle; }
  [[nodiscard]] static double horizontal(const Clock& clock, double amplitude) {
    return amplitude * base::sin_cos(clock.angle()).sine;
  }
  [[nodiscard]] static double most_horizontal(double amplitude) {
    if (!bounds_acceleration) return std::numeric_limits<double>::infinity();
    return amplitude < 0.0 ? -amplitude : amplitude;
  }
  [[nodiscard]] double weight([[maybe_unused]] const Clock& clock) const {
    if constexpr (vertical) return 1.0 + numbers_[0] * vertical_angle(numbers_, moment_of(clock)).sine;
    return 1.0;
  }
  [[nodiscard]] static std::optional<Instant> next_change(const Clock&) { return std::nullopt; }
  [[nodiscard]] Numbers piece(const Clock&) const { return numbers_; }

  template <int order, base::Lane Real>
  static void expand(MotionSeries<Real>& series, [[maybe_unused]] const std::array<Real, piece_numbers>& piece,
                     const Real& amplitude, const Moment<Real>& now) {
    expand_harmonic<order>(series.base, amplitude, now.frequency, base::sin_cos(now.frequency * now.time));
    if constexpr (vertical) {
      const Real frequency = piece[1] / piece[2] * now.frequency;
      expand_harmonic<order>(series.weight, piece[0], frequency, vertical_angle(piece, now));
      series.weight[0] = series.weight[0] + Real(1.0);
    }
  }

 private:
  /// Sine and cosine of the argument of the vertical motion. The cycles of whole periods are counted without loss: with
  /// n cycles in `periods` the remainder of n times the period number is exact, so that the motion repeats to the bit.
  template <base::Lane Real>
  [[nodiscard]] static base::SinCos<Real> vertical_angle(const std::array<Real, piece_numbers>& piece,
                                                         const Moment<Real>& now) {
    using base::fused;
    constexpr double two_pi = 0x1.921fb54442d18p+2;
    constexpr double rounder = 0x1.8p52;  // adding and subtracting it rounds to the nearest integer
    const Real& cycles = piece[1];
    const Real& periods = piece[2];
    const Real count = cycles * now.period;
    const Real lost = fused(cycles, now.period, -count);
    const Real turns = (count / periods + Real(rounder)) - Real(rounder);
    const Real left = fused(-turns, periods, count) + lost;
    const Real within = cycles / periods * (now.frequency * now.time) + piece[3];
    return base::sin_cos(fused(left / periods, Real(two_pi), within));
  }

  Numbers numbers_{};
};

}  // namespace rocking::dynamics
