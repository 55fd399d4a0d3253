#pragma once

#include <cmath>
#include <cstddef>

#include "rocking/dynamics/guards.hpp"
#include "rocking/dynamics/landing.hpp"
#include "rocking/dynamics/loss_of_contact.hpp"

namespace rocking::dynamics {

/// What an event is a response to.
template <class Fired>
struct Firing {
  const Fired& fired;  ///< which guards, indexed by Guard
  bool at_breakpoint;  ///< friction or the base acceleration jumps at this instant
  bool time_went_on;   ///< since the last event. A guard that fires without that was negative at once: it is no root

  [[nodiscard]] bool has(Guard guard) const { return fired[static_cast<std::size_t>(guard)]; }
};

/// The hybrid automaton: the reset map, which says what follows at an instant from the guards that have fired, and what
/// of the past it depends on. It knows no integrator. Every rule is in lib/docs/model.md, section 3.
class Automaton {
 public:
  explicit Automaton(bool begins_past_balance) : was_past_balance_(begins_past_balance) {}

  [[nodiscard]] bool was_past_balance() const { return was_past_balance_; }  ///< abs(Theta) has been 1 before
  [[nodiscard]] const LossOfContact& contact() const { return contact_; }
  [[nodiscard]] bool is_off_ground() const { return contact_.is_off_ground(); }  ///< N <= 0

  /// The reset map. Of simultaneous guards, an impact or the end of slip comes first: it makes the forces jump, and the
  /// other guards are evaluated again after it.
  template <CoefficientSource Coefficients, class Fired>
  void respond(MotionContext<Coefficients>& context, const Firing<Fired>& firing) {
    const double side = context.state.side;
    if (firing.has(Guard::overturn)) return overturn(context);
    if (firing.has(Guard::determinant)) return context.end(Termination::painleve);
    const bool at_threshold = firing.time_went_on;
    // A block that has just lifted has not moved yet if time has not gone on: friction decides first how the motion
    // starts.
    const bool has_just_lifted =
        !firing.time_went_on && (firing.has(Guard::friction_inward) || firing.has(Guard::friction_outward));
    if (firing.has(Guard::tilt) && !has_just_lifted) {
      land(context, firing.has(Guard::slip));
    } else if (firing.has(Guard::slip)) {
      stop_slipping(context);
    } else if (firing.has(Guard::friction_inward)) {
      start_slipping(context, -side, at_threshold);
    } else if (firing.has(Guard::friction_outward)) {
      start_slipping(context, side, at_threshold);
    } else if (firing.has(Guard::leave_right) || firing.has(Guard::leave_left)) {
      leave_full_contact(context, firing.has(Guard::leave_right) ? 1.0 : -1.0, at_threshold);
      // N = G (1 + alpha_v) = 0 in full contact: it is 0 in the new contact state too.
      if (firing.has(Guard::normal) && !firing.at_breakpoint) cross_normal(context);
    } else if (firing.has(Guard::cell)) {
      context.enter_next_cell();
      check_contact(context);
    } else if (firing.at_breakpoint) {
      check_contact(context);
    } else if (firing.has(Guard::normal)) {
      if (is_off_ground() || !slips_rather_than_lose_contact(context)) cross_normal(context);
    } else if (firing.has(Guard::slip_presses)) {
      press_by_slipping(context, at_threshold);
    }
    if (firing.has(Guard::past_balance)) pass_balance(context);
  }

  template <CoefficientSource Coefficients>
  void set_off_ground(const MotionContext<Coefficients>& context, bool off_ground) {
    contact_.set(off_ground, context.clock.tau(), is_beyond_balance(context));
  }

  /// To be called at the end of each step in which abs(Theta) may have come back to 1.
  template <CoefficientSource Coefficients>
  void note_balance(const MotionContext<Coefficients>& context) {
    if (contact_.since_balance() > 0 && !is_beyond_balance(context)) contact_.return_within_balance();
  }

 private:
  template <CoefficientSource Coefficients>
  [[nodiscard]] static bool is_beyond_balance(const MotionContext<Coefficients>& context) {
    return std::abs(context.state.tilt) > context.setting.block.edge(context.state.side).shape_angle;
  }

  template <CoefficientSource Coefficients>
  static void overturn(MotionContext<Coefficients>& context) {
    context.state.contact = ContactState::overturned;
    context.end(Termination::overturned);
    context.record(EventKind::overturn);
  }

  template <CoefficientSource Coefficients>
  void pass_balance(MotionContext<Coefficients>& context) {
    was_past_balance_ = true;
    context.record(EventKind::past_balance);
    if (context.setting.ends_at_balance) context.end(Termination::overturned);
  }

  /// A block that sticks off the ground would press on the base, if it slipped, from now on.
  template <CoefficientSource Coefficients>
  void press_by_slipping(MotionContext<Coefficients>& context, bool at_threshold) {
    start_slipping(context, -sign(sticking_forces(context).friction), false);
    if (!at_threshold || !context.slips()) return;
    set_off_ground(context, false);
    context.known.normal_is_zero = true;
  }

  /// N has become 0.
  template <CoefficientSource Coefficients>
  void cross_normal(MotionContext<Coefficients>& context) {
    set_off_ground(context, !is_off_ground());
    context.known.normal_is_zero = true;
    if (!is_off_ground()) press_again(context);
  }

  bool was_past_balance_;
  LossOfContact contact_;
};

}  // namespace rocking::dynamics
