#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "rocking/dynamics/armed_guards.hpp"
#include "rocking/dynamics/motion_course.hpp"
#include "rocking/dynamics/peaks.hpp"
#include "rocking/dynamics/step_checks.hpp"
#include "rocking/dynamics/step_series.hpp"

namespace rocking::dynamics {

/// Whether a step must end so soon that a lower order may do.
[[nodiscard]] inline bool is_brief(const Clock& clock, double reach) {
  return reach <= brief_step * clock.period_length();
}

/// The coming step of a motion: its series, and what they say at its start. `Steps`: see BlockMotion.
template <class Steps>
class PreparedStep {
 public:
  explicit PreparedStep(Steps steps) : series_(steps) {}

  [[nodiscard]] const StepSeries<Steps>& series() const { return series_; }

  /// Prepares the step; returns its length. After a reset the forces may have jumped: it is checked whether the block
  /// still presses on the base, and whether the equations still have a solution.
  template <CoefficientSource Coefficients>
  [[nodiscard]] double prepare(MotionCourse<Coefficients>& course, double reach) {
    const double length = expand(course, reach);
    out_of_reach_ = guards_out_of_reach(course, length);
    if (course.progress.continuity.after_reset) check_validity(course, series_.rows());
    return length;
  }

  /// Fills the series as far as the coming step needs it; returns the step's length.
  template <CoefficientSource Coefficients>
  [[nodiscard]] double expand(MotionCourse<Coefficients>& course, double reach) {
    const Clock& clock = course.context.clock;
    const double near = std::min(reach, time_beyond_cell(course.context));
    if (is_brief(clock, near) && expand_to<brief_order>(course) >= near) return near;
    return std::min({expand_to<full_order>(course), reach, clock.period_length()});
  }

  /// Which guards are armed over the step.
  template <CoefficientSource Coefficients>
  [[nodiscard]] ArmedGuards armed_guards(const MotionCourse<Coefficients>& course) const {
    const auto& [context, automaton, progress] = course;
    return {.state = context.state,
            .setting = context.setting,
            .known = context.known,
            .order = series_.order(),
            .side = frame_side(context.state),
            .mu_s = context.coefficients.static_friction(),
            .is_past_balance = automaton.was_past_balance(),
            .off_ground = automaton.is_off_ground(),
            .has_friction = context.coefficients.has_friction(),
            .vertical = context.excitation.has_vertical(),
            .determinant_can_vanish = determinant_may_vanish(context.setting, progress.kinetic_friction()),
            .cell_end = context.cell_end(),
            .out_of_reach = out_of_reach_};
  }

  /// The motion goes to the state `next` at time x of the step.
  template <CoefficientSource Coefficients>
  void note_peaks(MotionContext<Coefficients>& context, double x, const State& next) const {
    const State& state = context.state;
    if (!is_rocking(state.contact)) return;
    const StepFinish<double> end{.length = x, .tilt = state.side * next.tilt, .tilt_rate = state.side * next.tilt_rate};
    const TiltPeaks<double> kept{.tilt = context.peaks.tilt, .tilt_rate = context.peaks.tilt_rate};
    const auto before = with_constants(context.setting, state.side,
                                       [&](const auto& constants) { return peaks_on_side(kept, constants); });
    if (!may_raise<double>(series_.rows(), end, before)) return;
    const auto after = peaks_after<double>(series_.rows(), static_cast<std::size_t>(series_.order()), end, before);
    context.set_peaks(with_constants(context.setting, state.side, [&](const auto& constants) {
      return peaks_to_keep(kept, before, after, constants);
    }));
  }

 private:
  /// A time in which the block has probably left its cell of friction; infinite without cells.
  template <CoefficientSource Coefficients>
  [[nodiscard]] static double time_beyond_cell(const MotionContext<Coefficients>& context) {
    const State& state = context.state;
    const auto end = context.cell_end();
    if (!end || state.slip_rate == 0.0) return std::numeric_limits<double>::infinity();
    constexpr double margin = 1.1;
    return margin * std::abs((*end - state.slip) / state.slip_rate) + context.clock.resolution();
  }

  template <int order, CoefficientSource Coefficients>
  double expand_to(MotionCourse<Coefficients>& course) {
    MotionContext<Coefficients>& context = course.context;
    course.progress.count_segments(context.excitation, 1);
    return series_.template expand<order>({.setting = context.setting,
                                           .state = context.state,
                                           .clock = context.clock,
                                           .amplitude = context.base_amplitude(),
                                           .kinetic_friction = course.progress.kinetic_friction(),
                                           .lift_starts_flat = context.known.lift_is_flat,
                                           .slip_starts_flat = context.known.slip_is_flat},
                                          context.excitation);
  }

  StepSeries<Steps> series_;
  OutOfReach<bool> out_of_reach_{};  ///< over the step
};

}  // namespace rocking::dynamics
