#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

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
};

/// The hybrid automaton: the initial contact state, and the reset map, which says what follows at an instant from the
/// guards that have fired. It knows no integrator. Every rule is in lib/docs/model.md, section 3.
template <CoefficientSource Coefficients>
class Automaton : public Landing<Coefficients> {
 protected:
  using Base = Landing<Coefficients>;
  using Base::setting_, Base::state_, Base::known_, Base::sign;

 public:
  using Base::Base;

  [[nodiscard]] const KnownAtStart& known_at_start() const { return known_; }
  [[nodiscard]] bool was_past_balance() const { return was_past_balance_; }
  [[nodiscard]] bool is_off_ground() const { return contact_.is_off_ground(); }  ///< N <= 0
  [[nodiscard]] std::uint64_t losses_of_contact() const { return contact_.losses(); }
  /// Of these, the losses before the final fall. That fall begins when abs(Theta) exceeds 1 for the last time in a
  /// motion that overturns; a loss of contact in it cannot change what follows any more.
  [[nodiscard]] std::uint64_t losses_before_fall() const {
    const bool has_fallen = this->termination() == Termination::overturned;
    return contact_.losses() - (has_fallen ? contact_.since_balance() : 0);
  }
  [[nodiscard]] double first_loss_of_contact() const { return contact_.first(); }  ///< tau; meaningless without a loss

 protected:
  /// Starts in this state; the contact state follows from the others.
  void enter(const State& initial) {
    state_ = initial;
    this->find_cell();
    was_past_balance_ = std::abs(state_.tilt) >= setting_.block.shape_angle;
    const bool flat = state_.tilt == 0.0 && state_.tilt_rate == 0.0;
    state_.slip_direction = sign(state_.slip_rate);
    state_.side = sign(state_.tilt != 0.0 ? state_.tilt : state_.tilt_rate);
    const bool slips = state_.slip_rate != 0.0;
    state_.contact = flat ? (slips ? ContactState::slide : ContactState::rest)
                          : (slips ? ContactState::rock_slide : ContactState::rock);
    this->check_contact();
  }

  /// The reset map. Of simultaneous guards, an impact or the end of slip comes first: it makes the forces jump, and the
  /// other guards are evaluated again after it.
  template <class Fired>
  void respond(const Firing<Fired>& firing) {
    const auto has_fired = [&firing](Guard guard) { return firing.fired[static_cast<std::size_t>(guard)]; };
    if (has_fired(Guard::overturn)) return overturn();
    if (has_fired(Guard::determinant)) return this->end(Termination::painleve);
    const bool at_threshold = firing.time_went_on;
    // A block that has just lifted has not moved yet if time has not gone on: friction decides first how the motion
    // starts.
    const bool has_just_lifted =
        !firing.time_went_on && (has_fired(Guard::friction_inward) || has_fired(Guard::friction_outward));
    if (has_fired(Guard::tilt) && !has_just_lifted) {
      this->land(has_fired(Guard::slip));
    } else if (has_fired(Guard::slip)) {
      this->stop_slipping();
    } else if (has_fired(Guard::friction_inward)) {
      this->start_slipping(-state_.side, at_threshold);
    } else if (has_fired(Guard::friction_outward)) {
      this->start_slipping(state_.side, at_threshold);
    } else if (has_fired(Guard::leave_right) || has_fired(Guard::leave_left)) {
      this->leave_full_contact(has_fired(Guard::leave_right) ? 1.0 : -1.0, at_threshold);
      // N = (4/3)(1 + alpha_v) = 0 in full contact: it is 0 in the new contact state too.
      if (has_fired(Guard::normal) && !firing.at_breakpoint) cross_normal();
    } else if (has_fired(Guard::cell)) {
      this->enter_next_cell();
      this->check_contact();
    } else if (firing.at_breakpoint) {
      this->check_contact();
    } else if (has_fired(Guard::normal)) {
      if (is_off_ground() || !this->slips_rather_than_lose_contact()) cross_normal();
    }
    if (has_fired(Guard::past_balance)) pass_balance();
  }

  void set_off_ground(bool off_ground) { contact_.set(off_ground, this->clock_.tau(), is_beyond_balance()); }

  /// To be called at the end of each step in which abs(Theta) may have come back to 1.
  void note_balance() {
    if (contact_.since_balance() > 0 && !is_beyond_balance()) contact_.return_within_balance();
  }

 private:
  [[nodiscard]] bool is_beyond_balance() const { return std::abs(state_.tilt) > setting_.block.shape_angle; }

  void overturn() {
    state_.contact = ContactState::overturned;
    this->end(Termination::overturned);
    this->record(EventKind::overturn);
  }

  void pass_balance() {
    was_past_balance_ = true;
    this->record(EventKind::past_balance);
  }

  /// N has become 0.
  void cross_normal() {
    set_off_ground(!is_off_ground());
    known_.normal_is_zero = true;
    if (!is_off_ground()) this->press_again();
  }

  bool was_past_balance_ = false;
  LossOfContact contact_;
};

}  // namespace rocking::dynamics
