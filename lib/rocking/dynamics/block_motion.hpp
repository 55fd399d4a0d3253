#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "rocking/dynamics/armed_guards.hpp"
#include "rocking/dynamics/automaton.hpp"
#include "rocking/dynamics/smooth_step.hpp"
#include "rocking/dynamics/step_series.hpp"

namespace rocking::dynamics {

/// When a run is sampled and how long it is.
struct Schedule {
  Instant first_strobe;      ///< the following ones come a period apart
  std::int64_t strobes = 0;  ///< after the last the run ends
};

/// A small change of state: Theta, Theta', V.
struct Displacement {
  double tilt = 0.0;
  double tilt_rate = 0.0;
  double slip_rate = 0.0;
};

/// A block on a shaken base as a hybrid system: smooth pieces as Taylor polynomials, guards as polynomials, resets by the
/// automaton. Models the concept that the integrator asks for, without knowing an integrator.
///
/// `Steps` turns the last two terms of a series into the length of a step: double(last_but_one, last, order, largest).
/// Copying copies the whole realisation as it stands.
template <CoefficientSource Coefficients, class Steps>
class BlockMotion : public Automaton<Coefficients> {
  using Base = Automaton<Coefficients>;
  using Base::clock_;
  using Base::coefficients_;
  using Base::excitation_;
  using Base::known_;
  using Base::setting_;
  using Base::state_;

 public:
  BlockMotion(const Setting& setting, const Clock& clock, const Coefficients& coefficients, const State& initial,
              const Schedule& schedule, Observer& observer, const Excitation& excitation = {}, Steps steps = {})
      : Base(setting, clock, coefficients, excitation, observer),
        schedule_(schedule),
        next_strobe_(schedule.first_strobe),
        series_(steps) {
    this->enter(initial);
    settle();
  }

  [[nodiscard]] bool ended() const { return this->termination().has_value(); }
  [[nodiscard]] double time_resolution() const { return clock_.resolution(); }
  [[nodiscard]] double time_to_strobe() const { return clock_.until(next_strobe_); }
  [[nodiscard]] double time_to_breakpoint() const {
    return breakpoint_ ? clock_.until(*breakpoint_) : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] std::uint64_t slip_steps() const { return slip_steps_; }
  [[nodiscard]] std::uint64_t losses_of_contact() const { return losses_of_contact_; }
  [[nodiscard]] double first_loss_of_contact() const { return first_loss_of_contact_; }  ///< tau; of use after a loss
  [[nodiscard]] bool is_off_ground() const { return off_ground_; }                       ///< N <= 0
  [[nodiscard]] bool was_past_balance() const { return Base::was_past_balance_; }

  /// After the last strobe point: goes on for `more` of them, as if the run had been that long from the start.
  void extend(std::int64_t more) {
    schedule_.strobes += more;
    this->go_on();
  }

  /// After the last strobe point: puts the clock on its instant.
  void move_to_last_strobe() {
    const double past = clock_.until({.period = next_strobe_.period - 1, .time = next_strobe_.time});
    if (past <= clock_.resolution()) return;
    static_cast<void>(
        length_of_series(time_to_breakpoint()));  // of the step in which the run ended; perhaps done elsewhere
    move(past);
    settle();
  }

  /// After move_to_last_strobe: goes on for `more` strobe points under other circumstances. The state stays as it is, down to
  /// the contact state, wherever the contact can stay so; `clock` says where in which period the base motion goes on.
  void go_on_under(const Setting& setting, const Clock& clock, const Coefficients& coefficients, std::int64_t more) {
    setting_ = setting;
    clock_ = clock;
    coefficients_ = coefficients;
    Base::accelerated_at_.reset();
    known_ = {};
    extend(more);
    this->check_contact();
    settle();
  }

  /// Displaces the state, within its contact state, by rates and tilt in units of Theta; returns what was displaced.
  Displacement displace(const Displacement& wanted) {
    Displacement done;
    if (state_.contact == ContactState::rock || state_.contact == ContactState::rock_slide) {
      done.tilt = wanted.tilt;
      done.tilt_rate = wanted.tilt_rate;
    }
    if (this->is_slipping()) done.slip_rate = wanted.slip_rate;
    state_.tilt += done.tilt * setting_.block.shape_angle;
    state_.tilt_rate += done.tilt_rate * setting_.block.shape_angle;
    state_.slip_rate += done.slip_rate;
    settle();
    return done;
  }

