#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "rocking/dynamics/armed_guards.hpp"
#include "rocking/dynamics/displacement.hpp"
#include "rocking/dynamics/motion_progress.hpp"
#include "rocking/dynamics/peaks.hpp"
#include "rocking/dynamics/step_series.hpp"

namespace rocking::dynamics {

/// A block on a moving base as a hybrid system: smooth pieces as Taylor polynomials, guards as polynomials, resets by
/// the automaton. Models integrate::HybridSystem, without knowing an integrator.
///
/// `Steps` turns the last two terms of a series into the length of a step: double(last_but_one, last, order, largest).
/// A copy continues independently of the original.
template <CoefficientSource Coefficients, class Steps>
class BlockMotion : public MotionProgress<Coefficients> {
  using Base = MotionProgress<Coefficients>;
  using Base::clock_, Base::coefficients_, Base::excitation_, Base::known_, Base::setting_, Base::state_;

 public:
  BlockMotion(const Setting& setting, const Clock& clock, const Coefficients& coefficients, const State& initial,
              const Schedule& schedule, Observer& observer, const Excitation& excitation = {}, Steps steps = {})
      : Base(setting, clock, coefficients, excitation, observer, schedule), series_(steps) {
    this->enter(initial);
    this->settle();
  }

  /// Makes the coming steps in which a block at rest stays so, since the base acceleration between two
  /// samples of a ground motion is far below its threshold. Returns their number. They have the effects of other steps.
  std::uint64_t rest_below_threshold() {
    std::uint64_t steps = 0;
    while (stays_at_rest()) {
      const SamplesPassed samples = excitation_.samples_below(threshold_at_rest(), this->base_amplitude(),
                                                              this->next_interruption(), this->steps_left(), clock_);
      if (samples.count > 0) {
        this->rest_over(samples);
      } else {
        this->rest_until_breakpoint();
      }
      steps += std::max<std::size_t>(1, samples.count);
    }
    return steps;
  }

  /// The series of the coming step; returns its length.
  [[nodiscard]] double expand(double reach) {
    this->count_step();
    const double length = length_of_series(reach);
    out_of_reach_ = guards_out_of_reach(length);
    if (this->continuity_.after_reset) check_validity();
    if (!(length > least_step * clock_.resolution()) && reach > length) end_without_step();
    return length;
  }

  /// The series of the step that `expand` has prepared last.
  [[nodiscard]] const StepSeries<Steps>& series() const { return series_; }
  /// The state at time x of the step that `expand` has prepared.
  [[nodiscard]] State state_at(double x) const { return series_.state_at(x, state_); }
  /// The base motion at time x of the step that `expand` has prepared.
  [[nodiscard]] BaseMotion base_at(double x) const { return series_.base_at(x, state_); }

  /// Whether the coming step must end so soon that a lower order may do.
  [[nodiscard]] bool is_brief() const { return is_brief(this->time_to_breakpoint()); }

  /// Which guards are armed over the coming step.
  [[nodiscard]] ArmedGuards armed_guards() const {
    return {.state = state_,
            .setting = setting_,
            .known = known_,
            .order = series_.order(),
            .side = frame_side(state_),
            .mu_s = coefficients_.static_friction(),
            .is_past_balance = this->was_past_balance(),
            .off_ground = this->is_off_ground(),
            .has_friction = coefficients_.has_friction(),
            .vertical = excitation_.has_vertical(),
            .determinant_can_vanish = this->determinant_may_vanish(this->kinetic_friction()),
            .cell_end = this->cell_end(),
            .out_of_reach = out_of_reach_};
  }

  /// Calls visit(number, coefficients) for each guard that is armed and in the set.
  template <class Guards, class Visitor>
  void for_each_guard(const Guards& wanted, Visitor&& visit) const {
    visit_guards(
        armed_guards(), series_.rows(), [&wanted](std::size_t guard) { return wanted[guard]; }, visit);
  }

  /// Passes a strobe instant at time x of the step.
  void strobe(double x) {
    const State sample = state_at(x);
    if (!is_finite(sample)) return end_without_step();
    this->pass_strobe(sample);
    if (this->ended()) note_peaks(x, sample);
  }

  /// Ends the step at its time x.
  void move(double x) {
    if (!(x > 0.0)) return this->stand_still();
    const State next = state_at(x);
    if (!is_finite(next)) return end_without_step();
    note_peaks(x, next);
    this->end_step(x, next);
  }

  /// After the last strobe point: moves to its instant.
  void move_to_last_strobe() {
    const double past = clock_.until(this->strobes().last());
    if (past <= clock_.resolution()) return;
    // The series of the step in which the run ended; a lane may have computed that step.
    static_cast<void>(length_of_series(this->time_to_breakpoint()));
    move(past);
    this->settle();
  }

  /// After move_to_last_strobe: continues for `more` strobe points under other circumstances. The state stays as it is,
  /// including the contact state where that can stay; `clock` says at which instant of which period the base motion
  /// continues.
  void go_on_under(const Setting& setting, const Clock& clock, const Coefficients& coefficients, std::int64_t more) {
    this->replace(setting, clock, coefficients);
    known_ = {};
    this->find_cell();
    this->extend(more);
    this->check_contact();
    this->settle();
  }

