#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "rocking/dynamics/armed_guards.hpp"
#include "rocking/dynamics/motion_course.hpp"
#include "rocking/dynamics/prepared_step.hpp"
#include "rocking/dynamics/resting.hpp"
#include "rocking/dynamics/tangent.hpp"

namespace rocking::dynamics {

/// A block on a moving base as a hybrid system: smooth pieces as Taylor polynomials, guards as polynomials, resets by
/// the automaton. Models integrate::HybridSystem, without knowing an integrator.
///
/// `Steps` turns the last two terms of a series into the length of a step: double(last_but_one, last, order, largest).
/// A copy continues independently of the original.
template <CoefficientSource Coefficients, class Steps>
class BlockMotion {
 public:
  BlockMotion(const Setting& setting, const Clock& clock, const Coefficients& coefficients, const State& initial,
              const Schedule& schedule, Observer& observer, const Excitation& excitation = {}, Steps steps = {})
      : course_{.context = MotionContext<Coefficients>(setting, clock, coefficients, excitation, observer),
                .automaton = Automaton(std::abs(initial.tilt) >= setting.block.edge(initial.tilt).shape_angle),
                .progress = MotionProgress(schedule)},
        step_(steps) {
    enter(context(), initial);
    progress().settle(context());
  }

  // The block and its base now.

  [[nodiscard]] const Setting& setting() const { return context().setting; }
  [[nodiscard]] const State& state() const { return context().state; }
  [[nodiscard]] const Clock& clock() const { return context().clock; }
  [[nodiscard]] const Coefficients& coefficients() const { return context().coefficients; }
  [[nodiscard]] const Excitation& excitation() const { return context().excitation; }
  [[nodiscard]] bool slips() const { return context().slips(); }
  [[nodiscard]] std::optional<double> cell_end() const { return context().cell_end(); }
  [[nodiscard]] BaseMotion base_motion() { return context().base_motion(); }
  [[nodiscard]] bool is_off_ground() const { return automaton().is_off_ground(); }  ///< N <= 0
  /// mu_k in force over the coming step while the block slips; else 0.
  [[nodiscard]] double kinetic_friction() const { return progress().kinetic_friction(); }

  // What has happened.

  [[nodiscard]] std::optional<Termination> termination() const { return context().termination(); }
  [[nodiscard]] bool ended() const { return context().ended(); }
  [[nodiscard]] std::uint64_t contradictions() const { return context().contradictions; }
  [[nodiscard]] const Peaks& peaks() const { return context().peaks; }
  [[nodiscard]] bool was_past_balance() const { return automaton().was_past_balance(); }
  [[nodiscard]] std::uint64_t losses_of_contact() const { return automaton().contact().losses(); }
  /// Of these, the losses before the final fall. That fall begins when abs(Theta) exceeds 1 for the last time in a
  /// motion that overturns; a loss of contact in it cannot change what follows any more.
  [[nodiscard]] std::uint64_t losses_before_fall() const {
    const bool has_fallen = termination() == Termination::overturned;
    return losses_of_contact() - (has_fallen ? automaton().contact().since_balance() : 0);
  }
  [[nodiscard]] double first_loss_of_contact() const {
    return automaton().contact().first();
  }  ///< tau, if there is one
  [[nodiscard]] std::uint64_t slip_steps() const { return progress().slip_steps(); }
  [[nodiscard]] std::uint64_t segments_looked_up() const { return progress().segments(); }  ///< of a ground motion
  /// X at the end of the motion: at the last strobe instant, or where it ended before.
  [[nodiscard]] double final_slip() const {
    return termination() == Termination::reached_horizon ? progress().slip_at_horizon() : state().slip;
  }

  // The parts of integrate::HybridSystem, in the order of a step.

  /// Makes the coming steps in which a block at rest stays so; returns their number. See resting.hpp.
  std::uint64_t rest_below_threshold() { return dynamics::rest_below_threshold(course_); }

  [[nodiscard]] double time_resolution() const { return clock().resolution(); }
  [[nodiscard]] double time_to_strobe() const { return progress().time_to_strobe(clock()); }
  [[nodiscard]] double time_to_breakpoint() const { return progress().time_to_breakpoint(clock()); }

  /// The series of the coming step; returns its length.
  [[nodiscard]] double expand(double reach) {
    progress().count_step(context());
    const double length = step_.prepare(course_, reach);
    if (!(length > least_step * time_resolution()) && reach > length) end_without_step(course_);
    return length;
  }

