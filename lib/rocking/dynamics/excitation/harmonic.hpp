#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/excitation/base_excitation.hpp"

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

/// alpha = A_h psi sin(Omega_h tau + Phi), no vertical motion (Jeong & Yang 2012, Eq. 17).
struct HarmonicExcitation {
  static constexpr bool is_periodic = true;
  static constexpr bool has_vertical = false;
  static constexpr bool bounds_acceleration = true;
  static constexpr bool has_knots = false;
  static constexpr std::size_t piece_numbers = 0;

  [[nodiscard]] static double unit(const Geometry& block) { return block.shape_angle; }
  [[nodiscard]] static double horizontal(const Clock& clock, double amplitude) {
    return amplitude * base::sin_cos(clock.angle()).sine;
  }
  [[nodiscard]] static double most_horizontal(double amplitude) { return amplitude < 0.0 ? -amplitude : amplitude; }
  [[nodiscard]] static double weight(const Clock&) { return 1.0; }
  [[nodiscard]] static std::optional<Instant> next_change(const Clock&) { return std::nullopt; }
  [[nodiscard]] static Piece<HarmonicExcitation, double> piece(const Clock&) { return {}; }

  template <int order, base::Lane Real>
  static void expand(MotionSeries<Real>& series, const Piece<HarmonicExcitation, Real>&, const Real& amplitude,
                     const Moment<Real>& now) {
    expand_harmonic<order>(series.base, amplitude, now.frequency, base::sin_cos(now.frequency * now.time));
  }
};

}  // namespace rocking::dynamics