  /// Whether the coming step is an ordinary one of rocking: nothing known about it but the state, and no guard armed but the
  /// ordinary ones. Then it may be done elsewhere, in company (module lanes), from what smooth_step() tells.
  [[nodiscard]] bool has_ordinary_step() const {
    const bool knows_more = known_ != KnownAtStart{} || (state_.tilt == 0.0 && state_.tilt_rate == 0.0);
    return is_rocking(state_.contact) && !ended() && !knows_more && !Base::was_past_balance_ && !off_ground_ &&
           !(this->is_slipping() && determinant_may_vanish());
  }

  /// Pieces of a record that were expanded.
  [[nodiscard]] std::uint64_t segments_looked_up() const { return segments_; }

  [[nodiscard]] bool slips() const { return this->is_slipping(); }
  [[nodiscard]] bool tests_friction() const { return coefficients_.has_friction(); }
  /// Whether the coming step must end soon.
  [[nodiscard]] bool is_brief() const { return is_brief(time_to_breakpoint()); }

  [[nodiscard]] SmoothStep smooth_step() {
    const double side = state_.side;
    return {.setting = &setting_,
            .clock = &clock_,
            .state = {.tilt = side * state_.tilt,
                      .tilt_rate = side * state_.tilt_rate,
                      .slip = side * state_.slip,
                      .slip_rate = side * state_.slip_rate},
            .amplitude = side * this->base_amplitude(),
            .static_friction = coefficients_.static_friction(),
            .kinetic_friction = kinetic_friction_,
            .restitution = constant_restitution(),
            .impact_loss = impact_loss(constant_restitution(), setting_.block),
            .least_rebound = this->fastest_small_hop(),
            .slip_sign = side * state_.slip_direction,
            .next_strobe = next_strobe_,
            .strobes_left = schedule_.strobes - strobes_done_,
            .steps_since_strobe = steps_since_strobe_,
            .breakpoint = breakpoint_ ? *breakpoint_ : never,
            .coefficients_change = coefficients_change(),
            .excitation = &excitation_};
  }

  /// A strobe point that was passed within a step done elsewhere; not the last one.
  void pass_strobe(const SmoothState& sample) { tell_strobe(from_frame(sample)); }

  /// An impact at the end of steps done elsewhere, the only thing that happened there: the loss was as smooth_step says and the
  /// rebound above its least. `progress` is in the frame of the new side.
  void pass_impact(const SmoothProgress& progress) {
    clock_.set(progress.now);
    count_segments(progress.steps);
    steps_since_strobe_ = progress.steps_since_strobe;
    count_steps_elsewhere(progress.steps);
    this->change_edges(-state_.side * progress.state.tilt_rate);
    settle();
  }

  /// What is known of the coming intervals of the friction grid, if it leaves the steps of a rock-slide ordinary and brief. Each
  /// interval ends at a boundary of the grid (dynamics::grid_boundary).
  [[nodiscard]] FrictionForesight foresee() const {
    if constexpr (ForeseesCoefficients<Coefficients>) {
      if (excitation_.has_knots()) return {};
      if (determinant_may_vanish(coefficients_.static_friction())) return {};  // a bound for kinetic friction
      const FrictionForesight known = coefficients_.foresee();
      if (static_cast<double>(known.per_period) * brief_step > 1.0) return known;
    }
    return {};
  }

  /// Takes over from where steps done elsewhere have come to. At breakpoints nothing happened but that the interval changed.
  void catch_up(const SmoothProgress& progress) {
    state_ = from_frame(progress.state);
    clock_.set(progress.now);
    steps_since_strobe_ = progress.steps_since_strobe;
    if (progress.steps > 0) count_steps_elsewhere(progress.steps);
    count_segments(progress.steps);
    if constexpr (ForeseesCoefficients<Coefficients>) {
      if (progress.foreseen > 0) coefficients_.pass_intervals(clock_, progress.foreseen);
    }
    if (progress.at_breakpoint) this->check_contact();
    if (progress.breakpoints > 0) settle();
  }