  /// Displaces the state, within its contact state, by `wanted`; returns the displacement made.
  Displacement displace(const Displacement& wanted) {
    const Displacement done = dynamics::displace(state_, wanted, setting_.block.shape_angle);
    this->settle();
    return done;
  }

 private:
  /// Whether one step leads to the next breakpoint and a block at rest certainly stays so until then.
  [[nodiscard]] bool stays_at_rest() {
    if (state_.contact != ContactState::rest || this->ended() || !this->breakpoint()) return false;
    const double reach = this->time_to_breakpoint();
    if (!(reach > clock_.resolution()) || reach > clock_.period_length()) return false;
    return excitation_.largest_before_change(clock_, this->base_amplitude()) < threshold_at_rest();
  }

  /// A base acceleration, over g, below which a block at rest certainly stays so. The margin is far above the rounding of
  /// the base acceleration between two samples.
  [[nodiscard]] double threshold_at_rest() const {
    constexpr double margin = 1e-6;
    return (1.0 - margin) * std::min(coefficients_.static_friction(), setting_.block.tangent);
  }

  /// The motion goes to the state `next` at time x of the step.
  void note_peaks(double x, const State& next) {
    if (!is_rocking(state_.contact)) return;
    const StepFinish<double> end{
        .length = x, .tilt = state_.side * next.tilt, .tilt_rate = state_.side * next.tilt_rate};
    const TiltPeaks<double> before{.tilt = this->peaks().tilt, .tilt_rate = this->peaks().tilt_rate};
    if (!may_raise<double>(series_.rows(), end, before)) return;
    this->set_peaks(peaks_after<double>(series_.rows(), static_cast<std::size_t>(series_.order()), end, before));
  }

  [[nodiscard]] static bool is_finite(const State& state) {
    return std::isfinite(state.tilt) && std::isfinite(state.tilt_rate) && std::isfinite(state.slip) &&
           std::isfinite(state.slip_rate);
  }

  [[nodiscard]] bool is_brief(double reach) const { return reach <= brief_step * clock_.period_length(); }

  /// Fills the series as far as the coming step needs it; returns the step's length.
  [[nodiscard]] double length_of_series(double reach) {
    const double near = std::min(reach, time_beyond_cell());
    if (is_brief(near) && expand_to<brief_order>() >= near) return near;
    return std::min({expand_to<full_order>(), reach, clock_.period_length()});
  }

  /// A time in which the block has probably left its cell of friction; infinite without cells.
  [[nodiscard]] double time_beyond_cell() const {
    const auto end = this->cell_end();
    if (!end || state_.slip_rate == 0.0) return std::numeric_limits<double>::infinity();
    constexpr double margin = 1.1;
    return margin * std::abs((*end - state_.slip) / state_.slip_rate) + clock_.resolution();
  }

  template <int order>
  double expand_to() {
    this->count_segments(1);
    return series_.template expand<order>({.setting = setting_,
                                           .state = state_,
                                           .clock = clock_,
                                           .amplitude = this->base_amplitude(),
                                           .kinetic_friction = this->kinetic_friction(),
                                           .lift_starts_flat = known_.lift_is_flat,
                                           .slip_starts_flat = known_.slip_is_flat},
                                          excitation_);
  }

  [[nodiscard]] OutOfReach<bool> guards_out_of_reach(double length) {
    const bool may_hop = this->is_off_ground() || known_.normal_is_zero;
    const bool is_excluded = state_.contact != ContactState::rock || this->was_past_balance() || may_hop;
    if (is_excluded || excitation_.has_vertical()) return {};
    return out_of_reach<double>({.tilt = state_.side * state_.tilt,
                                 .tilt_rate = state_.side * state_.tilt_rate,
                                 .base_amplitude = excitation_.most_horizontal(this->base_amplitude()),
                                 .length = length},
                                equation_constants(setting_));
  }

  /// A reset makes the forces jump: whether the block still presses on the base, and the equations still have a
  /// solution.
  void check_validity() {
    const MotionSeries<double>& rows = series_.rows();
    if (state_.contact == ContactState::rock_slide && this->determinant_may_vanish(this->kinetic_friction())) {
      const double determinant = setting_.inertia + rows.sine[0] * rows.arm[0];
      if (determinant <= 0.0) this->end(Termination::painleve);
    }
    if (known_.normal_is_zero) return;
    // In full contact N = (4/3)(1 + alpha_v).
    const bool has_no_weight = excitation_.has_vertical() && rows.weight[0] <= 0.0;
    this->set_off_ground(is_rocking(state_.contact) ? rows.normal[0] <= 0.0 : has_no_weight);
  }

  /// The series does not continue the motion: it diverges near D = 0, or a number in it is not finite.
  void end_without_step() {
    const bool near_painleve =
        state_.contact == ContactState::rock_slide && this->determinant_may_vanish(this->kinetic_friction());
    this->end(near_painleve ? Termination::painleve : Termination::stopped);
  }

  StepSeries<Steps> series_;
  OutOfReach<bool> out_of_reach_{};  ///< over the coming step
};

}  // namespace rocking::dynamics
