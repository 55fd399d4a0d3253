#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/contact_rules.hpp"
#include "rocking/dynamics/known_at_start.hpp"
#include "rocking/dynamics/observer.hpp"
#include "rocking/dynamics/peaks.hpp"

namespace rocking::dynamics {

/// The changes of the contact state that friction and the base acceleration cause: lift, tip, start and stop of slip.
template <CoefficientSource Coefficients>
class ContactChanges : public ContactRules<Coefficients> {
 protected:
  using Rules = ContactRules<Coefficients>;
  using Rules::coefficients_, Rules::setting_, Rules::state_, Rules::sign;

 public:
  ContactChanges(const Setting& setting, const Clock& clock, const Coefficients& coefficients,
                 const Excitation& excitation, Observer& observer)
      : Rules(setting, clock, coefficients, excitation), observer_(&observer) {}

  [[nodiscard]] std::optional<Termination> termination() const { return termination_; }
  [[nodiscard]] bool ended() const { return termination_.has_value(); }

  /// From now on, reports events and strobe points to `observer`.
  void observe_with(Observer& observer) { observer_ = &observer; }

  /// How often the block stuck although friction does not suffice; see start_slipping.
  [[nodiscard]] std::uint64_t contradictions() const { return contradictions_; }

  /// The largest values so far. Those of a slip in progress are not in them.
  [[nodiscard]] const Peaks& peaks() const { return peaks_; }
  void set_peaks(const TiltPeaks<double>& peaks) {
    peaks_.tilt = peaks.tilt;
    peaks_.tilt_rate = peaks.tilt_rate;
  }
  /// From now on, looks for no peaks.
  void ignore_peaks() { peaks_ = Peaks::unwanted(); }

 protected:
  [[nodiscard]] Observer& observer() const { return *observer_; }
  void record(EventKind kind) { observer_->event(kind, this->clock_.tau(), state_); }
  void end(Termination reason) { termination_ = reason; }
  void go_on() {
    if (termination_ == Termination::reached_horizon) termination_.reset();
  }

  /// Leaves the contact state if it cannot stay: after the start, and wherever friction or the base acceleration jumps.
  void check_contact() {
    switch (state_.contact) {
      case ContactState::rest: return check_full_contact();
      case ContactState::slide: return check_tipping();
      case ContactState::rock: return check_friction();
      case ContactState::rock_slide:
      case ContactState::overturned: return;
    }
  }

  void check_full_contact() {
    if (!this->full_contact_holds()) leave_full_contact(sign(this->base_acceleration()), false);
  }

  void check_tipping() {
    if (this->kinetic_friction_tips()) tip();
  }

  /// Full contact cannot hold. `push`: sign of the base acceleration; `at_threshold`: found as a root, so that nothing
  /// is compared again and the accelerations that vanish at the threshold are exactly 0.
  void leave_full_contact(double push, bool at_threshold) {
    const bool was_sliding = state_.contact == ContactState::slide;
    state_.slip_rate = 0.0;
    state_.side = push;
    const Forces forces = this->sticking_forces();
    if (coefficients_.has_friction()) {
      const double mu_s = coefficients_.static_friction();
      if (mu_s <= setting_.block.tangent) return start_sliding(push, at_threshold, was_sliding);
      if (!this->friction_holds(forces)) {
        if (!this->kinetic_friction_tips()) return start_sliding(push, at_threshold, was_sliding);
        state_.contact = ContactState::rock;
        record(EventKind::lift);
        return start_slipping(-sign(forces.friction), false);
      }
    }
    state_.contact = ContactState::rock;
    known_.lift_is_flat = at_threshold || forces.acceleration == 0.0;
    record(EventKind::lift);
  }

