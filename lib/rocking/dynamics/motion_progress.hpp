#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "rocking/dynamics/automaton.hpp"
#include "rocking/dynamics/continuity.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/dynamics/strobe_schedule.hpp"

namespace rocking::dynamics {

/// The end of steps without events that the lanes have computed instead of the motion.
struct StepsElsewhere {
  State state;
  Instant now;
  std::uint64_t count;
  std::int64_t since_strobe;  ///< steps since the last strobe point
};

/// Whether the contact state may have to change at a breakpoint.
enum class Contact : std::uint8_t { stays, to_be_checked };

/// How far a motion has come: its strobe points, breakpoints and steps. It does not compute a step; each function is a
/// part of what follows from one, for BlockMotion and for the lanes.
template <CoefficientSource Coefficients>
class MotionProgress : public Automaton<Coefficients> {
 protected:
  using Base = Automaton<Coefficients>;
  using Base::clock_, Base::coefficients_, Base::excitation_, Base::known_, Base::peaks_, Base::setting_, Base::state_;

 public:
  MotionProgress(const Setting& setting, const Clock& clock, const Coefficients& coefficients,
                 const Excitation& excitation, Observer& observer, const Schedule& schedule)
      : Base(setting, clock, coefficients, excitation, observer), strobes_(schedule) {}

  [[nodiscard]] double time_resolution() const { return clock_.resolution(); }
  [[nodiscard]] double time_to_strobe() const { return clock_.until(strobes_.next()); }
  [[nodiscard]] double time_to_breakpoint() const {
    return breakpoint_ ? clock_.until(*breakpoint_) : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] const StrobeSchedule& strobes() const { return strobes_; }
  [[nodiscard]] const std::optional<Instant>& breakpoint() const { return breakpoint_; }
  [[nodiscard]] std::uint64_t slip_steps() const { return slip_steps_; }
  [[nodiscard]] std::uint64_t segments_looked_up() const { return segments_; }  ///< pieces of a ground motion expanded

  /// X at the end of the motion: at the last strobe instant, or where it ended before.
  [[nodiscard]] double final_slip() const {
    return this->termination() == Termination::reached_horizon ? slip_at_horizon_ : state_.slip;
  }

  /// mu_k in force over the coming step while the block slips; else 0.
  [[nodiscard]] double kinetic_friction() const { return kinetic_friction_; }

  /// After the last strobe point: continues for `more` of them, as if the run had been that long from the start.
  void extend(std::int64_t more) {
    strobes_.extend(more);
    this->go_on();
  }

  /// From now on the coefficients are these. The values in force stay the same until the next event or breakpoint.
  void continue_with(const Coefficients& coefficients) { coefficients_ = coefficients; }

  /// One step begins: counts it and the piece of the ground motion that it expands.
  void begin_step() {
    count_step();
    count_segments(1);
  }

  /// The step ends `duration` later in the state `next`.
  void end_step(double duration, const State& next) {
    if (!(duration > 0.0)) return stand_still();
    state_ = next;
    clock_.advance(duration);
    continuity_ = Continuity::after_a_step();
    known_ = known_.after_a_step();
    this->note_balance();
  }

  /// A step in which a block at rest stays so up to the next breakpoint.
  void rest_until_breakpoint() {
    begin_step();
    const double last_strobe = time_to_breakpoint() - clock_.resolution();
    while (!this->ended() && time_to_strobe() < last_strobe) pass_strobe(state_);
    if (this->ended()) return;
    arrive_at_rest(*breakpoint_, Contact::to_be_checked);  // the base acceleration may jump there
  }

  /// As many such steps as there are samples, none of which the block leaves full contact at or passes a strobe instant
  /// before.
  void rest_over(const SamplesPassed& samples) {
    strobes_.set_steps_since_last(strobes_.steps_since_last() + static_cast<std::int64_t>(samples.count));
    count_segments(samples.count);
    arrive_at_rest(samples.last, Contact::stays);
  }

