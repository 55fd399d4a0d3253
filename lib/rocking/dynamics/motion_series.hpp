#pragma once

#include <array>
#include <cstdint>

#include "rocking/base/lane.hpp"
#include "rocking/dynamics/series_products.hpp"
#include "rocking/dynamics/setting.hpp"

/// Taylor series of the block's motion about an instant: the stepping kernel.
///
/// All quantities are seen from the side on which the block stands (the side frame): a block rocking about its right
/// edge is the mirror image of one rocking about its left edge. With S the side, beta = S alpha, omega = S w, v = S V
/// and phi = psi - S theta, the levers s = r sin(phi), c = r cos(phi) of the edge (r = 1 for a rectangle) obey
///
///     s' = -omega c        c' = omega s        (S theta)' = omega
///
/// and the contact forces over m R p^2 are
///
///     N = G g + c''          S F = G beta + v' + s''          g = 1 + alpha_v,  G = 1 + J (4/3 for a rectangle)
///
/// rock:        omega' = K (-g s + beta c),  K = (1 + J)/(J + r^2) (1 for a rectangle)
/// rock-slide:  J omega' = -N a,  a = s + nu c,  nu = S s_slip mu_k;   v' = -G beta - nu N - s''
///
/// Both need the same three products of series. N contains c'' and hence omega'; solving for omega' needs one division
/// by D = J + s a, at the start of the step. `vertical` says whether the base moves vertically: if not, g = 1 and its
/// product with s is not formed.
/// Source: Shenton & Jones (1991), J. Eng. Mech. 117(10) 2286-2306; Jeong & Yang (2012) Eqs. 4-16, with J as the
/// inertia about the centre of mass (lib/docs/model.md).
namespace rocking::dynamics {

inline constexpr int full_order = 14;

/// Order of a step that must end soon; its last terms show whether the order suffices.
inline constexpr int brief_order = 8;
inline constexpr double brief_step = 1.0 / 128.0;  ///< of a period

inline constexpr double least_step = 0x1p-20;           ///< of the clock's resolution
inline constexpr std::int64_t step_budget = 1'000'000;  ///< in a period

/// Coefficients of x^k; all in the side frame.
template <base::Lane Real>
struct MotionSeries {
  using Row = std::array<Real, full_order + 3>;
  Row base;         ///< beta = S alpha, to the order of the step
  Row weight;       ///< g = 1 + alpha_v, only where the base moves vertically
  Row tilt;         ///< S theta, to one order more than the step's
  Row tilt_rate;    ///< omega
  Row sine;         ///< s, to one order more
  Row cosine;       ///< c, to one order more
  Row rate_sine;    ///< omega s = c'
  Row rate_cosine;  ///< omega c = -s'
  Row normal;       ///< N, to one order less
  Row arm;          ///< a = s + nu c, only while slipping
  Row slip_rate;    ///< v
  Row slip;         ///< S X, to one order more
};

/// What holds for a step with slip.
template <base::Lane Real>
struct SlipParameters {
  Real drag;             ///< nu = S s_slip mu_k
  Real first_rate_gate;  ///< 0 where v' is known to vanish at the start of the step, else 1
};

namespace kernel {

/// G g_k: N without the acceleration of the block.
template <int k, bool vertical, base::Lane Real, BlockForm form>
[[nodiscard]] inline Real static_normal(const MotionSeries<Real>& m, const EquationConstants<Real, form>& constants) {
  if constexpr (vertical) {
    return Real(constants.load) * m.weight[k];
  } else {
    return k == 0 ? Real(constants.load) : Real(0.0);
  }
}

/// From omega_k and the products at k: sine, cosine and tilt at k + 1.
template <int k, base::Lane Real>
inline void extend_angle(MotionSeries<Real>& m) {
  m.rate_cosine[k] = product<k>(m.tilt_rate.data(), m.cosine.data());
  m.cosine[k + 1] = m.rate_sine[k] * Real(over<k + 1>);
  m.sine[k + 1] = m.rate_cosine[k] * Real(-over<k + 1>);
  m.tilt[k + 1] = m.tilt_rate[k] * Real(over<k + 1>);
}

}  // namespace kernel

/// The angle of the edge at the start, sine[0] and cosine[0], from tilt[0]. A function of its own, so that the registers
/// need not hold the coefficients of sine and cosine besides those of the series.
template <base::Lane Real, BlockForm form>
inline void begin_angle(MotionSeries<Real>& m, const EquationConstants<Real, form>& constants) {
  const auto angle = edge_angle(m.tilt[0], constants);
  m.sine[0] = angle.sine;
  m.cosine[0] = angle.cosine;
}

/// Rock: from base, weight, tilt[0], tilt_rate[0] and the angle to the motion's series, to `order`.
///
/// `first_rate_gate` is 0 where omega' is known to vanish at the start (a lift at the threshold), else 1.
template <int order, bool vertical, base::Lane Real, BlockForm form>
inline void expand_rock(MotionSeries<Real>& m, [[maybe_unused]] const EquationConstants<Real, form>& constants,
                        Real first_rate_gate) {
  using base::fused;
  using namespace kernel;
  repeat<order>([&](auto index) {
    constexpr int k = index;
    m.rate_sine[k] = product<k>(m.tilt_rate.data(), m.sine.data());
    Real acceleration = product_but_newest<k>(m.cosine.data(), m.base.data());
    if constexpr (k == 0) {  // the expression of forces_without_slip
      const Real restoring = vertical ? m.weight[0] * m.sine[0] : m.sine[0];
      m.tilt_rate[1] = constants.geared(m.base[0] * m.cosine[0] - restoring) * first_rate_gate;
    } else {
      if constexpr (vertical) {
        acceleration = acceleration - product<k>(m.weight.data(), m.sine.data());
      } else {
        acceleration = fused(m.rate_cosine[k - 1], Real(over<k>), acceleration);  // - s_k, from its factors
      }
      m.tilt_rate[k + 1] = fused(m.cosine[k], m.base[0], acceleration) * constants.geared(Real(over<k + 1>));
    }
    extend_angle<k>(m);
  });
  m.rate_sine[order] = product<order>(m.tilt_rate.data(), m.sine.data());
  extend_angle<order>(m);
}

/// Rock: N, after expand_rock.
template <int order, bool vertical, base::Lane Real, BlockForm form>
inline void expand_normal(MotionSeries<Real>& m, const EquationConstants<Real, form>& constants) {
  using base::fused;
  using namespace kernel;
  repeat<order>([&](auto index) {
    constexpr int k = index;
    m.normal[k] = fused(m.rate_sine[k + 1], Real(k + 1), static_normal<k, vertical>(m, constants));
  });
}

/// Rock-slide: from base, weight, tilt[0], tilt_rate[0], slip_rate[0], slip[0] and the angle to all series, to `order`.
///
/// N_k = G g_k + (k + 1) (omega s)_{k+1}, where all is known but the term omega_{k+1} s_0. From omega_k to
/// omega_{k+1} there are three dependent operations; all other products are formed before.
template <int order, bool vertical, base::Lane Real, BlockForm form>
inline void expand_rock_slide(MotionSeries<Real>& m, const EquationConstants<Real, form>& constants,
                              const SlipParameters<Real>& slip) {
  using base::fused;
  using namespace kernel;
  m.arm[0] = fused(slip.drag, m.cosine[0], m.sine[0]);
  m.rate_sine[0] = m.tilt_rate[0] * m.sine[0];
  const Real minus_over_d = Real(-1.0) / fused(m.sine[0], m.arm[0], constants.inertia);
  const Real arm_over_d = m.arm[0] * minus_over_d;
  Real next_arm_over_d;
  repeat<order>([&](auto index) {
    constexpr int k = index;
    extend_angle<k>(m);
    m.arm[k + 1] = fused(slip.drag, m.cosine[k + 1], m.sine[k + 1]);
    if constexpr (k == 0) {  // the expressions of slipping_rates
      const Real known = m.tilt_rate[0] * m.sine[1];
      const Real normal = known + static_normal<0, vertical>(m, constants);
      m.tilt_rate[1] = normal * m.arm[0] * minus_over_d;
      m.rate_sine[1] = fused(m.tilt_rate[1], m.sine[0], known);
      m.normal[0] = fused(m.tilt_rate[1], m.sine[0], normal);
      next_arm_over_d = m.arm[1] * minus_over_d;
    } else {
      const Real oldest = m.tilt_rate[0] * Real(-over<k + 1>);  // times (omega c)_k: omega_0 s_{k+1}, from its factors
      const Real known =
          fused(m.rate_cosine[k], oldest, part_of_product<k + 1, 1, k>(m.tilt_rate.data(), m.sine.data()));
      // The torque without the known part of N_k. Where N_{k-1} = k (omega s)_k, its term is added from its factors.
      constexpr bool is_split = k > 1 && !vertical;
      Real torque = part_of_product < k, 0, is_split ? k - 2 : k - 1 > (m.normal.data(), m.arm.data());
      if constexpr (vertical) torque = fused(static_normal<k, vertical>(m, constants), m.arm[0], torque);
      Real acceleration = torque * (minus_over_d * Real(over<k + 1>));
      if constexpr (is_split)
        acceleration = fused(m.rate_sine[k], next_arm_over_d * Real(k * over<k + 1>), acceleration);
      m.tilt_rate[k + 1] = fused(known, arm_over_d, acceleration);
      m.rate_sine[k + 1] = fused(m.tilt_rate[k + 1], m.sine[0], known);
      m.normal[k] = Real(k + 1) * m.rate_sine[k + 1];
      if constexpr (vertical) m.normal[k] = m.normal[k] + static_normal<k, vertical>(m, constants);
    }
  });
  extend_angle<order>(m);
  repeat<order>([&](auto index) {
    constexpr int k = index;
    const Real force = fused(slip.drag, m.normal[k], Real(constants.load) * m.base[k]);
    m.slip_rate[k + 1] = fused(force, Real(-over<k + 1>), m.rate_cosine[k + 1]);
    if constexpr (k == 0) m.slip_rate[1] = m.slip_rate[1] * slip.first_rate_gate;
    m.slip[k + 1] = m.slip_rate[k] * Real(over<k + 1>);
  });
  m.slip[order + 1] = m.slip_rate[order] * Real(over<order + 1>);
}

/// Slide in full contact: from base, weight, slip_rate[0], slip[0] to the slip's series, to `order`. N = G g.
template <int order, bool vertical, base::Lane Real, BlockForm form>
inline void expand_slide(MotionSeries<Real>& m, const EquationConstants<Real, form>& constants,
                         const SlipParameters<Real>& slip) {
  using base::fused;
  using namespace kernel;
  repeat<order>([&](auto index) {
    constexpr int k = index;
    Real push = m.base[k];
    if constexpr (vertical) {
      push = fused(slip.drag, m.weight[k], push);
    } else if constexpr (k == 0) {
      push = push + slip.drag;
    }
    m.slip_rate[k + 1] = push * (Real(-constants.load) * Real(over<k + 1>));
    if constexpr (k == 0) m.slip_rate[1] = m.slip_rate[1] * slip.first_rate_gate;
    m.slip[k + 1] = m.slip_rate[k] * Real(over<k + 1>);
  });
  m.slip[order + 1] = m.slip_rate[order] * Real(over<order + 1>);
}

}  // namespace rocking::dynamics
