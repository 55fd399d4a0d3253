#pragma once

#include <cmath>

#include "rocking/dynamics/contact_changes.hpp"
#include "rocking/dynamics/impact.hpp"

namespace rocking::dynamics {

/// What happens when theta becomes 0: the impact, the end of a chatter, the contact state afterwards.
template <CoefficientSource Coefficients>
class Landing : public ContactChanges<Coefficients> {
 protected:
  using Changes = ContactChanges<Coefficients>;
  using Changes::coefficients_, Changes::setting_, Changes::state_, Changes::record, Changes::sign;

 public:
  using Changes::Changes;

 protected:
  /// theta has become 0. `slip_ended`: V has become 0 at the same instant.
  void land(bool slip_ended) {
    state_.tilt = 0.0;
    this->note_slip();
    if (slip_ended) state_.slip_rate = 0.0;
    bool is_stop = slip_ended;
    const double side_before = state_.side;
    if (state_.side * state_.tilt_rate < 0.0) {
      const double slip_before = state_.slip_rate;
      if (!impact()) return;
      is_stop = is_stop || (slip_before != 0.0 && state_.slip_rate == 0.0);
    } else {
      state_.tilt_rate = 0.0;  // a touch: no impulse
    }
    if (is_stop) coefficients_.stop();
    if (hop_is_too_small(state_.side == side_before)) return end_chatter();
    if (state_.tilt_rate == 0.0 && state_.slip_rate == 0.0) {
      return this->leave_full_contact(sign(this->base_acceleration()), false);
    }
    state_.contact = state_.slip_rate == 0.0 ? ContactState::rock : ContactState::rock_slide;
    this->check_contact();
  }

  /// A sticking impact after which the block rocks about its other edge at `tilt_rate`: what `land` does where the
  /// caller has shown that the impact sticks, that no chatter ends and that friction holds afterwards.
  void change_edges(double tilt_rate) {
    state_.tilt = 0.0;
    state_.tilt_rate = tilt_rate;
    state_.side = sign(tilt_rate);
    record(EventKind::impact_stick);
  }

 private:
  /// The impulse. False if the model has no answer.
  [[nodiscard]] bool impact() {
    const double restitution = coefficients_.restitution();
    ImpactKind kind = ImpactKind::stick;
    if (coefficients_.has_friction()) {
      const ImpactOutcome after = impact_with_friction({.tilt_rate = state_.tilt_rate,
                                                        .slip_rate = state_.slip_rate,
                                                        .restitution = restitution,
                                                        .static_friction = coefficients_.static_friction()});
      if (after.kind == ImpactKind::painleve) {
        this->end(Termination::painleve);
        return false;
      }
      kind = after.kind;
      state_.tilt_rate = after.tilt_rate;
      state_.slip_rate = after.slip_rate;
    } else {
      state_.tilt_rate =
          sticking_tilt_rate({.tilt_rate = state_.tilt_rate, .slip_rate = 0.0}, restitution, setting_.block);
    }
    if (state_.tilt_rate != 0.0) state_.side = sign(state_.tilt_rate);
    if (state_.slip_rate != 0.0) state_.slip_direction = sign(state_.slip_rate);
    record(kind == ImpactKind::stick ? EventKind::impact_stick : EventKind::impact_slip);
    return true;
  }

  [[nodiscard]] ImpactOutcome impact_with_friction(const ImpactConditions& before) {
    const auto sticks = sticking_impact(before, setting_.block, setting_.impact_slip_rule);
    return sticks ? *sticks : slipping_impact(before, this->kinetic_friction_now(), setting_.block);
  }

  /// After an impact: whether the coming hop's duration 2 abs(w)/a and its height w^2/(2a) over psi are both below the
  /// tolerance (or the resolution of time), where a is the acceleration that brings the block back. The hops that would
  /// follow last abs(delta)/(1 - abs(delta)) times as long in all, and their energy is w^2/2 over p^2.
  ///
  /// Full contact must be able to hold afterwards, unless every impact sends the block back over the same edge: then it
  /// comes to rest before it lifts over the other one.
  [[nodiscard]] bool hop_is_too_small(bool over_same_edge) {
    const double rate = std::abs(state_.tilt_rate);
    const bool slips = state_.slip_rate != 0.0;
    if (!slips && rate > this->fastest_small_hop()) return false;
    if (slips && !over_same_edge && this->kinetic_friction_tips()) return false;
    if (!slips && !over_same_edge && !edges_hold(this->base_motion(), setting_.block)) return false;
    const double pull = -state_.side * (slips ? this->slipping_acceleration() : this->rocking_acceleration());
    const double limit = this->hop_limit();
    return pull >= 0.0 && 2.0 * rate <= limit * pull && rate * rate <= 2.0 * limit * pull * setting_.block.shape_angle;
  }

  void end_chatter() {
    coefficients_.chatter_ended();
    state_.tilt_rate = 0.0;
    if (state_.slip_rate != 0.0) {
      state_.contact = ContactState::slide;
      record(EventKind::to_slide);
      return this->check_tipping();
    }
    state_.contact = ContactState::rest;
    record(EventKind::to_rest);
    this->check_full_contact();
  }
};

}  // namespace rocking::dynamics