  /// Calls visit(number, coefficients) for each guard that is armed and in the set.
  template <class Guards, class Visitor>
  void for_each_guard(const Guards& wanted, Visitor&& visit) const {
    visit_guards(
        armed_guards(), series().rows(), [&wanted](std::size_t guard) { return wanted[guard]; }, visit);
  }

  /// Passes a strobe instant at time x of the step.
  void strobe(double x) {
    const State sample = state_at(x);
    if (!is_finite(sample)) return end_without_step(course_);
    progress().pass_strobe(context(), sample);
    if (ended()) step_.note_peaks(context(), x, sample);
  }

  /// Ends the step at its time x.
  void move(double x) {
    if (!(x > 0.0)) return progress().stand_still(context());
    const State next = state_at(x);
    if (!is_finite(next)) return end_without_step(course_);
    step_.note_peaks(context(), x, next);
    end_step(course_, x, next);
  }

  /// What follows at the end of a step. `fired` is indexed by Guard.
  template <class Fired>
  void reset(const Fired& fired, bool at_breakpoint) {
    dynamics::reset(course_, fired, at_breakpoint);
  }

  // The step that `expand` has prepared last.

  [[nodiscard]] const StepSeries<Steps>& series() const { return step_.series(); }
  [[nodiscard]] State state_at(double x) const { return series().state_at(x, state()); }
  [[nodiscard]] BaseMotion base_at(double x) const { return series().base_at(x, state()); }

  /// Whether the coming step must end so soon that a lower order may do.
  [[nodiscard]] bool is_brief() const { return dynamics::is_brief(clock(), time_to_breakpoint()); }
  /// Which guards are armed over the coming step.
  [[nodiscard]] ArmedGuards armed_guards() const { return step_.armed_guards(course_); }

  // Changes from outside.

  /// From now on, reports events and strobe points to `observer`.
  void observe_with(Observer& observer) { context().observe_with(observer); }
  /// From now on, looks for no peaks.
  void ignore_peaks() { context().peaks = Peaks::unwanted(); }
  /// From now on the coefficients are these. The values in force stay the same until the next event or breakpoint.
  void continue_with(const Coefficients& coefficients) { context().coefficients = coefficients; }

  /// After the last strobe point: continues for `more` of them, as if the run had been that long from the start.
  void extend(std::int64_t more) {
    progress().strobes.extend(more);
    context().go_on();
  }

  /// After the last strobe point: moves to its instant.
  void move_to_last_strobe() {
    const double past = clock().until(progress().strobes.last());
    if (past <= time_resolution()) return;
    // The series of the step in which the run ended; a lane may have computed that step.
    static_cast<void>(step_.expand(course_, time_to_breakpoint()));
    move(past);
    progress().settle(context());
  }

  /// After move_to_last_strobe: continues for `more` strobe points under other circumstances. The state stays as it is,
  /// including the contact state where that can stay; `clock` says at which instant of which period the base motion
  /// continues.
  void go_on_under(const Setting& setting, const Clock& clock, const Coefficients& coefficients,
                   const Excitation& excitation, std::int64_t more) {
    dynamics::go_on_under(course_, setting, clock, coefficients, excitation, more);
  }

  /// Displaces the state, within its contact state, by `wanted`; returns the displacement made.
  Displacement displace(const Displacement& wanted) {
    const Displacement done =
        dynamics::displace(context().state, wanted, setting().block.edge(state().side).shape_angle);
    progress().settle(context());
    return done;
  }

  /// For steps that the lanes compute (StepsElsewhere).
  [[nodiscard]] MotionCourse<Coefficients>& course() { return course_; }
  [[nodiscard]] const MotionCourse<Coefficients>& course() const { return course_; }

 private:
  [[nodiscard]] static bool is_finite(const State& state) {
    return std::isfinite(state.tilt) && std::isfinite(state.tilt_rate) && std::isfinite(state.slip) &&
           std::isfinite(state.slip_rate);
  }

  [[nodiscard]] MotionContext<Coefficients>& context() { return course_.context; }
  [[nodiscard]] const MotionContext<Coefficients>& context() const { return course_.context; }
  [[nodiscard]] const Automaton& automaton() const { return course_.automaton; }
  [[nodiscard]] MotionProgress& progress() { return course_.progress; }
  [[nodiscard]] const MotionProgress& progress() const { return course_.progress; }

  MotionCourse<Coefficients> course_;
  PreparedStep<Steps> step_;
};

}  // namespace rocking::dynamics
