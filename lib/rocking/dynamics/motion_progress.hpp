#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/known_at_start.hpp"
#include "rocking/dynamics/motion_context.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/dynamics/peaks.hpp"

namespace rocking::dynamics {

/// How far a motion has come: its strobe points, its next breakpoint and the counts of its steps.
class MotionProgress {
 public:
  explicit MotionProgress(const Schedule& schedule) : strobes(schedule) {}

  [[nodiscard]] double time_to_strobe(const Clock& clock) const { return clock.until(strobes.next()); }
  [[nodiscard]] double time_to_breakpoint(const Clock& clock) const {
    return breakpoint_ ? clock.until(*breakpoint_) : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] const std::optional<Instant>& breakpoint() const { return breakpoint_; }
  [[nodiscard]] double kinetic_friction() const { return kinetic_friction_; }
  [[nodiscard]] double slip_at_horizon() const { return slip_at_horizon_; }
  [[nodiscard]] std::uint64_t slip_steps() const { return slip_steps_; }
  [[nodiscard]] std::uint64_t segments() const { return segments_; }

  /// The next strobe instant or change of a coefficient.
  template <CoefficientSource Coefficients>
  [[nodiscard]] Instant next_interruption(const MotionContext<Coefficients>& context) const {
    return *earlier(context.clock, context.coefficients.next_change(context.clock, context.slips()), strobes.next());
  }

  /// Steps that the block may make before the next strobe point.
  [[nodiscard]] std::size_t steps_left() const {
    return static_cast<std::size_t>(std::max<std::int64_t>(0, step_budget - strobes.steps_since_last()));
  }

  template <CoefficientSource Coefficients>
  void count_step(MotionContext<Coefficients>& context) {
    strobes.count_step();
    if (strobes.steps_since_last() > step_budget) context.end(Termination::stopped);
    count_slip_steps(context, 1);
  }

  template <CoefficientSource Coefficients>
  void count_slip_steps(const MotionContext<Coefficients>& context, std::uint64_t steps) {
    if (context.slips()) slip_steps_ += steps;
  }

  /// Counts pieces of a ground motion that are expanded.
  void count_segments(const Excitation& excitation, std::uint64_t expansions) {
    if (excitation.has_knots()) segments_ += expansions;
  }

  /// A step in which no time goes on.
  template <CoefficientSource Coefficients>
  void stand_still(MotionContext<Coefficients>& context) {
    continuity = continuity.after_a_standstill();
    if (continuity.standstills > most_events_at_once) context.end(Termination::stopped);
  }

  /// The block passes a strobe instant in this state.
  template <CoefficientSource Coefficients>
  void pass_strobe(MotionContext<Coefficients>& context, const State& sample) {
    context.observer().strobe(sample);
    strobes.pass();
    if (strobes.left() > 0) return;
    slip_at_horizon_ = sample.slip;
    context.end(Termination::reached_horizon);
  }

  /// After events: finds the friction in force and the next breakpoint.
  template <CoefficientSource Coefficients>
  [[gnu::always_inline]] inline void settle(MotionContext<Coefficients>& context) {
    const Geometry& block = context.setting.block;
    double scale = 1.0;
    if (!block.is_rectangle()) [[unlikely]]
      scale = block.edge(context.state.side).tilt_scale;
    context.set_peaks({.tilt = peaks::larger(context.peaks.tilt, scale * std::abs(context.state.tilt)),
                       .tilt_rate = peaks::larger(context.peaks.tilt_rate, scale * std::abs(context.state.tilt_rate))});
    if (context.ended()) return;
    const Clock& clock = context.clock;
    kinetic_friction_ = context.slips() ? context.kinetic_friction() : 0.0;
    breakpoint_ =
        earlier(clock, context.coefficients.next_change(clock, context.slips()), context.excitation.next_change(clock));
    continuity = continuity.after_events();
  }

  StrobeSchedule strobes;
  Continuity continuity;

 private:
  static constexpr std::int64_t most_events_at_once = 1'000;

  [[nodiscard]] static std::optional<Instant> earlier(const Clock& clock, const std::optional<Instant>& a,
                                                      const std::optional<Instant>& b) {
    if (!a || !b) return a ? a : b;
    return clock.until(*a) < clock.until(*b) ? a : b;
  }

  std::uint64_t slip_steps_ = 0;
  std::uint64_t segments_ = 0;
  std::optional<Instant> breakpoint_;  ///< the equations hold until then
  double kinetic_friction_ = 0.0;      ///< mu_k in force over the coming step while the block slips; else 0
  double slip_at_horizon_ = 0.0;       ///< X
};

}  // namespace rocking::dynamics
