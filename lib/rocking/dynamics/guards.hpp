#pragma once

#include <cstddef>
#include <type_traits>

#include "rocking/base/lane.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/motion_series.hpp"

namespace rocking::dynamics {

/// Functions of the motion that stay >= 0 until an event. In the side frame, so that the two signs of a mirrored pair
/// have different names.
enum class Guard : std::size_t {
  overturn,          ///< pi/2 - S theta
  determinant,       ///< D, where friction is large enough for it to vanish
  tilt,              ///< S theta
  slip,              ///< V times the direction of slip
  friction_inward,   ///< mu_s N - S F
  friction_outward,  ///< mu_s N + S F
  leave_right,       ///< full contact: mu_s (1 + alpha_v) - alpha, or s (1 + alpha_v) - alpha c
  leave_left,        ///< the same with + alpha
  past_balance,      ///< psi - S theta, until the first time
  normal,            ///< N on the ground, -N off it
  cell,              ///< friction of the place: the way to the end of the cell, in the direction of slip
  slip_presses,      ///< off the ground: w^2 c - G g, below 0 where the block would press on the base if it slipped
};

inline constexpr std::size_t guard_count = 12;

/// A number of coefficients that is known to the compiler.
template <std::size_t count>
using Count = std::integral_constant<std::size_t, count>;

/// `more` than a number of coefficients, known to the compiler if that is.
template <std::size_t more, std::size_t count>
[[nodiscard]] constexpr Count<count + more> plus(Count<count>) {
  return {};
}
template <std::size_t more>
[[nodiscard]] constexpr std::size_t plus(std::size_t count) {
  return count + more;
}

/// A guard's polynomial over the coming step, but for its coefficients. What stands for "out of reach" and "zeros"
/// depends on the number type: truths for a pack of lanes, a bool and a count for one motion.
template <class OutOfReach, class Length, class Zeros>
struct GuardRow {
  Guard guard;
  OutOfReach out_of_reach;  ///< it cannot fire over the step
  Length length;            ///< number of coefficients; the rest are 0
  Zeros zeros;              ///< the first ones that are known to be 0
};

/// Calls visit(row, coefficient) for each armed guard of a rocking block; coefficient(k) is that of x^k in the guard's
/// polynomial.
///
/// Written once for one motion and for packs. `Armed` says which guards are armed; where the answer is the same for all
/// lanes of a pack, it is a compile-time constant. `order` is that of the series, as a Count or a number.
template <base::Lane Real, class Armed, class Order, class Visitor>
inline void for_each_rocking_guard(const MotionSeries<Real>& m, const Armed& armed, Order order, Visitor&& visit) {
  constexpr double half_pi = 0x1.921fb54442d18p+0;
  const auto row = [](Guard guard, auto out_of_reach, auto length, auto zeros) {
    return GuardRow<decltype(out_of_reach), decltype(length), decltype(zeros)>{guard, out_of_reach, length, zeros};
  };
  const auto below = [&m](const Real& limit) {
    return [&m, limit](std::size_t k) { return k == 0 ? limit - m.tilt[k] : -m.tilt[k]; };
  };
  visit(row(Guard::tilt, armed.in_reach(), plus<2>(order), armed.tilt_zeros()),
        [&](std::size_t k) { return m.tilt[k]; });
  if (armed.was_past_balance()) {
    visit(row(Guard::overturn, armed.in_reach(), plus<2>(order), armed.no_zeros()), below(Real(half_pi)));
  } else {
    visit(row(Guard::past_balance, armed.past_balance_out_of_reach(), plus<2>(order), armed.no_zeros()),
          below(armed.shape_angle()));
  }
  visit(row(Guard::normal, armed.normal_out_of_reach(), order, armed.normal_zeros()),
        [&](std::size_t k) { return armed.seen_from_ground(m.normal[k]); });
  if (armed.slips()) {
    const Real sign = armed.slip_sign();
    visit(row(Guard::slip, armed.in_reach(), plus<1>(order), armed.slip_zeros()),
          [&, sign](std::size_t k) { return sign * m.slip_rate[k]; });
  }
  if (armed.tests_friction()) {
    const Real mu_s = armed.static_friction();
    const auto friction = [&m, load = Real(armed.load())](std::size_t k) {
      return load * m.base[k] - Real(static_cast<double>(k + 1)) * m.rate_cosine[k + 1];
    };
    visit(row(Guard::friction_inward, armed.in_reach(), order, armed.inward_zeros()),
          [&, mu_s](std::size_t k) { return mu_s * m.normal[k] - friction(k); });
    visit(row(Guard::friction_outward, armed.in_reach(), order, armed.outward_zeros()),
          [&, mu_s](std::size_t k) { return mu_s * m.normal[k] + friction(k); });
  }
  if (armed.determinant_may_vanish()) {
    visit(row(Guard::determinant, armed.in_reach(), plus<1>(order), armed.no_zeros()), [&](std::size_t k) {
      Real sum = k == 0 ? armed.inertia() : Real(0.0);
      for (std::size_t i = 0; i <= k; ++i) sum = sum + m.sine[i] * m.arm[k - i];
      return sum;
    });
  }
}

}  // namespace rocking::dynamics
