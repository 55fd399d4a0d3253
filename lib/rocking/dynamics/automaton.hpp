#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "rocking/dynamics/armed_guards.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/coefficients.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/formulation.hpp"
#include "rocking/dynamics/impact.hpp"
#include "rocking/dynamics/observer.hpp"
#include "rocking/dynamics/termination.hpp"

namespace rocking::dynamics {

/// What a scene fixes for a realisation.
struct Setting {
  Geometry block;
  double inertia;  ///< J
  ImpactSlipRule impact_slip_rule;
  double tolerance;  ///< of a step, in Theta and Theta'; of a hop, see Automaton::hop_is_too_small
};

/// The reset map of MODEL: what follows, at one instant, from each event. It knows no integrator: it is told which guard
/// fired and leaves the state from which the next smooth piece starts.
/// Every rule is in lib/docs/model.md, section 3.
template <CoefficientSource Coefficients>
class Automaton {
 public:
  Automaton(const Setting& setting, const Clock& clock, const Coefficients& coefficients, const Excitation& excitation,
            Observer& observer)
      : setting_(setting), clock_(clock), coefficients_(coefficients), excitation_(excitation), observer_(&observer) {}

  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const Clock& clock() const { return clock_; }
  [[nodiscard]] const Coefficients& coefficients() const { return coefficients_; }
  [[nodiscard]] const Excitation& excitation() const { return excitation_; }
  [[nodiscard]] std::optional<Termination> termination() const { return termination_; }

  /// From now on, tells `observer`.
  void observe_with(Observer& observer) { observer_ = &observer; }

  /// How often the block stuck though friction does not suffice; see start_slipping.
  [[nodiscard]] std::uint64_t contradictions() const { return contradictions_; }

  /// Horizontal base acceleration alpha now, in g.
  [[nodiscard]] double base_acceleration() {
    if (accelerated_at_ != clock_.now()) {  // several questions are asked of one instant
      accelerated_at_ = clock_.now();
      base_acceleration_ = excitation_.horizontal(clock_, base_amplitude());
    }
    return base_acceleration_;
  }

 protected:
  [[nodiscard]] double base_amplitude() { return coefficients_.amplitude(clock_) * excitation_.unit(setting_.block); }
  /// No hop without slip is too small that sets off faster, whatever the base does: abs(w') <= abs(alpha) + 1. Nearly every
  /// impact is far from it, and need not ask for the base's motion.
  [[nodiscard]] double fastest_small_hop() {
    return hop_limit() * (excitation_.most_horizontal(base_amplitude()) + 1.0);
  }
  [[nodiscard]] Observer& observer() const { return *observer_; }
  [[nodiscard]] bool is_slipping() const { return is_sliding(state_.contact); }

  /// The initial state and what follows from it at once.
  void enter(const State& initial) {
    state_ = initial;
    was_past_balance_ = std::abs(state_.tilt) >= setting_.block.shape_angle;
    const bool flat = state_.tilt == 0.0 && state_.tilt_rate == 0.0;
    state_.slip_direction = sign(state_.slip_rate);
    state_.side = sign(state_.tilt != 0.0 ? state_.tilt : state_.tilt_rate);
    const bool slips = state_.slip_rate != 0.0;
    state_.contact = flat ? (slips ? ContactState::slide : ContactState::rest)
                          : (slips ? ContactState::rock_slide : ContactState::rock);
    check_contact();
  }

  void overturn() {
    state_.contact = ContactState::overturned;
    termination_ = Termination::overturned;
    record(EventKind::overturn);
  }

  void pass_balance() {
    was_past_balance_ = true;
    record(EventKind::past_balance);
  }

  /// An impact that ended with the block on its other edge, as `land` would have it; a sticking one, and far from a chatter.
  void change_edges(double tilt_rate) {
    state_.tilt = 0.0;
    state_.tilt_rate = tilt_rate;
    state_.side = sign(tilt_rate);
    record(EventKind::impact_stick);
  }

  void end(Termination reason) { termination_ = reason; }

  void go_on() {
    if (termination_ == Termination::reached_horizon) termination_.reset();
  }