  /// The block passes a strobe instant in this state.
  void pass_strobe(const State& sample) {
    this->observer().strobe(sample);
    strobes_.pass();
    if (strobes_.left() > 0) return;
    slip_at_horizon_ = sample.slip;
    this->end(Termination::reached_horizon);
  }

  /// What follows at the end of a step. `fired` is indexed by Guard.
  template <class Fired>
  void reset(const Fired& fired, bool at_breakpoint) {
    if (fired.none() && !at_breakpoint) return;
    known_ = {};
    if (at_breakpoint) clock_.set(*breakpoint_);
    this->respond(
        Firing<Fired>{.fired = fired, .at_breakpoint = at_breakpoint, .time_went_on = continuity_.time_went_on()});
    settle();
  }

  /// Continues at the end of such steps. At the start of each, nothing was known but the state.
  void take_over(const StepsElsewhere& steps) {
    state_ = steps.state;
    clock_.set(steps.now);
    strobes_.set_steps_since_last(steps.since_strobe);
    count_segments(steps.count);
    if (steps.count == 0) return;
    if (this->slips()) slip_steps_ += steps.count;
    continuity_ = Continuity::after_a_step();
  }

  /// After steps that have passed breakpoints.
  void pass_breakpoints(Contact contact) {
    if (contact == Contact::to_be_checked) this->check_contact();
    settle();
  }

  /// After take_over: those steps have passed `count` intervals of KnowsComingCoefficients::known_intervals.
  void pass_intervals(std::size_t count) { coefficients_.pass_intervals(clock_, count); }

  /// After take_over: those steps have ended with an impact, which does no more than Landing::change_edges.
  void rebound(double tilt_rate) {
    this->change_edges(tilt_rate);
    settle();
  }

 protected:
  void count_step() {
    strobes_.count_step();
    if (strobes_.steps_since_last() > step_budget) this->end(Termination::stopped);
    if (this->slips()) ++slip_steps_;
  }

  void count_segments(std::uint64_t expansions) {
    if (excitation_.has_knots()) segments_ += expansions;
  }

  void stand_still() {
    continuity_ = continuity_.after_a_standstill();
    if (continuity_.standstills > most_events_at_once) this->end(Termination::stopped);
  }

  /// After events: finds the friction in force and the next breakpoint.
  void settle() {
    this->set_peaks({.tilt = peaks::larger(peaks_.tilt, std::abs(state_.tilt)),
                     .tilt_rate = peaks::larger(peaks_.tilt_rate, std::abs(state_.tilt_rate))});
    if (this->ended()) return;
    kinetic_friction_ = this->slips() ? coefficients_.kinetic_friction(clock_) : 0.0;
    breakpoint_ = earlier(coefficients_.next_change(clock_, this->slips()), excitation_.next_change(clock_));
    continuity_ = continuity_.after_events();
  }

  Continuity continuity_;

  /// Steps that the block may make before the next strobe point.
  [[nodiscard]] std::size_t steps_left() const {
    return static_cast<std::size_t>(std::max<std::int64_t>(0, step_budget - strobes_.steps_since_last()));
  }

  /// The next strobe instant or change of a coefficient.
  [[nodiscard]] Instant next_interruption() const {
    return *earlier(coefficients_.next_change(clock_, this->slips()), strobes_.next());
  }

 private:
  static constexpr std::int64_t most_events_at_once = 1'000;

  void arrive_at_rest(const Instant& instant, Contact contact) {
    clock_.set(instant);
    known_ = {};
    continuity_ = Continuity::after_a_step();
    pass_breakpoints(contact);
  }

  [[nodiscard]] std::optional<Instant> earlier(const std::optional<Instant>& a, const std::optional<Instant>& b) const {
    if (!a || !b) return a ? a : b;
    return clock_.until(*a) < clock_.until(*b) ? a : b;
  }

  StrobeSchedule strobes_;
  std::uint64_t slip_steps_ = 0;
  std::uint64_t segments_ = 0;
  std::optional<Instant> breakpoint_;  ///< the equations hold until then
  double kinetic_friction_ = 0.0;
  double slip_at_horizon_ = 0.0;
};

}  // namespace rocking::dynamics
