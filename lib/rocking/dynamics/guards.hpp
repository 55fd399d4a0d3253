#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/motion_series.hpp"

namespace rocking::dynamics {

/// Functions of the motion that stay >= 0 until something happens. In the side frame, so that the two signs of a mirrored
/// pair have names of their own.
enum class Guard : std::size_t {
  overturn,          ///< pi/2 - S theta
  determinant,       ///< D, where friction is large enough for it to vanish
  tilt,              ///< S theta
  slip,              ///< V times the direction of slip
  friction_inward,   ///< mu_s N - S F
  friction_outward,  ///< mu_s N + S F
  leave_right,       ///< full contact: mu_s (1 + alpha_v) - alpha, or sin(psi) (1 + alpha_v) - alpha cos(psi)
  leave_left,        ///< the same with + alpha
  past_balance,      ///< psi - S theta, until the first time
  normal,            ///< N on the ground, -N off it
};

inline constexpr std::size_t guard_count = 10;

/// Which guards of a block that rocks and sticks cannot fire over a step, whatever its series are.
template <class Truth>
struct OutOfReach {
  Truth past_balance;
  Truth normal;
};

/// Over a step of `length` by a base motion without a vertical one, from a tilt between contact and balance. Until one of the two
/// is reached 0 <= phi <= psi, so that w' = beta c - s lies between -(A + sin(psi)) and A, a bound of abs(beta), and
/// N = 4/3 + w' s - w^2 c is at least 4/3 - (A + sin(psi)) sin(psi) - w^2. A second A length^2/2, and 5/4 for 4/3, leave room
/// for the rounding and the tolerance of the series.
template <base::Lane Real>
[[nodiscard]] auto out_of_reach(Real tilt, Real tilt_rate, Real amplitude, Real length, Real shape_angle, Real sine) {
  using base::fused, base::select;
  const Real zero(0.0);
  const Real most = select(amplitude < zero, -amplitude, amplitude);
  const Real rate = select(tilt_rate < zero, -tilt_rate, tilt_rate);
  using Truth = decltype(tilt < zero);
  const Truth below = fused(fused(most, length, rate), length, tilt) < shape_angle;
  const Real acceleration = most + sine;
  const Real fastest = fused(acceleration, length, rate);
  const Truth presses = zero < fused(-fastest, fastest, fused(-acceleration, sine, Real(1.25)));
  return OutOfReach<Truth>{.past_balance = below, .normal = below && presses};
}

/// What the guards depend on besides the series.
struct GuardContext {
  ContactState contact;
  const Geometry& block;
  int order;               ///< of the series
  double side;             ///< S of the frame of the series
  double static_friction;  ///< mu_s in force
  double inertia;          ///< J
  double slip_sign;        ///< of V in the frame of the series
  std::size_t tilt_zeros;  ///< coefficients of S theta at the start that are known to be 0
  std::size_t slip_zeros;  ///< of V
  double limit_sign;  ///< of S F where the friction that it asks for is known to be at its limit at the start, or 0
  std::size_t normal_zeros;  ///< of N
  bool was_past_balance;
  bool off_ground;
  bool tests_friction;  ///< whether sticking can fail
  bool determinant_may_vanish;
  bool vertical;  ///< the base moves vertically
  OutOfReach<bool> out_of_reach;
};

/// Calls visit(number, coefficients) for each guard that is armed and wanted(number), its known zeros at the start divided
/// out: a tolerance there would find false events or miss true ones. All have as many coefficients, the last of them 0 if need
/// be, so that unlike guards can be looked at side by side (module lanes).
template <class Wanted, class Visitor>
void visit_guards(const GuardContext& context, const MotionSeries<double>& m, Wanted&& wanted, Visitor&& visit) {
  constexpr double half_pi = 0x1.921fb54442d18p+0;
  constexpr std::size_t most_zeros = 3;
  std::array<double, full_order + 2 + most_zeros> guard{};
  const auto order = static_cast<std::size_t>(context.order);
  const std::size_t length = order + 2;
  const auto visit_row = [&](Guard name, std::size_t count, std::size_t zeros, auto&& coefficient) {
    if (!wanted(static_cast<std::size_t>(name))) return;
    for (std::size_t k = zeros; k < count; ++k) guard[k] = coefficient(k);
    std::fill(guard.begin() + static_cast<std::ptrdiff_t>(count), guard.end(), 0.0);
    visit(static_cast<std::size_t>(name), std::span<const double>(guard.data() + zeros, length));
  };
  const auto below = [&](Guard name, double limit, std::size_t count, const auto& row) {
    visit_row(name, count, 0, [&](std::size_t k) { return (k == 0 ? limit : 0.0) - row[k]; });
  };
  const bool rocks = context.contact == ContactState::rock || context.contact == ContactState::rock_slide;
  const bool slips = context.contact == ContactState::slide || context.contact == ContactState::rock_slide;

  if (context.contact == ContactState::rest) {
    const bool slides_first = context.static_friction <= context.block.tangent;
    const double threshold = slides_first ? context.static_friction : context.block.sine;
    const double lever = context.side * (slides_first ? 1.0 : context.block.cosine);
    const auto hold = [&](std::size_t k) {
      if (context.vertical) return threshold * m.weight[k];
      return k == 0 ? threshold : 0.0;
    };
    visit_row(Guard::leave_right, order + 1, 0, [&](std::size_t k) { return hold(k) - lever * m.base[k]; });
    visit_row(Guard::leave_left, order + 1, 0, [&](std::size_t k) { return hold(k) + lever * m.base[k]; });
  }
  if (slips) {
    visit_row(Guard::slip, order + 1, context.slip_zeros,
              [&](std::size_t k) { return context.slip_sign * m.slip_rate[k]; });
  }
  const double ground = context.off_ground ? -1.0 : 1.0;
  if (!rocks) {
    if (!context.vertical || context.contact == ContactState::overturned) return;
    visit_row(Guard::normal, order + 1, context.normal_zeros,
              [&](std::size_t k) { return ground * m.weight[k]; });  // N = (4/3)(1 + alpha_v)
    return;
  }
  visit_row(Guard::tilt, order + 2, context.tilt_zeros, [&](std::size_t k) { return m.tilt[k]; });
  if (context.was_past_balance) {
    below(Guard::overturn, half_pi, order + 2, m.tilt);
  } else if (!context.out_of_reach.past_balance) {
    below(Guard::past_balance, context.block.shape_angle, order + 2, m.tilt);
  }
  if (!context.out_of_reach.normal) {
    visit_row(Guard::normal, order, context.normal_zeros, [&](std::size_t k) { return ground * m.normal[k]; });
  }
  if (!slips && context.tests_friction) {
    const auto friction = [&m](std::size_t k) {
      return 4.0 / 3.0 * m.base[k] - static_cast<double>(k + 1) * m.rate_cosine[k + 1];
    };
    const double mu_s = context.static_friction;
    const std::size_t zeros_inward = context.limit_sign > 0.0 ? 1U : 0U;
    const std::size_t zeros_outward = context.limit_sign < 0.0 ? 1U : 0U;
    visit_row(Guard::friction_inward, order, zeros_inward,
              [&](std::size_t k) { return mu_s * m.normal[k] - friction(k); });
    visit_row(Guard::friction_outward, order, zeros_outward,
              [&](std::size_t k) { return mu_s * m.normal[k] + friction(k); });
  }
  if (slips && context.determinant_may_vanish) {
    visit_row(Guard::determinant, order + 1, 0, [&](std::size_t k) {
      double sum = k == 0 ? context.inertia : 0.0;
      for (std::size_t i = 0; i <= k; ++i) sum += m.sine[i] * m.arm[k - i];
      return sum;
    });
  }
}

}  // namespace rocking::dynamics
