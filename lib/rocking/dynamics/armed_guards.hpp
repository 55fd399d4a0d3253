#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/guards.hpp"
#include "rocking/dynamics/known_at_start.hpp"

namespace rocking::dynamics {

/// Which guards of one motion are armed over the coming step, and the numbers that occur in them. The lanes'
/// counterpart is lanes::OrdinaryGuards.
struct ArmedGuards {
  const State& state;
  const Setting& setting;
  const KnownAtStart& known;
  int order;             ///< of the series
  double side;           ///< sign of the frame of the series
  double mu_s;           ///< static friction in force
  bool is_past_balance;  ///< abs(Theta) has been 1 before
  bool off_ground;       ///< N <= 0
  bool has_friction;
  bool vertical;  ///< the base moves vertically
  bool determinant_can_vanish;
  std::optional<double> cell_end;  ///< X of the end of the cell of a slipping block; absent: friction has no cells
  OutOfReach<bool> out_of_reach;

  /// Whether the coming step of a rocking block needs nothing but the guards of lanes::OrdinaryGuards, and nothing is
  /// known of it but the state.
  [[nodiscard]] bool is_ordinary() const {
    const bool is_flat = state.tilt == 0.0 && state.tilt_rate == 0.0;
    return is_rocking(state.contact) && known == KnownAtStart{} && !is_flat && !is_past_balance && !off_ground &&
           !determinant_may_vanish() && !cell_end;
  }

