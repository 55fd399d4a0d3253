#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/integrate/hybrid.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/lanes/lane_group.hpp"

namespace rocking::lanes {

/// Advances many runs, those of a kind in parallel in the lanes of one group. A kernel computes ordinary steps; a run
/// does the events of its lane, and all other steps, as it would alone. Therefore no bit depends on the number of lanes
/// or on the other runs.
///
/// A Run has a motion (dynamics::BlockMotion) and LoopCounts, and go_on(), which is called when the motion has ended:
/// true if the run has extended it. A run must not move in memory while it is here.
template <class Run>
class LaneScheduler {
 public:
  /// Once a stop is requested, add() and step() throw base::Stopped before a step that a run does alone; the runs are
  /// of no further use then.
  explicit LaneScheduler(const Kernels& kernels, base::StopRequest stop = {}) : kernels_(kernels), stop_(stop) {}

  /// Number of runs that have not finished.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Number of runs with which the lanes are nearly always full.
  [[nodiscard]] std::size_t wanted_size() const { return 6 * static_cast<std::size_t>(kernels_.lanes); }

  void add(Run& run) {
    ++size_;
    if (const auto kind = next_kind(run)) wait(run, *kind);
  }

  /// One step of the group that has most runs, and further ones while nothing happens in its lanes.
  void step() {
    if (size_ > 0) advance(largest_group());
  }
  /// Number of runs of that group.
  [[nodiscard]] std::uint32_t largest_size() const { return sizes_[largest_group()]; }

  [[nodiscard]] bool has_finished() const { return !finished_.empty(); }
  /// A run that has finished and was not taken yet; null if there is none.
  [[nodiscard]] Run* take_finished() {
    if (finished_.empty()) return nullptr;
    Run* run = finished_.back();
    finished_.pop_back();
    return run;
  }

 private:
  template <class Use>
  static void for_each_bit(std::uint64_t bits, Use&& use) {
    for (; bits != 0; bits &= bits - 1) use(static_cast<std::size_t>(std::countr_zero(bits)));
  }

  /// The first of equals. Most groups are for other kinds of base motion and have never had a run.
  [[nodiscard]] std::size_t largest_group() const {
    std::size_t largest = 0;
    for_each_bit(used_, [&](std::size_t index) {
      if (sizes_[largest] < sizes_[index]) largest = index;
    });
    return largest;
  }

  /// The kind of the next step of the run that a lane can compute, after the steps that it does alone; empty if it
  /// finishes before.
  [[nodiscard]] std::optional<StepKind> next_kind(Run& run) {
    auto& motion = run.motion();
    while (true) {
      if (motion.ended() && !run.go_on()) {
        --size_;
        finished_.push_back(&run);
        return std::nullopt;
      }
      if (const auto kind = kind_of(motion)) return kind;
      stop_.check();
      integrate::step(motion, run.counts());
    }
  }

  void wait(Run& run, const StepKind& kind) {
    groups_[kind.index()].wait(run);
    ++sizes_[kind.index()];
    used_ |= std::uint64_t{1} << kind.index();
  }

  void advance(std::size_t index) {
    LaneGroup<Run>& group = groups_[index];
    const StepKind kind = step_kind(index);
    for_each_bit(all_lanes() & ~group.occupied(), [&group](std::size_t lane) {
      if (group.has_waiting()) group.fill(lane);
    });
    LaneState& state = group.state();
    const Kernels::ByKind& advance = has_tangents ? kernels_.advance_with_tangents : kernels_.advance;
    advance[kind.family][static_cast<std::size_t>(kind.kind)](state);
    for_each_bit(state.no_event & state.strobed & group.occupied(),
                 [&group](std::size_t lane) { group.pass_strobe(lane); });
    for_each_bit(state.landed & group.occupied(), [&group](std::size_t lane) { group.pass_impact(lane); });
    const std::uint32_t at_breakpoint = state.at_breakpoint & group.occupied();
    for_each_bit(at_breakpoint, [&](std::size_t lane) {
      group.catch_up(lane, kind, true);
      go_on(kind, lane);
    });
    for_each_bit(~(state.no_event | state.held | at_breakpoint) & group.occupied(), [&](std::size_t lane) {
      group.catch_up(lane, kind, false);
      group.finish_step(lane);
      go_on(kind, lane);
    });
  }

  void go_on(const StepKind& kind, std::size_t lane) {
    LaneGroup<Run>& group = groups_[kind.index()];
    Run& run = group.run(lane);
    const auto next = next_kind(run);
    if (next == kind) return group.stay(lane);
    group.vacate(lane);
    --sizes_[kind.index()];
    if (next) wait(run, *next);
  }

  [[nodiscard]] std::uint32_t all_lanes() const { return (1U << static_cast<unsigned>(kernels_.lanes)) - 1U; }

  static constexpr bool has_tangents = HasTangents<std::remove_cvref_t<decltype(std::declval<Run&>().motion())>>;

  const Kernels& kernels_;
  base::StopRequest stop_;
  std::array<LaneGroup<Run>, step_kind_count> groups_;
  std::array<std::uint32_t, step_kind_count> sizes_{};  ///< runs of each group
  std::uint64_t used_ = 0;                              ///< groups that have had runs, as bits
  static_assert(step_kind_count <= 64);
  std::vector<Run*> finished_;
  std::size_t size_ = 0;
};

}  // namespace rocking::lanes
