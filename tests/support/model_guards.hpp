#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/block_motion.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/guards.hpp"

namespace rocking::support {

/// Quantities besides the state on which the guards of a smooth piece of motion depend.
struct Circumstances {
  dynamics::Geometry block;
  double inertia;          ///< J
  double static_friction;  ///< mu_s in force
  double kinetic_friction;
  bool tests_friction;  ///< whether sticking can fail
  bool was_past_balance;
  bool waits_for_contact;  ///< sticks off the ground until it would press on the base if it slipped
  bool off_ground;
  bool vertical;                   ///< the base moves vertically
  std::optional<double> cell_end;  ///< X at which a slipping block finds other friction; absent: nowhere
};

/// Calls visit(guard, value) for each guard that lib/docs/model.md requires, computed from its equations at a state:
/// without series, without known zeros, without omission of distant guards.
template <class Visit>
void for_each_model_guard(const Circumstances& now, const dynamics::State& state, const dynamics::BaseMotion& base,
                          Visit&& visit) {
  using dynamics::ContactState, dynamics::Guard;
  const double ground = now.off_ground ? -1.0 : 1.0;
  const auto [alpha, weight] = base;
  const double mu_s = now.static_friction;
  if (state.contact == ContactState::rest) {
    const bool slides_first = mu_s <= now.block.tangent;
    const double holds = (slides_first ? mu_s : now.block.sine) * weight;
    const double pull = (slides_first ? 1.0 : now.block.cosine) * alpha;
    visit(Guard::leave_right, holds - pull);
    visit(Guard::leave_left, holds + pull);
  }
  const bool slips = state.contact == ContactState::slide || state.contact == ContactState::rock_slide;
  if (slips) visit(Guard::slip, state.slip_direction * state.slip_rate);
  if (slips && now.cell_end) visit(Guard::cell, state.slip_direction * (*now.cell_end - state.slip));
  if (state.contact == ContactState::rest || state.contact == ContactState::slide) {
    if (now.vertical) visit(Guard::normal, ground * weight);
    return;
  }
  const double side = state.side;
  const double tilt = side * state.tilt;
  const double sine = std::sin(now.block.shape_angle - tilt);
  const double cosine = std::cos(now.block.shape_angle - tilt);
  const double square = state.tilt_rate * state.tilt_rate;
  const double pressed = 4.0 / 3.0 * weight;  // G
  visit(Guard::tilt, tilt);
  if (now.was_past_balance) visit(Guard::overturn, 0.5 * std::numbers::pi - tilt);
  if (!now.was_past_balance) visit(Guard::past_balance, now.block.shape_angle - tilt);
  double acceleration = -side * weight * sine + alpha * cosine;
  if (slips) {
    const double q = side * sine + state.slip_direction * now.kinetic_friction * cosine;
    const double determinant = now.inertia + side * sine * q;
    acceleration = -(pressed - square * cosine) * q / determinant;
    visit(Guard::determinant, determinant);
  }
  const double normal = pressed + side * acceleration * sine - square * cosine;
  visit(Guard::normal, ground * normal);
  if (!slips && now.waits_for_contact) visit(Guard::slip_presses, square * cosine - pressed);
  if (slips || !now.tests_friction) return;
  const double friction = 4.0 / 3.0 * alpha - acceleration * cosine - side * square * sine;
  visit(Guard::friction_inward, mu_s * normal - side * friction);
  visit(Guard::friction_outward, mu_s * normal + side * friction);
}

}  // namespace rocking::support
