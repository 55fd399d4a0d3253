#pragma once

#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "rocking/dynamics/coefficients.hpp"
#include "rocking/dynamics/impact.hpp"
#include "rocking/dynamics/motion_course.hpp"
#include "rocking/dynamics/small_hop.hpp"
#include "rocking/lanes/lane_values.hpp"

namespace rocking::lanes {

/// A motion with tangent vectors (rocking::TangentMotion).
template <class Motion>
concept HasTangents = requires(Motion& motion) {
  motion.tangents();
};

/// What the lanes need of a motion (dynamics::BlockMotion): the numbers of its coming step, and the consequences of
/// steps that a lane has computed. The motion itself does not know lanes.
template <class Motion>
class MotionAdapter {
 public:
  explicit MotionAdapter(Motion& motion) : motion_(motion) {}

  /// Whether a lane can compute the coming step.
  [[nodiscard]] bool has_ordinary_step() const {
    if constexpr (HasTangents<Motion>) {
      const dynamics::Excitation& shaking = motion_.excitation();
      if (!shaking.is_periodic() || shaking.has_vertical() || motion_.restarts()) return false;
    }
    return !motion_.ended() && motion_.armed_guards().is_ordinary();
  }

  [[nodiscard]] ComingStep coming_step() {
    const dynamics::State& state = motion_.state();
    const dynamics::Setting& setting = motion_.setting();
    auto& [context, automaton, progress] = motion_.course();
    const double side = state.side;
    const double restitution = constant_restitution();
    return {.setting = &setting,
            .clock = &motion_.clock(),
            .state = {.tilt = side * state.tilt,
                      .tilt_rate = side * state.tilt_rate,
                      .slip = side * state.slip,
                      .slip_rate = side * state.slip_rate},
            .side = side,
            .amplitude = side * context.base_amplitude(),
            .static_friction = motion_.coefficients().static_friction(),
            .kinetic_friction = motion_.kinetic_friction(),
            .restitution = restitution,
            .impact_loss = dynamics::impact_loss(restitution, setting.block),
            .least_rebound = dynamics::fastest_small_hop(context),
            .slip_sign = side * state.slip_direction,
            .next_strobe = progress.strobes.next(),
            .strobes_left = progress.strobes.left(),
            .steps_since_strobe = progress.strobes.steps_since_last(),
            .breakpoint = progress.breakpoint().value_or(never),
            .coefficients_change = coefficients_change(),
            .excitation = &motion_.excitation(),
            .peaks = {.tilt = motion_.peaks().tilt, .tilt_rate = motion_.peaks().tilt_rate}};
  }

  /// The coming intervals of the friction grid, if the steps of a rock-slide stay ordinary and brief in them; else
  /// none. Each interval ends at a boundary of the grid (dynamics::grid_boundary), so there are none while the base
  /// motion has a breakpoint to come.
  [[nodiscard]] dynamics::KnownIntervals known_intervals() const {
    if constexpr (knows_coming_coefficients) {
      if (motion_.excitation().has_knots() || motion_.excitation().next_change(motion_.clock())) return {};
      const double mu_s = motion_.coefficients().static_friction();  // mu_k <= mu_s
      if (dynamics::determinant_may_vanish(motion_.setting(), mu_s)) return {};
      const dynamics::KnownIntervals known = motion_.coefficients().known_intervals();
      if (static_cast<double>(known.per_period) * dynamics::brief_step > 1.0) return known;
    }
    return {};
  }

  /// A strobe instant has been passed in a lane.
  void pass_strobe(const SideState& sample) {
    auto& course = motion_.course();
    course.progress.pass_strobe(course.context, from_frame(sample));
  }

  /// An impact at the end of a lane's steps, which sticks and ends no chatter. `progress` is in the frame of the new
  /// side.
  void pass_impact(const LaneProgress& progress) {
    const double rate_after = -motion_.state().side * progress.state.tilt_rate;
    take_over(motion_.course(), {.state = motion_.state(),
                                 .now = progress.now,
                                 .count = progress.steps,
                                 .since_strobe = progress.steps_since_strobe});
    rebound(motion_.course(), rate_after);
  }

  /// The motion continues where its lane has come to.
  void catch_up(const LaneProgress& progress) {
    dynamics::MotionContext<Coefficients>& context = motion_.course().context;
    context.set_peaks(progress.peaks);
    take_over(motion_.course(), {.state = from_frame(progress.state),
                                 .now = progress.now,
                                 .count = progress.steps,
                                 .since_strobe = progress.steps_since_strobe});
    if constexpr (knows_coming_coefficients) {
      if (progress.intervals > 0) context.coefficients.pass_intervals(context.clock, progress.intervals);
    }
    if (progress.breakpoints == 0) return;
    pass_breakpoints(motion_.course(),
                     progress.at_breakpoint ? dynamics::Contact::to_be_checked : dynamics::Contact::stays);
  }

  /// A step of a lane in which an event may occur. `fired` is indexed by dynamics::Guard.
  template <class Fired>
  void finish_step(const StepEnd& end, const Fired& fired) {
    begin_step(motion_.course());
    const bool at_breakpoint = end.duration >= motion_.time_to_breakpoint() - motion_.time_resolution();
    if (end.strobe) pass_strobe(*end.strobe);
    if (end.duration > 0.0) restart(end.state);
    end_step(motion_.course(), end.duration, from_frame(end.state));
    motion_.reset(fired, at_breakpoint);
  }

  /// After a strobe instant, in the state `now` at the end of its step.
  void restart(const SideState& now) {
    if constexpr (HasTangents<Motion>) motion_.restart_in(from_frame(now));
  }

  /// A step of a lane in which the last strobe instant comes before any event. The motion ends where the step began.
  void finish_at_strobe(const SideState& sample) {
    begin_step(motion_.course());
    pass_strobe(sample);
  }

 private:
  using Coefficients = std::remove_cvref_t<decltype(std::declval<Motion&>().coefficients())>;
  static constexpr bool knows_coming_coefficients = dynamics::KnowsComingCoefficients<Coefficients>;

  /// NaN also with tangent vectors, which are multiplied by a saltation matrix at an impact.
  [[nodiscard]] double constant_restitution() const {
    if constexpr (knows_coming_coefficients && !HasTangents<Motion>) {
      if (const std::optional<double> restitution = motion_.coefficients().constant_restitution()) return *restitution;
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

  /// The next breakpoint that is not the base motion's; needed only where the base motion has breakpoints.
  [[nodiscard]] dynamics::Instant coefficients_change() const {
    if (!motion_.excitation().has_knots()) return never;
    return motion_.coefficients().next_change(motion_.clock(), motion_.slips()).value_or(never);
  }

  [[nodiscard]] dynamics::State from_frame(const SideState& lane) const {
    dynamics::State state = motion_.state();
    state.tilt = state.side * lane.tilt;
    state.tilt_rate = state.side * lane.tilt_rate;
    if (motion_.slips()) {
      state.slip = state.side * lane.slip;
      state.slip_rate = state.side * lane.slip_rate;
    }
    return state;
  }

  Motion& motion_;
};

template <class Motion>
[[nodiscard]] MotionAdapter<Motion> adapt(Motion& motion) {
  return MotionAdapter<Motion>(motion);
}

}  // namespace rocking::lanes