  /// Rocking: friction is exhausted; the block starts to slip in `direction`. `at_threshold`: found as a root.
  ///
  /// Where the slip would be reversed at once, no motion agrees with the equations (this occurs with the inertia about
  /// the edge): the block sticks, and friction is not tested again before the next event.
  void start_slipping(double direction, bool at_threshold) {
    const bool is_full_contact = state_.tilt == 0.0 && state_.tilt_rate == 0.0;
    if (is_full_contact && !this->kinetic_friction_tips()) return start_sliding(-direction, at_threshold, false);
    // With the centroidal inertia s V' >= c (abs(F) - mu_s N) for some c > 0: a value that is not > 0 is 0 up to
    // rounding.
    const bool lasts = this->slip_would_last(direction);
    const bool starts_flat = this->is_centroidal() && (!lasts || (at_threshold && this->kinetic_equals_static()));
    if (!starts_flat && !lasts) return stick_beyond_friction();
    state_.contact = ContactState::rock_slide;
    state_.slip_direction = direction;
    known_.slip_is_flat = starts_flat;
    record(EventKind::slip_start);
  }

  /// V may have changed its sign: abs(X) is largest where it does, or at the end of the motion.
  void note_slip() { peaks_.slip = peaks::larger(peaks_.slip, std::abs(state_.slip)); }

  /// V has become 0.
  void stop_slipping() {
    state_.slip_rate = 0.0;
    note_slip();
    coefficients_.stop();
    if (state_.contact == ContactState::slide) return stop_sliding();
    const Forces forces = this->sticking_forces();
    const double direction = -sign(forces.friction);
    if (!this->friction_holds(forces) && this->slip_would_last(direction)) {
      state_.slip_direction = direction;
      record(EventKind::slip_reverse);
      return;
    }
    if (!this->friction_holds(forces)) {
      if (this->is_centroidal()) {
        known_.limit_sign = -state_.side * direction;
      } else {
        stick_beyond_friction();
      }
    }
    state_.contact = ContactState::rock;
    record(EventKind::slip_stop);
  }

  /// N has risen through 0. A sliding block whose friction exceeds tan(psi) tips now; at the threshold its w' is
  /// exactly 0.
  void press_again() {
    if (state_.contact != ContactState::slide || !this->friction_is_above_tangent()) return;
    tip();
    known_.lift_is_flat = true;
  }

  /// N of a block that sticks beyond friction has fallen to 0. If slip keeps the block on the base, it slips from now
  /// on and the result is true.
  [[nodiscard]] bool slips_rather_than_lose_contact() {
    if (state_.contact != ContactState::rock || !coefficients_.has_friction()) return false;
    const double direction = -sign(this->sticking_forces().friction);
    if (!this->slip_keeps_contact(direction)) return false;
    start_slipping(direction, false);
    return true;
  }

  KnownAtStart known_;  ///< of the coming step
  Peaks peaks_;

 private:
  void tip() {
    state_.side = -state_.slip_direction;
    state_.contact = ContactState::rock_slide;
    record(EventKind::tip);
  }

  /// A rocking block without slip: whether friction suffices.
  void check_friction() {
    if (!coefficients_.has_friction()) return;
    const Forces forces = this->sticking_forces();
    if (!this->friction_holds(forces)) start_slipping(-sign(forces.friction), false);
  }

  void stick_beyond_friction() {
    known_.sticks_beyond_friction = true;
    ++contradictions_;
  }

  void start_sliding(double push, bool at_threshold, bool was_sliding) {
    state_.contact = ContactState::slide;
    state_.slip_direction = -push;
    // abs(alpha) >= mu_k (1 + alpha_v) up to rounding at the threshold. Where 1 + alpha_v = 0 no force acts.
    const double alpha = this->base_acceleration();
    const bool lags = push * alpha <= this->kinetic_friction_now() * this->weight();
    known_.slip_is_flat = lags || (at_threshold && (this->kinetic_equals_static() || alpha == 0.0));
    record(was_sliding ? EventKind::slip_reverse : EventKind::slide_start);
  }

  void stop_sliding() {
    if (!this->full_contact_holds()) return leave_full_contact(sign(this->base_acceleration()), false);
    state_.contact = ContactState::rest;
    record(EventKind::slide_stop);
  }

  Observer* observer_;
  std::optional<Termination> termination_;
  std::uint64_t contradictions_ = 0;
};

}  // namespace rocking::dynamics