  /// theta has become 0. `slip_ended`: V has become 0 at the same instant.
  void land(bool slip_ended) {
    state_.tilt = 0.0;
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
    if (state_.tilt_rate == 0.0 && state_.slip_rate == 0.0) return leave_full_contact(sign(base_acceleration()), false);
    state_.contact = state_.slip_rate == 0.0 ? ContactState::rock : ContactState::rock_slide;
    check_contact();
  }

  /// V has become 0.
  void stop_slipping() {
    state_.slip_rate = 0.0;
    coefficients_.stop();
    if (state_.contact == ContactState::slide) {
      if (full_contact_holds()) {
        state_.contact = ContactState::rest;
        record(EventKind::slide_stop);
      } else {
        leave_full_contact(sign(base_acceleration()), false);
      }
      return;
    }
    const Forces forces = rocking_forces(state_, base_acceleration(), weight(), setting_.block);
    const double direction = -sign(forces.friction);
    if (!friction_holds(forces) && slip_would_last(direction)) {
      state_.slip_direction = direction;
      record(EventKind::slip_reverse);
      return;
    }
    if (!friction_holds(forces)) {
      if (is_centroidal()) {
        known_.limit_sign = -state_.side * direction;
      } else {
        stick_beyond_friction();
      }
    }
    state_.contact = ContactState::rock;
    record(EventKind::slip_stop);
  }

  /// N has risen through 0. A slide tips where it could not before; at the threshold its w' is exactly 0.
  void press_again() {
    if (state_.contact != ContactState::slide || !friction_is_above_tangent()) return;
    tip();
    known_.lift_is_flat = true;
  }

  /// N of a block that sticks beyond friction has fallen to 0: true if slip keeps it on the base, and it slips from now on.
  [[nodiscard]] bool slips_rather_than_lose_contact() {
    if (state_.contact != ContactState::rock || !coefficients_.has_friction()) return false;
    const Forces forces = rocking_forces(state_, base_acceleration(), weight(), setting_.block);
    const double direction = -sign(forces.friction);
    if (!slip_keeps_contact(direction)) return false;
    start_slipping(direction, false);
    return true;
  }

  /// Rocking: friction is exhausted; the block starts to slip in `direction`. `at_threshold`: found as a root.
  ///
  /// Where slip would be turned back at once there is no motion that agrees with the equations (the inertia about the
  /// edge makes such places): then it sticks, and friction is not tested again before the next event.
  void start_slipping(double direction, bool at_threshold) {
    const bool is_full_contact = state_.tilt == 0.0 && state_.tilt_rate == 0.0;
    if (is_full_contact && !kinetic_friction_tips()) return start_sliding(-direction, at_threshold, false);
    // About the centre of mass s V' is at least in proportion to abs(F) - mu_s N: if it is not > 0, by rounding, it is 0.
    const bool lasts = slip_would_last(direction);
    const bool starts_flat = is_centroidal() && (!lasts || (at_threshold && kinetic_equals_static()));
    if (!starts_flat && !lasts) return stick_beyond_friction();
    state_.contact = ContactState::rock_slide;
    state_.slip_direction = direction;
    known_.slip_is_flat = starts_flat;
    record(EventKind::slip_start);
  }

  /// Full contact cannot hold. `push`: sign of the base acceleration; `at_threshold`: found as a root, so that nothing is
  /// compared again and the accelerations that vanish at the threshold are exactly 0.
  void leave_full_contact(double push, bool at_threshold) {
    const bool was_sliding = state_.contact == ContactState::slide;
    state_.slip_rate = 0.0;
    state_.side = push;
    const Forces forces = rocking_forces(state_, base_acceleration(), weight(), setting_.block);
    if (coefficients_.has_friction()) {
      const double mu_s = coefficients_.static_friction();
      if (mu_s <= setting_.block.tangent) return start_sliding(push, at_threshold, was_sliding);
      if (!friction_holds(forces)) {
        if (!kinetic_friction_tips()) return start_sliding(push, at_threshold, was_sliding);
        state_.contact = ContactState::rock;
        record(EventKind::lift);
        return start_slipping(-sign(forces.friction), false);
      }
    }
    state_.contact = ContactState::rock;
    known_.lift_is_flat = at_threshold || forces.acceleration == 0.0;
    record(EventKind::lift);
  }

