#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "rocking/dynamics/smooth_step.hpp"
#include "rocking/integrate/hybrid.hpp"
#include "rocking/lanes/block.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/lanes/transfer.hpp"

namespace rocking::lanes {

/// Advances many runs, those of a kind side by side in the lanes of one block. Ordinary steps are done by a kernel; what
/// happens in a lane, and every other step, its motion does as it would alone. So neither the number of lanes nor the
/// neighbours have a say in any bit.
///
/// A Run has a motion (dynamics::BlockMotion) and LoopCounts, and go_on(), which is called when the motion has ended: true
/// if the run set it going again. It stays where it is while it is here.
template <class Run>
class Crew {
 public:
  explicit Crew(const Kernels& kernels) : kernels_(kernels) {
    for (Group& group : groups_) group.block = std::make_unique<Block>();
  }

  /// Runs that are neither finished nor taken away.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// With as many runs there is work for every lane, whatever they do.
  [[nodiscard]] std::size_t wanted_size() const { return 3 * static_cast<std::size_t>(kernels_.lanes); }

  void add(Run& run) {
    ++size_;
    place(run);
  }

  /// One step in the lanes of the kind that has most to do.
  void step() {
    const auto fullest = std::ranges::max_element(groups_, {}, [](const Group& group) { return group.size(); });
    const auto kind = static_cast<std::size_t>(fullest - groups_.begin());
    fill(*fullest);
    kernels_.step[kind](*fullest->block);
    look_after(*fullest, static_cast<Kind>(kind));
  }

  [[nodiscard]] bool has_finished() const { return !finished_.empty(); }
  /// Those that have finished since the last call.
  [[nodiscard]] std::vector<Run*> take_finished() { return std::exchange(finished_, {}); }

 private:
  struct Group {
    std::unique_ptr<Block> block;
    std::array<Run*, most_lanes> runs{};
    std::uint32_t occupied = 0;
    std::vector<Run*> waiting;

    [[nodiscard]] std::size_t size() const {
      return static_cast<std::size_t>(std::popcount(occupied)) + waiting.size();
    }
  };

  template <class Use>
  static void for_each_lane(std::uint32_t lanes, Use&& use) {
    for (; lanes != 0; lanes &= lanes - 1) use(static_cast<std::size_t>(std::countr_zero(lanes)));
  }

  using Motion = std::remove_reference_t<decltype(std::declval<Run&>().motion())>;

  /// Absent where the coming step is to be done alone.
  [[nodiscard]] static std::optional<Kind> kind_of(const Motion& motion) {
    if (!motion.has_ordinary_step()) return std::nullopt;
    if (motion.slips()) return motion.is_brief() ? Kind::rock_slide_briefly : Kind::rock_slide;
    if (motion.is_brief()) return std::nullopt;
    return motion.tests_friction() ? Kind::rock_with_friction : Kind::rock;
  }

  /// Puts a run where its next step is done in company, after those that are not.
  void place(Run& run) {
    auto& motion = run.motion();
    while (true) {
      if (motion.ended() && !run.go_on()) {
        --size_;
        finished_.push_back(&run);
        return;
      }
      if (const auto kind = kind_of(motion)) return wait(run, *kind);
      integrate::step(motion, run.counts());
    }
  }

  void wait(Run& run, Kind kind) { groups_[static_cast<std::size_t>(kind)].waiting.push_back(&run); }

  void fill(Group& group) {
    const std::uint32_t all = (1U << static_cast<unsigned>(kernels_.lanes)) - 1U;
    for_each_lane(all & ~group.occupied, [&](std::size_t lane) {
      if (group.waiting.empty()) return;
      group.runs[lane] = group.waiting.back();
      group.waiting.pop_back();
      group.occupied |= 1U << lane;
      load(*group.block, lane, group.runs[lane]->motion().smooth_step());
    });
  }

  void look_after(Group& group, Kind kind) {
    Block& block = *group.block;
    for_each_lane(block.strobed & group.occupied, [&](std::size_t lane) {
      group.runs[lane]->motion().pass_strobe({.tilt = block.strobe_tilt[lane],
                                              .tilt_rate = block.strobe_tilt_rate[lane],
                                              .slip = block.strobe_slip[lane],
                                              .slip_rate = block.strobe_slip_rate[lane]});
    });
    for_each_lane(block.arrived & group.occupied, [&](std::size_t lane) { pass_breakpoint(group, lane, kind); });
    for_each_lane(~block.quiet & group.occupied, [&](std::size_t lane) { step_alone(group, lane, kind); });
  }

  /// The lane's run does the step that is under way, and is put where it belongs after it.
  void step_alone(Group& group, std::size_t lane, Kind kind) {
    Block& block = *group.block;
    Run& run = *group.runs[lane];
    auto& motion = run.motion();
    catch_up(block, lane, run);
    if ((block.misfits >> lane & 1U) != 0) {
      integrate::step(motion, run.counts());
    } else {
      const double length = motion.take_up_step(
          order_of(kind), block.length[lane], [&](auto& series) { take_series(block, lane, kernels_, kind, series); });
      // Off the ground the guards are others than the kernel has looked at.
      const auto guards = motion.is_off_ground() ? integrate::guards_in_doubt(motion, length) : in_doubt(block, lane);
      integrate::finish_step(motion, length, guards, run.counts());
    }
    leave_or_stay(group, lane, kind);
  }

  void pass_breakpoint(Group& group, std::size_t lane, Kind kind) {
    Block& block = *group.block;
    Run& run = *group.runs[lane];
    Motion& motion = run.motion();
    motion.pass_breakpoint(take_steps(block, lane, run));
    if (kind_of(motion) == kind) return load_change(block, lane, motion.smooth_step());
    dynamics::SmoothProgress here = progress(block, lane);
    here.now = motion.clock().now();
    motion.catch_up(here);
    leave_or_stay(group, lane, kind);
  }

  void leave_or_stay(Group& group, std::size_t lane, Kind kind) {
    Run& run = *group.runs[lane];
    const auto next = kind_of(run.motion());
    if (next == kind) return load_step(*group.block, lane, run.motion().smooth_step());
    group.occupied &= ~(1U << lane);
    if (next) return wait(run, *next);
    place(run);
  }

  static void catch_up(Block& block, std::size_t lane, Run& run) {
    dynamics::SmoothProgress here = progress(block, lane);
    here.steps = take_steps(block, lane, run);
    run.motion().catch_up(here);
  }

  static std::uint64_t take_steps(Block& block, std::size_t lane, Run& run) {
    const auto steps = static_cast<std::uint64_t>(std::exchange(block.steps[lane], 0.0));
    run.counts().steps += steps;
    return steps;
  }

  const Kernels& kernels_;
  std::array<Group, kind_count> groups_;
  std::vector<Run*> finished_;
  std::size_t size_ = 0;
};

}  // namespace rocking::lanes