  [[nodiscard]] static bool in_reach() { return false; }
  [[nodiscard]] bool past_balance_out_of_reach() const { return out_of_reach.past_balance; }
  [[nodiscard]] bool normal_out_of_reach() const { return out_of_reach.normal; }
  [[nodiscard]] static std::size_t no_zeros() { return 0; }
  [[nodiscard]] std::size_t tilt_zeros() const {
    if (state.tilt != 0.0) return 0;
    if (state.tilt_rate != 0.0) return 1;
    return known.lift_is_flat ? 3 : 2;
  }
  [[nodiscard]] std::size_t slip_zeros() const {
    if (state.slip_rate != 0.0) return 0;
    return known.slip_is_flat ? 2 : 1;
  }
  [[nodiscard]] std::size_t normal_zeros() const { return known.normal_is_zero ? 1 : 0; }
  [[nodiscard]] std::size_t inward_zeros() const { return known.limit_sign > 0.0 ? 1 : 0; }
  [[nodiscard]] std::size_t outward_zeros() const { return known.limit_sign < 0.0 ? 1 : 0; }
  [[nodiscard]] bool was_past_balance() const { return is_past_balance; }
  [[nodiscard]] bool slips() const { return is_sliding(state.contact); }
  [[nodiscard]] bool tests_friction() const {
    return !slips() && has_friction && !off_ground && !known.sticks_beyond_friction;
  }
  /// A block that sticks off the ground slips as soon as it would press on the base then (model.md, 3). With another
  /// inertia than the centroidal one that does not follow.
  [[nodiscard]] bool waits_for_contact() const {
    return state.contact == ContactState::rock && has_friction && off_ground && !known.sticks_beyond_friction &&
           setting.inertia == setting.block.inertia;
  }
  /// A block that lifts at its threshold and is off the ground has g = 0 then: nothing pushes it sideways.
  [[nodiscard]] std::size_t waiting_zeros() const { return known.lift_is_flat ? 1 : 0; }
  [[nodiscard]] bool determinant_may_vanish() const { return slips() && determinant_can_vanish; }
  [[nodiscard]] double shape_angle() const { return setting.block.edge(state.side).shape_angle; }
  [[nodiscard]] double inertia() const { return setting.inertia; }
  [[nodiscard]] double load() const { return setting.block.load; }
  [[nodiscard]] double slip_sign() const { return side * state.slip_direction; }
  [[nodiscard]] double static_friction() const { return mu_s; }
  [[nodiscard]] double seen_from_ground(double normal) const { return off_ground ? -normal : normal; }
};

/// As for_each_rocking_guard, for a block in full contact, where N = G (1 + alpha_v).
template <class Visitor>
void for_each_full_contact_guard(const MotionSeries<double>& m, const ArmedGuards& armed, std::size_t order,
                                 Visitor&& visit) {
  const auto row = [order](Guard guard, std::size_t zeros) {
    return GuardRow<bool, std::size_t, std::size_t>{
        .guard = guard, .out_of_reach = false, .length = order + 1, .zeros = zeros};
  };
  if (armed.state.contact == ContactState::rest) {
    for (const double push : {1.0, -1.0}) {  // the sign of the base acceleration at the event, and the side then
      if (push * armed.setting.block.open_side < 0.0) continue;
      const Edge& edge = armed.setting.block.edge(push);
      const bool slides_first = armed.mu_s <= edge.tangent;
      const double threshold = slides_first ? armed.mu_s : edge.sine;
      const double lever = push * (armed.side * (slides_first ? 1.0 : edge.cosine));
      visit(row(push > 0.0 ? Guard::leave_right : Guard::leave_left, 0), [&](std::size_t k) {
        const double hold = armed.vertical ? threshold * m.weight[k] : k == 0 ? threshold : 0.0;
        return hold - lever * m.base[k];
      });
    }
  }
  if (armed.slips()) {
    visit(row(Guard::slip, armed.slip_zeros()), [&](std::size_t k) { return armed.slip_sign() * m.slip_rate[k]; });
  }
  if (armed.vertical) {
    visit(row(Guard::normal, armed.normal_zeros()), [&](std::size_t k) { return armed.seen_from_ground(m.weight[k]); });
  }
}

/// Calls visit(number, coefficients) for each guard that is armed and wanted(number). The zeros that are known at the
/// start of the step are divided out: with a tolerance in their place false events would be found, or true ones missed.
/// All polynomials have the same number of coefficients, the last ones 0 where the guard's degree is lower, as in the
/// lanes.
template <class Wanted, class Visitor>
void visit_guards(const ArmedGuards& armed, const MotionSeries<double>& m, Wanted&& wanted, Visitor&& visit) {
  constexpr std::size_t most_zeros = 3;
  std::array<double, full_order + 2 + most_zeros> guard{};
  const auto order = static_cast<std::size_t>(armed.order);
  const std::size_t length = order + 2;
  const auto visit_row = [&](const GuardRow<bool, std::size_t, std::size_t>& row, auto&& coefficient) {
    const auto number = static_cast<std::size_t>(row.guard);
    if (row.out_of_reach || !wanted(number)) return;
    for (std::size_t k = row.zeros; k < row.length; ++k) guard[k] = coefficient(k);
    std::fill(guard.begin() + static_cast<std::ptrdiff_t>(row.length), guard.end(), 0.0);
    visit(number, std::span<const double>(guard.data() + row.zeros, length));
  };
  if (armed.cell_end) {
    const double start = armed.state.slip_direction * *armed.cell_end;
    visit_row(
        GuardRow<bool, std::size_t, std::size_t>{
            .guard = Guard::cell, .out_of_reach = false, .length = length, .zeros = 0},
        [&](std::size_t k) { return (k == 0 ? start : 0.0) - armed.slip_sign() * m.slip[k]; });
  }
  if (armed.waits_for_contact()) {
    const double load = armed.setting.block.load;
    visit_row(
        GuardRow<bool, std::size_t, std::size_t>{
            .guard = Guard::slip_presses, .out_of_reach = false, .length = order + 1, .zeros = armed.waiting_zeros()},
        [&](std::size_t k) {
          double sum = -load * (armed.vertical ? m.weight[k] : k == 0 ? 1.0 : 0.0);
          for (std::size_t i = 0; i <= k; ++i) sum += m.tilt_rate[i] * m.rate_cosine[k - i];
          return sum;
        });
  }
  switch (armed.state.contact) {
    case ContactState::rest:
    case ContactState::slide: return for_each_full_contact_guard(m, armed, order, visit_row);
    case ContactState::rock:
    case ContactState::rock_slide: return for_each_rocking_guard(m, armed, order, visit_row);
    case ContactState::overturned: return;
  }
}

}  // namespace rocking::dynamics