  /// A step done elsewhere in which something may have happened. `fired` is indexed by Guard.
  template <class Fired>
  void finish_step(const SmoothEnd& end, const Fired& fired) {
    count_step();
    count_segments(1);
    after_reset_ = false;
    const bool at_breakpoint = end.duration >= time_to_breakpoint() - clock_.resolution();
    if (end.strobe) {
      tell_strobe(from_frame(*end.strobe));
      steps_since_strobe_ = 0;
    }
    if (end.duration > 0.0) {
      move_to(end.duration, from_frame(end.state));
    } else {
      stand_still();
    }
    reset(fired, at_breakpoint);
  }

  /// A step done elsewhere in which the last strobe point comes before anything else: the run ends where the step began.
  void finish_at_strobe(const SmoothState& sample) {
    count_step();
    count_segments(1);
    after_reset_ = false;
    tell_strobe(from_frame(sample));
    steps_since_strobe_ = 0;
    this->end(Termination::reached_horizon);
  }

  /// The series of the coming step; returns its length.
  [[nodiscard]] double expand(double reach) {
    count_step();
    const double length = length_of_series(reach);
    out_of_reach_ = guards_out_of_reach(length);
    if (after_reset_) look_at_validity();
    if (!(length > least_step * clock_.resolution()) && reach > length) end_without_step();
    return length;
  }

  /// The state x into the step that `expand` has prepared.
  [[nodiscard]] State state_at(double x) const { return series_.state_at(x, state_); }
  /// The base's motion x into the step that `expand` has prepared.
  [[nodiscard]] BaseMotion base_at(double x) const { return series_.base_at(x, state_); }

  /// mu_k in force over the coming step while the block slips; else 0.
  [[nodiscard]] double kinetic_friction() const { return kinetic_friction_; }

  /// Calls visit(number, coefficients) for each guard that is armed and in the set.
  template <class Guards, class Visitor>
  void for_each_guard(const Guards& wanted, Visitor&& visit) const {
    visit_guards(
        armed_guards(), series_.rows(), [&wanted](std::size_t guard) { return wanted[guard]; }, visit);
  }

  void strobe(double x) {
    const State sample = state_at(x);
    if (!is_finite(sample)) return end_without_step();
    tell_strobe(sample);
    steps_since_strobe_ = 0;
    if (strobes_done_ == schedule_.strobes) this->end(Termination::reached_horizon);
  }

  void move(double x) {
    if (!(x > 0.0)) return stand_still();
    const State next = state_at(x);
    if (!is_finite(next)) return end_without_step();
    move_to(x, next);
  }

  /// `fired` is indexed by Guard.
  template <class Fired>
  void reset(const Fired& fired, bool at_breakpoint) {
    if (fired.none() && !at_breakpoint) return;
    known_ = {};
    if (at_breakpoint) clock_.set(*breakpoint_);
    // A guard that fires without time going on was below zero from the start: the forces had jumped, it is no root.
    const bool at_threshold = time_went_on_;
    const auto has_fired = [&fired](Guard guard) { return fired[static_cast<std::size_t>(guard)]; };
    if (has_fired(Guard::overturn)) return this->overturn();
    if (has_fired(Guard::determinant)) return this->end(Termination::painleve);
    // Without time going on a block that has just lifted has not moved yet: friction decides first how it sets off.
    const bool sets_off = !time_went_on_ && (has_fired(Guard::friction_inward) || has_fired(Guard::friction_outward));
    if (has_fired(Guard::tilt) && !sets_off) {
      this->land(has_fired(Guard::slip));
    } else if (has_fired(Guard::slip)) {
      this->stop_slipping();
    } else if (has_fired(Guard::friction_inward)) {
      this->start_slipping(-state_.side, at_threshold);
    } else if (has_fired(Guard::friction_outward)) {
      this->start_slipping(state_.side, at_threshold);
    } else if (has_fired(Guard::leave_right) || has_fired(Guard::leave_left)) {
      this->leave_full_contact(has_fired(Guard::leave_right) ? 1.0 : -1.0, at_threshold);
      if (has_fired(Guard::normal) && !at_breakpoint)
        cross_normal();  // nothing pushes: N of the new state is 0 here too
    } else if (at_breakpoint) {
      this->check_contact();
    } else if (has_fired(Guard::normal)) {  // after anything else the force jumps and is looked at anew
      if (off_ground_ || !this->slips_rather_than_lose_contact()) cross_normal();
    }
    if (has_fired(Guard::past_balance)) this->pass_balance();
    settle();
  }

