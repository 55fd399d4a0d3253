#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "rocking/integrate/hybrid.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/lanes/lane_state.hpp"
#include "rocking/lanes/motion_adapter.hpp"
#include "rocking/lanes/tangent_rows.hpp"
#include "rocking/lanes/transfer.hpp"

namespace rocking::lanes {

/// What the steps in the lanes of one group have in common.
struct StepKind {
  std::size_t family = 0;  ///< form of the block and kind of the base motion: see family_of
  Kind kind = Kind::rock;

  [[nodiscard]] std::size_t index() const { return family * kind_count + static_cast<std::size_t>(kind); }
  friend bool operator==(const StepKind&, const StepKind&) = default;
};
inline constexpr std::size_t step_kind_count = families * kind_count;

/// The kind with this index().
[[nodiscard]] constexpr StepKind step_kind(std::size_t index) {
  return {.family = index / kind_count, .kind = static_cast<Kind>(index % kind_count)};
}

/// The kind of the coming step; empty if no lane can compute it.
template <class Motion>
[[nodiscard]] std::optional<StepKind> kind_of(Motion& motion) {
  if (!adapt(motion).has_ordinary_step()) return std::nullopt;
  const bool is_brief = motion.is_brief();
  const Kind kind = motion.slips() ? (is_brief ? Kind::rock_slide_briefly : Kind::rock_slide)
                    : motion.coefficients().has_friction()
                        ? (is_brief ? Kind::rock_with_friction_briefly : Kind::rock_with_friction)
                        : (is_brief ? Kind::rock_briefly : Kind::rock);
  return StepKind{family_of(motion.setting().block.form, motion.excitation().index()), kind};
}

/// Runs of a kind: those in lanes, and those that wait for a lane. It transfers data between a lane and its run.
template <class Run>
class LaneGroup {
 public:
  [[nodiscard]] LaneState& state() { return *state_; }
  [[nodiscard]] std::uint32_t occupied() const { return occupied_; }
  [[nodiscard]] Run& run(std::size_t lane) const { return *runs_[lane]; }

  void wait(Run& run) {
    if (!state_) make_state();
    waiting_.push_back(&run);
  }
  [[nodiscard]] bool has_waiting() const { return !waiting_.empty(); }

  /// Puts the run that waited for the shortest time into a free lane.
  void fill(std::size_t lane) {
    runs_[lane] = waiting_.back();
    waiting_.pop_back();
    occupied_ |= 1U << lane;
    const ComingStep step = adapt(run(lane).motion()).coming_step();
    load(*state_, lane, step);
    load_known_intervals(lane, step);
    load_tangents(lane);
  }

  /// The run continues in its lane after an event or a breakpoint.
  void stay(std::size_t lane) {
    const ComingStep step = adapt(run(lane).motion()).coming_step();
    load_step(*state_, lane, step);
    load_known_intervals(lane, step);
    load_tangents(lane);
  }

  void vacate(std::size_t lane) {
    occupied_ &= ~(1U << lane);
    state_->occupied[lane] = 0.0;
  }

  void pass_strobe(std::size_t lane) {
    auto& motion = run(lane).motion();
    if constexpr (has_tangents) {
      motion.set_tangents(vectors_of(*tangents_, tangents_->now, lane));
      motion.set_at_strobe(vectors_of(*tangents_, tangents_->at_strobe, lane));
    }
    adapt(motion).pass_strobe(strobe_point(*state_, lane));
    if constexpr (has_tangents) {
      adapt(motion).restart(progress(*state_, lane).state);
      load_tangents(lane);
    }
  }

  void pass_impact(std::size_t lane) {
    const LaneProgress here = progress(*state_, lane);
    run(lane).counts().steps += here.steps;
    state_->steps[lane] = 0.0;
    adapt(run(lane).motion()).pass_impact(here);
  }

  /// The run takes over the steps that its lane has computed. Steps on the friction grid pass a breakpoint each.
  /// `at_breakpoint`: the lane is at a breakpoint at which its motion must continue.
  void catch_up(std::size_t lane, const StepKind& kind, bool at_breakpoint) {
    auto& motion = run(lane).motion();
    LaneProgress here = progress(*state_, lane);
    run(lane).counts().steps += here.steps;
    run(lane).counts().root_isolations += count(state_->root_isolations[lane]);
    if (motion.excitation().has_knots()) {
      here.breakpoints = count(state_->breakpoints[lane]);
    } else if (kind.kind == Kind::rock_slide_briefly) {
      here.breakpoints = here.steps;
      here.intervals = here.steps - (at_breakpoint ? 1 : 0);
    }
    here.at_breakpoint = at_breakpoint;
    // Without a step, time has not gone on since the last event, and a further one may follow.
    if constexpr (has_tangents) {
      if (here.steps > 0) motion.set_tangents(vectors_of(*tangents_, tangents_->now, lane));
    }
    adapt(motion).catch_up(here);
  }

  /// After catch_up: the run completes the step that its lane has computed, or does it alone.
  void finish_step(std::size_t lane) {
    auto& motion = run(lane).motion();
    if ((state_->alone >> lane & 1U) != 0) return integrate::step(motion, run(lane).counts());
    ++run(lane).counts().steps;
    if constexpr (has_tangents) hand_over_end(lane);
    if ((state_->at_last_strobe >> lane & 1U) != 0) return adapt(motion).finish_at_strobe(strobe_point(*state_, lane));
    adapt(motion).finish_step(end_of_step(*state_, lane), fired(*state_, lane));
  }

 private:
  static constexpr bool has_tangents = HasTangents<std::remove_cvref_t<decltype(std::declval<Run&>().motion())>>;

  /// Most groups never have a run.
  void make_state() {
    state_ = std::make_unique<LaneState>();
    if constexpr (has_tangents) state_->tangents = (tangents_ = std::make_unique<TangentRows>()).get();
  }

  void load_tangents(std::size_t lane) {
    if constexpr (has_tangents) load_vectors(*tangents_, lane, run(lane).motion().tangents());
  }

  /// The vectors in the step that the lane has computed and the motion completes.
  void hand_over_end(std::size_t lane) {
    auto& motion = run(lane).motion();
    if ((state_->strobed >> lane & 1U) != 0) motion.set_at_strobe(vectors_of(*tangents_, tangents_->at_strobe, lane));
    if ((state_->at_last_strobe >> lane & 1U) != 0) return;
    const double side = motion.state().side;
    motion.end_elsewhere(state_->duration[lane], vectors_of(*tangents_, tangents_->at_end, lane),
                         {.now = {.horizontal = side * tangents_->end_base[lane], .weight = 1.0},
                          .slope = {.horizontal = side * tangents_->end_base_slope[lane], .weight = 0.0}});
  }

  void load_known_intervals(std::size_t lane, const ComingStep& step) {
    auto& motion = run(lane).motion();
    if (!motion.slips() || !motion.is_brief() || motion.excitation().has_knots()) return;
    load_intervals(*state_, lane, adapt(motion).known_intervals(), step.clock->start());
  }

  std::unique_ptr<LaneState> state_;       ///< once there is a run
  std::unique_ptr<TangentRows> tangents_;  ///< if the motions have some
  std::array<Run*, most_lanes> runs_{};
  std::uint32_t occupied_ = 0;
  std::vector<Run*> waiting_;
};

}  // namespace rocking::lanes
