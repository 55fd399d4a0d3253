#pragma once

#include "rocking/base/lane.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/dynamics/series_products.hpp"
#include "rocking/dynamics/setting.hpp"
#include "rocking/dynamics/tangent.hpp"

/// Taylor series of the variational equations over a step, from the series of the step itself.
///
/// In the side frame of motion_series.hpp, with a = S dtheta and its rate b = S dw, the derivatives of the equations of
/// rock and rock-slide with respect to the state are linear with known series as coefficients:
///
///     rock:        b' = K a                  K = beta s + g c, times the gain of w'
///     rock-slide:  D b' = P b + Q a          D = J + s r,  P = 2 r (omega c),  Q = r (omega c)' + N (c - nu s)
///
/// with r = s + nu c. The second one follows from J omega' = -N r with N = G g + (omega s)'. With v' = -G beta - nu N +
/// (omega c)'
/// the slip rate changes by dv = dv(0) + [(c - nu s) a]' - [(c - nu s) a]'(0): no series is needed for it.
/// Slide: dv is constant. The mirrored frame has the same matrices.
/// Source: the equations of lib/docs/model.md, section 2.
namespace rocking::dynamics {

/// Coefficient series of the equation of a and b.
template <base::Lane Real>
struct VariationCoefficients {
  using Row = typename MotionSeries<Real>::Row;
  Row stiffness;  ///< K or Q
  Row damping;    ///< P; rock-slide only
  Row inertia;    ///< D; rock-slide only
};

/// A solution of it.
template <base::Lane Real>
struct VariationSeries {
  using Row = typename MotionSeries<Real>::Row;
  Row tilt;       ///< a, to one order more than the step's
  Row tilt_rate;  ///< b
};

namespace kernel {

template <int k, bool vertical, base::Lane Real, BlockForm form>
inline void extend_rock_coefficients(const MotionSeries<Real>& m, const EquationConstants<Real, form>& constants,
                                     VariationCoefficients<Real>& of) {
  const Real pull = product<k>(m.base.data(), m.sine.data());
  if constexpr (vertical) {
    of.stiffness[k] = constants.geared(pull + product<k>(m.weight.data(), m.cosine.data()));
  } else {
    of.stiffness[k] = constants.geared(pull + m.cosine[k]);
  }
}

}  // namespace kernel

/// Rock: K, to one order less than the step's.
template <int order, bool vertical, base::Lane Real, BlockForm form>
inline void expand_rock_variation(const MotionSeries<Real>& m, const EquationConstants<Real, form>& constants,
                                  VariationCoefficients<Real>& of) {
  kernel::repeat<order>([&](auto index) { kernel::extend_rock_coefficients<index, vertical>(m, constants, of); });
}

/// Rock-slide: P, Q, D, to one order less than the step's.
template <int order, base::Lane Real, BlockForm form>
inline void expand_rock_slide_variation(const MotionSeries<Real>& m, const EquationConstants<Real, form>& constants,
                                        const Real& drag, VariationCoefficients<Real>& of) {
  using namespace kernel;
  typename MotionSeries<Real>::Row acceleration;  // (omega c)'
  typename MotionSeries<Real>::Row lever;         // c - nu s
  repeat<order>([&](auto index) {
    constexpr int k = index;
    acceleration[k] = Real(k + 1) * m.rate_cosine[k + 1];
    lever[k] = m.cosine[k] - drag * m.sine[k];
    of.inertia[k] = product<k>(m.sine.data(), m.arm.data());
    if constexpr (k == 0) of.inertia[0] = of.inertia[0] + constants.inertia;
    of.damping[k] = Real(2.0) * product<k>(m.arm.data(), m.rate_cosine.data());
    of.stiffness[k] = product<k>(m.arm.data(), acceleration.data()) + product<k>(m.normal.data(), lever.data());
  });
}

/// Rock: from tilt[0], tilt_rate[0] to the solution, to `order`.
template <int order, base::Lane Real>
inline void solve_rock_variation(const VariationCoefficients<Real>& of, VariationSeries<Real>& m) {
  using namespace kernel;
  repeat<order>([&](auto index) {
    constexpr int k = index;
    m.tilt[k + 1] = m.tilt_rate[k] * Real(over<k + 1>);
    m.tilt_rate[k + 1] = product<k>(of.stiffness.data(), m.tilt.data()) * Real(over<k + 1>);
  });
  m.tilt[order + 1] = m.tilt_rate[order] * Real(over<order + 1>);
}

/// Rock-slide: the same.
template <int order, base::Lane Real>
inline void solve_rock_slide_variation(const VariationCoefficients<Real>& of, VariationSeries<Real>& m) {
  using namespace kernel;
  typename VariationSeries<Real>::Row slope;  // b'
  const Real over_inertia = Real(1.0) / of.inertia[0];
  repeat<order>([&](auto index) {
    constexpr int k = index;
    m.tilt[k + 1] = m.tilt_rate[k] * Real(over<k + 1>);
    const Real forces = product<k>(of.damping.data(), m.tilt_rate.data()) +
                        product<k>(of.stiffness.data(), m.tilt.data()) -
                        product_but_newest<k>(slope.data(), of.inertia.data());
    slope[k] = forces * over_inertia;
    m.tilt_rate[k + 1] = slope[k] * Real(over<k + 1>);
  });
  m.tilt[order + 1] = m.tilt_rate[order] * Real(over<order + 1>);
}

/// How the slip part of tangent vectors changes from the start of a step to an instant within it. In fixed axes and in
/// the side frame alike.
template <base::Lane Real>
struct SlipVariation {
  Real duration;
  // 0 without rocking and slipping.
  Real lever_at_start = Real(0.0);  ///< c - nu s
  Real lever_now = Real(0.0);
  Real swing_at_start = Real(0.0);  ///< its rate of change, omega (s + nu c)
  Real swing_now = Real(0.0);

  /// The vector now, from that at the start and its changes of theta and w now.
  [[nodiscard]] Tangent<Real> apply(const Tangent<Real>& start, const Real& tilt, const Real& tilt_rate) const {
    const Real pull_at_start = lever_at_start * start.tilt_rate + swing_at_start * start.tilt;
    const Real slip_rate = start.slip_rate - pull_at_start;
    return {.tilt = tilt,
            .tilt_rate = tilt_rate,
            .slip = start.slip + duration * slip_rate + (lever_now * tilt - lever_at_start * start.tilt),
            .slip_rate = slip_rate + (lever_now * tilt_rate + swing_now * tilt)};
  }
};

}  // namespace rocking::dynamics