 private:
  static constexpr std::int64_t most_events_at_once = 1'000;  ///< without time going on

  void count_step() {
    if (++steps_since_strobe_ > step_budget) this->end(Termination::stopped);
    if (this->is_slipping()) ++slip_steps_;
  }

  void count_segments(std::uint64_t expansions) {
    if (excitation_.has_knots()) segments_ += expansions;
  }

  void count_steps_elsewhere(std::uint64_t steps) {
    if (this->is_slipping()) slip_steps_ += steps;
    time_went_on_ = true;
    events_at_once_ = 0;
    after_reset_ = false;
  }

  void stand_still() {
    time_went_on_ = false;
    if (++events_at_once_ > most_events_at_once) this->end(Termination::stopped);
  }

  void move_to(double x, const State& next) {
    time_went_on_ = true;
    state_ = next;
    clock_.advance(x);
    events_at_once_ = 0;
    known_ = known_.after_a_step();
  }

  void tell_strobe(const State& sample) {
    this->observer().strobe(sample);
    ++next_strobe_.period;
    ++strobes_done_;
  }

  [[nodiscard]] State from_frame(const SmoothState& smooth) const {
    State state = state_;
    state.tilt = state_.side * smooth.tilt;
    state.tilt_rate = state_.side * smooth.tilt_rate;
    if (this->is_slipping()) {
      state.slip = state_.side * smooth.slip;
      state.slip_rate = state_.side * smooth.slip_rate;
    }
    return state;
  }

