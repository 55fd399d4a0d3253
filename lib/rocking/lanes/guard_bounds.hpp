#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>

#include "rocking/integrate/zero_crossing.hpp"
#include "rocking/lanes/ordinary_guards.hpp"

namespace rocking::lanes {
namespace {

/// The guards of the coming step of the lanes that may cross zero: those that an inexpensive bound does not clear.
template <class Form>
struct UnclearedGuards {
  using Truth = typename Form::Truth;

  Truth occupied;                         ///< lanes that have a run
  std::array<Truth, Form::guards> lanes;  ///< by guard, the lanes in which it is uncleared
  Truth any;                              ///< lanes with such a guard

  [[nodiscard]] int lane_count() const { return std::popcount(bits_of(any)); }
  /// Whether there are lanes without such a guard.
  [[nodiscard]] bool has_others() const { return bits_of(occupied && !any) != 0; }
};

/// Lower bound of the guard's polynomial over the step, without its first coefficient where that is known to be 0;
/// computed as in integrate::is_clearly_positive.
template <class Real, std::size_t count, class Zero, class Coefficient>
[[nodiscard]] inline Real lower_bound(const Real& length, dynamics::Count<count>, const Zero& starts_at_zero,
                                      Coefficient coefficient) {
  using base::fused, base::select;
  Real rest(0.0);
#pragma GCC unroll 20
  for (std::size_t k = count - 1; k > 1; --k) rest = integrate::bound_below(rest, coefficient(k), length);
  const Real second = coefficient(1);
  const Real whole = fused(integrate::bound_below(rest, second, length), length, coefficient(0));
  if constexpr (std::is_same_v<Zero, NeverZero>) {
    return whole;
  } else {
    return select(starts_at_zero, fused(rest, length, second), whole);
  }
}

template <class Truth>
[[nodiscard]] inline Truth in_reach_of(const Truth& occupied, const InReach&) {
  return occupied;
}
template <class Truth>
[[nodiscard]] inline Truth in_reach_of(const Truth& occupied, const Truth& out_of_reach) {
  return occupied && !out_of_reach;
}

/// Evaluates the bound of each guard.
template <class Form, class Real = typename Form::Real>
[[gnu::noinline, gnu::flatten]] void find_uncleared(const LaneAccess<Real>& lanes, const Step<Form>& step,
                                                    UnclearedGuards<Form>& guards) {
  guards.occupied = lanes.load(lanes.state.occupied) == Real(1.0);
  std::size_t i = 0;
  for_each_guard(lanes, step, [&](const auto& row, auto coefficient) {
    auto& uncleared = guards.lanes[i++];
    uncleared = in_reach_of(guards.occupied, row.out_of_reach);
    if (bits_of(uncleared) == 0) return;
    uncleared = uncleared && !(Real(0.0) < lower_bound(step.length, row.length, row.zeros, coefficient));
  });
  guards.any = guards.lanes[0];
  for (const auto& uncleared : guards.lanes) guards.any = guards.any || uncleared;
}

}  // namespace
}  // namespace rocking::lanes