  /// Whether the contact can stay as it is: after the start, and wherever friction or the base acceleration jumps.
  void check_contact() {
    switch (state_.contact) {
      case ContactState::rest: return check_full_contact();
      case ContactState::slide: return check_tipping();
      case ContactState::rock: return check_friction();
      case ContactState::rock_slide:
      case ContactState::overturned: return;
    }
  }

  Setting setting_;
  Clock clock_;
  Coefficients coefficients_;
  Excitation excitation_;
  State state_;
  bool was_past_balance_ = false;
  KnownAtStart known_;                     ///< of the coming step
  std::optional<Instant> accelerated_at_;  ///< when the base acceleration below was

 private:
  /// Durations of a hop, and heights over psi, up to which it is too small.
  [[nodiscard]] double hop_limit() const { return std::max(setting_.tolerance, clock_.resolution()); }
  [[nodiscard]] double weight() const { return excitation_.weight(clock_); }
  [[nodiscard]] static double sign(double value) { return value < 0.0 ? -1.0 : 1.0; }

  void record(EventKind kind) { observer_->event(kind, clock_.tau(), state_); }

  [[nodiscard]] bool kinetic_equals_static() {
    return coefficients_.kinetic_friction(clock_) == coefficients_.static_friction();
  }

  [[nodiscard]] bool is_centroidal() const { return setting_.inertia == inertia_ratio(SlideInertia::centroidal); }

  /// Whether a block that rocks sticks under these forces, those of sticking. Where they need N <= 0, it sticks only if slip
  /// does not keep it on the base either.
  [[nodiscard]] bool friction_holds(const Forces& forces) {
    if (forces.normal <= 0.0) return !slip_keeps_contact(-sign(forces.friction));
    return std::abs(forces.friction) <= coefficients_.static_friction() * forces.normal;
  }

  /// Rates of slip that starts from V = 0 in `direction`.
  [[nodiscard]] SlippingRates rates_of_slip(double direction) {
    State slipping = state_;
    slipping.slip_direction = direction;
    const double mu_k = coefficients_.kinetic_friction(clock_);
    return slipping_rates(slipping, base_acceleration(), weight(), setting_.inertia, mu_k, setting_.block);
  }

  /// Whether slip that starts from V = 0 in `direction` is driven on in that direction.
  [[nodiscard]] bool slip_would_last(double direction) {
    return direction * rates_of_slip(direction).slip_acceleration > 0.0;
  }

  /// Whether it is driven on and the block presses on the base, N > 0.
  [[nodiscard]] bool slip_keeps_contact(double direction) {
    const SlippingRates rates = rates_of_slip(direction);
    return rates.normal > 0.0 && direction * rates.slip_acceleration > 0.0;
  }

  [[nodiscard]] bool full_contact_holds() {
    const double alpha = base_acceleration();
    const double mu_s = coefficients_.static_friction();
    return mu_s <= setting_.block.tangent ? std::abs(alpha) <= mu_s * weight()
                                          : edges_hold(alpha, weight(), setting_.block);
  }

  void check_full_contact() {
    if (!full_contact_holds()) leave_full_contact(sign(base_acceleration()), false);
  }

  [[nodiscard]] bool friction_is_above_tangent() {
    return friction_tips(coefficients_.kinetic_friction(clock_), setting_.block);
  }

  /// Whether sliding friction turns the block over its leading edge. Its torque does not where N = (4/3)(1 + alpha_v) <= 0.
  [[nodiscard]] bool kinetic_friction_tips() { return friction_is_above_tangent() && weight() > 0.0; }

  void check_tipping() {
    if (kinetic_friction_tips()) tip();
  }

  void tip() {
    state_.side = -state_.slip_direction;
    state_.contact = ContactState::rock_slide;
    record(EventKind::tip);
  }

  /// Rock: whether the friction that it needs is there.
  void check_friction() {
    if (!coefficients_.has_friction()) return;
    const Forces forces = rocking_forces(state_, base_acceleration(), weight(), setting_.block);
    if (!friction_holds(forces)) start_slipping(-sign(forces.friction), false);
  }

