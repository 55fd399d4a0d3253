#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/excitation/base_excitation.hpp"
#include "rocking/dynamics/excitation/shape.hpp"

namespace rocking::dynamics {

/// alpha = A_h psi f(x) from tau = 0 to the end of the pulse, 0 after it; no vertical motion. abs(f) <= 1.
///
///     sine     f = sin(x)                          x = Omega_h tau, 0 <= x <= 2 pi
///     cosine   f = cos(x)                          the same; f jumps from 0 to 1 and back
///     ricker   f = (1 - x^2/2) exp(-x^2/4)         x = Omega_h tau - 2 pi ricker_half_length, cut at both ends
///
/// The spectrum of ricker, proportional to omega^2 exp(-(omega/Omega_h)^2), has its peak at Omega_h. With the time t
/// since x = 0 all of them solve f'' + Omega_h^2 (c t f' + q f) = 0, c = 0 and q = 1, or c = 1/2 and q = 3/2 for
/// ricker, from which the Taylor coefficients follow:
///
///     f_{k+2} = -Omega_h^2 (c t f_{k+1}/(k + 2) + (c k + q) f_k/((k + 1) (k + 2)))
///
/// Source: Zhang & Makris (2001), J. Eng. Mech. 127(5) 473-483 (sine and cosine); Ricker (1943), Bull. Seismol. Soc.
/// Am. 33(3) 197-228, in the form of Makris & Vassiliou (2013), Earthq. Eng. Struct. Dyn. 42(3) 431-449.
class PulseExcitation {
 public:
  static constexpr bool is_periodic = false;
  static constexpr bool has_vertical = false;
  static constexpr bool bounds_acceleration = true;
  static constexpr bool has_knots = false;
  /// Period and time of x = 0; 1 during the pulse and 0 after it; the shares of sine, cosine and ricker in f.
  static constexpr std::size_t piece_numbers = 6;

  /// Of a pulse that begins with the clock.
  PulseExcitation(PulseShape shape, const Clock& clock)
      : origin_(later(clock, shape == PulseShape::ricker ? ricker_half_length : 0.0)),
        end_(later(clock, pulse_length(shape))) {
    during_ = {static_cast<double>(origin_.period), origin_.time, 1.0, 0.0, 0.0, 0.0};
    during_[3 + static_cast<std::size_t>(shape)] = 1.0;
  }

  [[nodiscard]] static double unit(const Geometry& block) { return block.shape_angle; }
  [[nodiscard]] double horizontal(const Clock& clock, double amplitude) const {
    return amplitude * start_of(piece(clock), moment_of(clock)).value;
  }
  [[nodiscard]] static double most_horizontal(double amplitude) { return std::abs(amplitude); }
  [[nodiscard]] static double weight(const Clock&) { return 1.0; }
  [[nodiscard]] std::optional<Instant> next_change(const Clock& clock) const {
    return is_over(clock) ? std::nullopt : std::optional(end_);
  }
  [[nodiscard]] Piece<PulseExcitation, double> piece(const Clock& clock) const {
    return is_over(clock) ? Piece<PulseExcitation, double>{} : during_;
  }

  template <int order, base::Lane Real>
  static void expand(MotionSeries<Real>& series, const std::array<Real, piece_numbers>& piece, const Real& amplitude,
                     const Moment<Real>& now) {
    using namespace kernel;
    using base::fused;
    const Start<Real> start = start_of(piece, now);
    series.base[0] = amplitude * start.value;
    series.base[1] = amplitude * now.frequency * start.slope;
    const Real curvature = -(now.frequency * now.frequency);
    const Real damping = Real(0.5) * piece[5];   // c
    const Real stiffness = Real(1.0) + damping;  // q
    const Real drift = curvature * damping * start.elapsed;
    repeat<order - 1>([&](auto index) {
      constexpr int k = index + 2;
      const Real restoring = fused(damping, Real(k - 2.0), stiffness) * curvature * Real(over<k> * over<k - 1>);
      series.base[k] = fused(series.base[k - 2], restoring, drift * series.base[k - 1] * Real(over<k>));
    });
  }

 private:
  /// f and df/dx now, and the time since x = 0; all 0 after the pulse.
  template <base::Lane Real>
  struct Start {
    Real value;
    Real slope;
    Real elapsed;
  };

  template <base::Lane Real>
  [[nodiscard]] static Start<Real> start_of(const std::array<Real, piece_numbers>& piece, const Moment<Real>& now) {
    using base::fused;
    const Real elapsed = -now.until(piece[0], piece[1]) * piece[2];
    const Real x = now.frequency * elapsed;
    const base::SinCos<Real> angle = base::sin_cos(x);
    const Real square = x * x;
    const Real bell = piece[5] * base::exponential(Real(-0.25) * square);
    const Real value =
        fused(bell, fused(Real(-0.5), square, Real(1.0)), piece[3] * angle.sine + piece[4] * angle.cosine);
    const Real slope =
        fused(bell * x, fused(Real(0.25), square, Real(-1.5)), piece[3] * angle.cosine - piece[4] * angle.sine);
    return {.value = value, .slope = slope, .elapsed = elapsed};
  }

  /// `periods` after tau = 0.
  [[nodiscard]] static Instant later(const Clock& clock, double periods) {
    const double whole = std::floor(periods);
    return {.period = static_cast<std::int64_t>(whole),
            .time = (periods - whole) * clock.period_length() + clock.start()};
  }

  [[nodiscard]] bool is_over(const Clock& clock) const { return clock.until(end_) <= clock.resolution(); }

  Instant origin_;
  Instant end_;
  Piece<PulseExcitation, double> during_;
};

}  // namespace rocking::dynamics