  [[nodiscard]] double constant_restitution() const {
    if constexpr (ForeseesCoefficients<Coefficients>) {
      if (const std::optional<double> restitution = coefficients_.constant_restitution()) return *restitution;
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// The next breakpoint that is not the base motion's; asked for where that has some of its own.
  [[nodiscard]] Instant coefficients_change() const {
    if (!excitation_.has_knots()) return never;
    return coefficients_.next_change(clock_, this->is_slipping()).value_or(never);
  }

  [[nodiscard]] std::optional<Instant> earlier(const std::optional<Instant>& a, const std::optional<Instant>& b) const {
    if (!a || !b) return a ? a : b;
    return clock_.until(*a) < clock_.until(*b) ? a : b;
  }

  [[nodiscard]] static bool is_finite(const State& state) {
    return std::isfinite(state.tilt) && std::isfinite(state.tilt_rate) && std::isfinite(state.slip) &&
           std::isfinite(state.slip_rate);
  }

  /// The series no longer carries the motion on: it blows up near D = 0, or something that is not a number was fed in.
  void end_without_step() {
    const bool near_painleve = state_.contact == ContactState::rock_slide && determinant_may_vanish();
    this->end(near_painleve ? Termination::painleve : Termination::stopped);
  }

  /// Fills the series as far as the coming step needs it; returns the step's length.
  [[nodiscard]] double length_of_series(double reach) {
    if (is_brief(reach) && expand_to<brief_order>() >= reach) return reach;
    return std::min({expand_to<full_order>(), reach, clock_.period_length()});
  }

  [[nodiscard]] bool is_brief(double reach) const { return reach <= brief_step * clock_.period_length(); }

  /// After events: what the coming steps need to know.
  void settle() {
    if (ended()) return;
    kinetic_friction_ = this->is_slipping() ? coefficients_.kinetic_friction(clock_) : 0.0;
    breakpoint_ = earlier(coefficients_.next_change(clock_, this->is_slipping()), excitation_.next_change(clock_));
    after_reset_ = true;
  }

  /// A reset makes the forces jump: whether the block still presses on the base, and the equations still have a solution.
  void look_at_validity() {
    after_reset_ = false;
    if (state_.contact == ContactState::rock_slide && determinant_may_vanish() && determinant() <= 0.0) {
      this->end(Termination::painleve);
    }
    if (!known_.normal_is_zero)
      set_off_ground(is_rocking(state_.contact) ? series_.rows().normal[0] <= 0.0 : has_no_weight());
  }

  /// N has become 0.
  void cross_normal() {
    set_off_ground(!off_ground_);
    known_.normal_is_zero = true;
    if (!off_ground_) this->press_again();
  }

  /// In full contact N = (4/3)(1 + alpha_v).
  [[nodiscard]] bool has_no_weight() const { return excitation_.has_vertical() && series_.rows().weight[0] <= 0.0; }

  void set_off_ground(bool off) {
    if (off && !off_ground_ && losses_of_contact_++ == 0) first_loss_of_contact_ = clock_.tau();
    off_ground_ = off;
  }

  [[nodiscard]] double determinant() const { return setting_.inertia + series_.rows().sine[0] * series_.rows().arm[0]; }

  [[nodiscard]] bool determinant_may_vanish() const { return determinant_may_vanish(kinetic_friction_); }

  /// min over phi of D = J + 1/2 - sqrt(1 + mu_k^2)/2.
  [[nodiscard]] bool determinant_may_vanish(double kinetic_friction) const {
    const double limit = 2.0 * setting_.inertia + 1.0;
    return 1.0 + kinetic_friction * kinetic_friction >= limit * limit;
  }

  [[nodiscard]] ArmedGuards armed_guards() const {
    return {.state = state_,
            .block = setting_.block,
            .known = known_,
            .order = series_.order(),
            .side = frame_side(state_),
            .mu_s = coefficients_.static_friction(),
            .J = setting_.inertia,
            .is_past_balance = Base::was_past_balance_,
            .off_ground = off_ground_,
            .has_friction = coefficients_.has_friction(),
            .vertical = excitation_.has_vertical(),
            .determinant_can_vanish = determinant_may_vanish(),
            .out_of_reach = out_of_reach_};
  }

  [[nodiscard]] OutOfReach<bool> guards_out_of_reach(double length) {
    const bool may_hop = off_ground_ || known_.normal_is_zero;
    if (state_.contact != ContactState::rock || Base::was_past_balance_ || may_hop || excitation_.has_vertical())
      return {};
    return out_of_reach(state_.side * state_.tilt, state_.side * state_.tilt_rate,
                        excitation_.most_horizontal(this->base_amplitude()), length, setting_.block.shape_angle,
                        setting_.block.sine);
  }

  template <int order>
  double expand_to() {
    count_segments(1);
    return series_.template expand<order>({.setting = setting_,
                                           .state = state_,
                                           .clock = clock_,
                                           .amplitude = this->base_amplitude(),
                                           .kinetic_friction = kinetic_friction_,
                                           .lift_starts_flat = known_.lift_is_flat,
                                           .slip_starts_flat = known_.slip_is_flat},
                                          excitation_);
  }

  Schedule schedule_;
  Instant next_strobe_;
  std::int64_t strobes_done_ = 0;
  std::int64_t steps_since_strobe_ = 0;
  std::int64_t events_at_once_ = 0;
  bool time_went_on_ = false;  ///< in the last move
  std::uint64_t slip_steps_ = 0;
  std::uint64_t segments_ = 0;
  std::optional<Instant> breakpoint_;
  double kinetic_friction_ = 0.0;  ///< mu_k in force over the coming step, while slipping
  StepSeries<Steps> series_;
  OutOfReach<bool> out_of_reach_{};  ///< over the coming step
  bool after_reset_ = true;
  bool off_ground_ = false;  ///< N <= 0
  std::uint64_t losses_of_contact_ = 0;
  double first_loss_of_contact_ = 0.0;
};

}  // namespace rocking::dynamics