  void stick_beyond_friction() {
    known_.sticks_beyond_friction = true;
    ++contradictions_;
  }

  void start_sliding(double push, bool at_threshold, bool was_sliding) {
    state_.contact = ContactState::slide;
    state_.slip_direction = -push;
    // abs(alpha) >= mu_k (1 + alpha_v), or a rounding of the threshold hides it; nothing pushes where 1 + alpha_v = 0.
    const double alpha = base_acceleration();
    const bool lags = push * alpha <= coefficients_.kinetic_friction(clock_) * weight();
    known_.slip_is_flat = lags || (at_threshold && (kinetic_equals_static() || alpha == 0.0));
    record(was_sliding ? EventKind::slip_reverse : EventKind::slide_start);
  }

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
        end(Termination::painleve);
        return false;
      }
      kind = after.kind;
      state_.tilt_rate = after.tilt_rate;
      state_.slip_rate = after.slip_rate;
    } else {
      state_.tilt_rate = sticking_tilt_rate(state_.tilt_rate, 0.0, restitution, setting_.block);
    }
    if (state_.tilt_rate != 0.0) state_.side = sign(state_.tilt_rate);
    if (state_.slip_rate != 0.0) state_.slip_direction = sign(state_.slip_rate);
    record(kind == ImpactKind::stick ? EventKind::impact_stick : EventKind::impact_slip);
    return true;
  }

  [[nodiscard]] ImpactOutcome impact_with_friction(const ImpactConditions& before) {
    const auto sticks = sticking_impact(before, setting_.block, setting_.impact_slip_rule);
    return sticks ? *sticks : slipping_impact(before, coefficients_.kinetic_friction(clock_), setting_.block);
  }

  /// After an impact: whether the coming hop's duration 2 abs(w)/a and its height w^2/(2a) over psi are both below the
  /// tolerance (or the resolution of time), a being the acceleration that brings the block back. The hops that would
  /// follow last abs(delta)/(1 - abs(delta)) times as long in all, and the energy they hold is w^2/2 over p^2.
  ///
  /// Full contact must be able to hold afterwards, unless every impact sends the block back over the same edge: then it
  /// comes to rest on the way to lifting over the other one.
  [[nodiscard]] bool hop_is_too_small(bool over_same_edge) {
    const double rate = std::abs(state_.tilt_rate);
    const bool slips = state_.slip_rate != 0.0;
    if (!slips && rate > fastest_small_hop()) return false;
    if (slips && !over_same_edge && kinetic_friction_tips()) return false;
    const double alpha = base_acceleration();
    if (!slips && !over_same_edge && !edges_hold(alpha, weight(), setting_.block)) return false;
    const double pull = -state_.side * (slips ? slipping_acceleration(alpha) : rocking_acceleration(alpha));
    const double limit = hop_limit();
    return pull >= 0.0 && 2.0 * rate <= limit * pull && rate * rate <= 2.0 * limit * pull * setting_.block.shape_angle;
  }

  /// w' under the base acceleration alpha.
  [[nodiscard]] double rocking_acceleration(double alpha) const {
    return rocking_forces(state_, alpha, weight(), setting_.block).acceleration;
  }
  [[nodiscard]] double slipping_acceleration(double alpha) {
    const double mu_k = coefficients_.kinetic_friction(clock_);
    return slipping_rates(state_, alpha, weight(), setting_.inertia, mu_k, setting_.block).tilt_acceleration;
  }

  void end_chatter() {
    coefficients_.chatter_ended();
    state_.tilt_rate = 0.0;
    if (state_.slip_rate != 0.0) {
      state_.contact = ContactState::slide;
      record(EventKind::to_slide);
      return check_tipping();
    }
    state_.contact = ContactState::rest;
    record(EventKind::to_rest);
    check_full_contact();
  }

  Observer* observer_;
  std::optional<Termination> termination_;
  double base_acceleration_ = 0.0;
  std::uint64_t contradictions_ = 0;
};

}  // namespace rocking::dynamics
