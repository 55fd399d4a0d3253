#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/excitation/base_excitation.hpp"
#include "rocking/dynamics/excitation/harmonic.hpp"
#include "rocking/dynamics/excitation/shape.hpp"

namespace rocking::dynamics {

/// alpha = A_h psi f(x) from tau = 0 to the end of the pulse, 0 after it; no vertical motion. abs(f) <= 1.
///
///     sine         f = sin(x + phase)                 x = Omega_h tau, 0 <= x <= 2 pi
///     cosine       f = cos(x + phase)                 the same; f jumps where it is not 0 at an end
///     half_sine    f = sin(x)                         0 <= x <= pi
///     type_c       f = -(-1)^n sin(x)                 x = Omega_h tau - z_n, abs(x) <= z_n
///     ricker       f = (1 - x^2/2) exp(-x^2/4)        x = Omega_h tau - 2 pi ricker_half_length, cut at both ends
///     mavroeidis_papageorgiou                         x = Omega_h tau - pi gamma, abs(x) <= pi gamma, g = 1/gamma:
///       f = -(sin(x + phase) + (1 + g)/2 sin((1 + g) x + phase) + (1 - g)/2 sin((1 - g) x + phase))/2
///
/// (`rectangle` and `triangle` are linear between corners: RecordedExcitation.) type_c is cos(Omega_h tau + phi) of its
/// source, after which velocity and displacement are 0, where cot(phi) = (n + 1/2) pi - phi: z_n = (n + 1/2) pi - phi is
/// the n-th root of tan(z) = z. mavroeidis_papageorgiou is the derivative of the velocity A/2 (1 + cos(g x)) cos(x +
/// phase) over omega A, so that A_h psi g = omega A; its peak is smaller.
///
/// The spectrum of ricker, proportional to omega^2 exp(-(omega/Omega_h)^2), has its peak at Omega_h. But for the side
/// bands 1 + g and 1 - g, which are sines added where there are any, all f solve, with the time t since x = 0, f'' +
/// Omega_h^2 (c t f' + q f) = 0, c = 0 and q = 1, or c = 1/2 and q = 3/2 for ricker, from which the Taylor coefficients
/// follow:
///
///     f_{k+2} = -Omega_h^2 (c t f_{k+1}/(k + 2) + (c k + q) f_k/((k + 1) (k + 2)))
///
/// Source: Zhang & Makris (2001), J. Eng. Mech. 127(5) 473-483 (sine and cosine); Makris (1997), Earthq. Eng. Struct.
/// Dyn. 26(5) 571-591 (type_c); Ricker (1943), Bull. Seismol. Soc. Am. 33(3) 197-228, in the form of Makris & Vassiliou
/// (2013), Earthq. Eng. Struct. Dyn. 42(3) 431-449; Mavroeidis & Papageorgiou (2003), Bull. Seismol. Soc. Am. 93(3)
/// 1099-1131.
class PulseExcitation {
 public:
  static constexpr bool is_periodic = false;
  static constexpr bool has_vertical = false;
  static constexpr bool bounds_acceleration = true;
  static constexpr bool has_knots = false;
  /// Period and time of x = 0; 1 during the pulse and 0 after it; the shares of sine, cosine and ricker in f; g, 0 where
  /// there are no side bands.
  static constexpr std::size_t piece_numbers = 7;

  /// Of a pulse that begins with the clock; not `rectangle` or `triangle`.
  PulseExcitation(const PulseForm& form, const Clock& clock);

  [[nodiscard]] static double unit(const Geometry& block) { return block.shape_angle; }
  [[nodiscard]] double horizontal(const Clock& clock, double amplitude) const {
    const Piece<PulseExcitation, double> now = piece(clock);
    const auto [value, slope, elapsed] = start_of(now, moment_of(clock));
    double alpha = amplitude * value;
    for (const double side : {1.0, -1.0}) {
      if (!(now[6] > 0.0)) continue;
      const SideBand<double> band = band_of(now, side, amplitude, clock.frequency() * elapsed);
      alpha = alpha + band.amplitude * band.angle.sine;
    }
    return alpha;
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
    using base::fused, base::in_any;
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
    if (in_any(Real(0.0) < piece[6]))
      add_side_bands<order>(series.base, piece, amplitude, start.elapsed, now.frequency);
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
    const Real bell = piece[5] * base::exponential(Real(-0.25) * (piece[5] * square));  // e^0 where f has no bell
    const Real value =
        fused(bell, fused(Real(-0.5), square, Real(1.0)), piece[3] * angle.sine + piece[4] * angle.cosine);
    const Real slope =
        fused(bell * x, fused(Real(0.25), square, Real(-1.5)), piece[3] * angle.cosine - piece[4] * angle.sine);
    return {.value = value, .slope = slope, .elapsed = elapsed};
  }

  /// amplitude sin(ratio x + phase) in alpha.
  template <base::Lane Real>
  struct SideBand {
    Real amplitude;
    Real ratio;
    base::SinCos<Real> angle;
  };

  /// The upper (`side` 1) or the lower one (-1).
  template <base::Lane Real>
  [[nodiscard]] static SideBand<Real> band_of(const std::array<Real, piece_numbers>& piece, double side,
                                              const Real& amplitude, const Real& x) {
    const Real ratio = Real(1.0) + Real(side) * piece[6];
    const base::SinCos<Real> angle = base::sin_cos(ratio * x);
    return {.amplitude = amplitude * (Real(0.5) * ratio),
            .ratio = ratio,
            .angle = {.sine = piece[3] * angle.sine + piece[4] * angle.cosine,
                      .cosine = piece[3] * angle.cosine - piece[4] * angle.sine}};
  }

  /// Where a lane has none, its numbers keep their bits.
  template <int order, base::Lane Real>
  static void add_side_bands(typename MotionSeries<Real>::Row& base, const std::array<Real, piece_numbers>& piece,
                             const Real& amplitude, const Real& elapsed, const Real& frequency) {
    using rocking::base::select;  // `base` is the row here
    const auto has_bands = Real(0.0) < piece[6];
    for (const double side : {1.0, -1.0}) {
      const SideBand<Real> band = band_of(piece, side, amplitude, frequency * elapsed);
      typename MotionSeries<Real>::Row own;
      expand_harmonic<order>(own, band.amplitude, band.ratio * frequency, band.angle);
      kernel::repeat<order + 1>([&](auto k) { base[k] = select(has_bands, base[k] + own[k], base[k]); });
    }
  }

  [[nodiscard]] bool is_over(const Clock& clock) const { return clock.until(end_) <= clock.resolution(); }

  Instant end_{};
  Piece<PulseExcitation, double> during_{};
};

}  // namespace rocking::dynamics
