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
  explicit Crew(const Kernels& kernels) : kernels_(kernels) {}

  /// Runs that are neither finished nor taken away.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// With as many runs there is work for every lane, whatever they do.
  [[nodiscard]] std::size_t wanted_size() const { return 6 * static_cast<std::size_t>(kernels_.lanes); }

  void add(Run& run) {
    ++size_;
    if (const auto kind = next_kind(run)) wait(run, *kind);
  }

  /// One step of the lanes of a kind, of which there are most.
  void step() { advance(*std::ranges::max_element(groups_, {}, &Group::size)); }

  [[nodiscard]] bool has_finished() const { return !finished_.empty(); }
  /// Those that have finished since the last call.
  [[nodiscard]] std::vector<Run*> take_finished() { return std::exchange(finished_, {}); }

 private:
  /// The coming breakpoints of a lane, and how many of them it has passed without its motion being told.
  struct Foreseen {
    std::array<dynamics::SmoothChange, dynamics::most_foreseen> changes;
    std::size_t count = 0;
    std::size_t passed = 0;
  };

  /// Runs of a kind: those in the lanes of a block, and those that wait for one.
  struct Group {
    std::unique_ptr<Block> block = std::make_unique<Block>();
    std::array<Run*, most_lanes> runs{};
    std::array<Foreseen, most_lanes> foreseen;
    std::uint32_t occupied = 0;
    std::vector<Run*> waiting;

    [[nodiscard]] std::size_t size() const {
      return static_cast<std::size_t>(std::popcount(occupied)) + waiting.size();
    }
    void put(std::size_t lane, Run& run) {
      runs[lane] = &run;
      occupied |= 1U << lane;
      load(*block, lane, run.motion().smooth_step());
      foresee(lane);
    }
    /// The run that is in the lane goes on there.
    void stay(std::size_t lane) {
      load_step(*block, lane, runs[lane]->motion().smooth_step());
      foresee(lane);
    }
    void foresee(std::size_t lane) {
      const auto& motion = runs[lane]->motion();
      Foreseen& coming = foreseen[lane];
      coming.count = motion.slips() && motion.is_brief() ? motion.foresee(coming.changes) : 0;
      coming.passed = 0;
    }
    void vacate(std::size_t lane) {
      occupied &= ~(1U << lane);
      block->occupied[lane] = 0.0;
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

  /// The kind of the run's next step in company, after those that are not; absent if it has finished before.
  [[nodiscard]] std::optional<Kind> next_kind(Run& run) {
    auto& motion = run.motion();
    while (true) {
      if (motion.ended() && !run.go_on()) {
        --size_;
        finished_.push_back(&run);
        return std::nullopt;
      }
      if (const auto kind = kind_of(motion)) return kind;
      integrate::step(motion, run.counts());
    }
  }

  void wait(Run& run, Kind kind) { groups_[static_cast<std::size_t>(kind)].waiting.push_back(&run); }

  [[nodiscard]] Kind kind_of(const Group& group) const { return static_cast<Kind>(&group - groups_.data()); }

  void fill(Group& group) {
    for_each_lane(all_lanes() & ~group.occupied, [&](std::size_t lane) {
      if (group.waiting.empty()) return;
      Run& run = *group.waiting.back();
      group.waiting.pop_back();
      group.put(lane, run);
    });
  }

  void advance(Group& group) {
    fill(group);
    Block& block = *group.block;
    kernels_.advance[static_cast<std::size_t>(kind_of(group))](block);
    for_each_lane(block.quiet & block.strobed & group.occupied,
                  [&](std::size_t lane) { group.runs[lane]->motion().pass_strobe(strobe_point(block, lane)); });
    for_each_lane(block.arrived & group.occupied, [&](std::size_t lane) { pass_breakpoint(group, lane); });
    for_each_lane(~(block.quiet | block.held) & group.occupied, [&](std::size_t lane) { finish_step(group, lane); });
  }

  /// The lane's run takes what was found out of its step, and goes on where its next one is done.
  void finish_step(Group& group, std::size_t lane) {
    Block& block = *group.block;
    Run& run = *group.runs[lane];
    catch_up(group, lane);
    if ((block.alone >> lane & 1U) != 0) {
      integrate::step(run.motion(), run.counts());
    } else {
      ++run.counts().steps;
      const auto first = integrate::earliest(losses(block, lane), block.length[lane], block.resolution[lane]);
      run.motion().finish_step(end_of_step(block, lane), first.fired);
    }
    go_on(group, lane);
  }

  void go_on(Group& group, std::size_t lane) {
    Run& run = *group.runs[lane];
    const auto kind = next_kind(run);
    if (kind == kind_of(group)) return group.stay(lane);
    group.vacate(lane);
    if (kind) wait(run, *kind);
  }

  void pass_breakpoint(Group& group, std::size_t lane) {
    Block& block = *group.block;
    Foreseen& foreseen = group.foreseen[lane];
    if (foreseen.passed < foreseen.count) return load_change(block, lane, foreseen.changes[foreseen.passed++]);
    tell_of_changes(group, lane);
    Run& run = *group.runs[lane];
    Motion& motion = run.motion();
    motion.pass_breakpoint(take_counts(block, lane, run));
    if (kind_of(motion) == kind_of(group)) {
      load_change(block, lane, motion.smooth_step());
      return group.foresee(lane);
    }
    dynamics::SmoothProgress here = progress(block, lane);
    here.now = motion.clock().now();
    motion.catch_up(here);
    go_on(group, lane);
  }

  static void catch_up(Group& group, std::size_t lane) {
    tell_of_changes(group, lane);
    Block& block = *group.block;
    Run& run = *group.runs[lane];
    dynamics::SmoothProgress here = progress(block, lane);
    here.steps = take_counts(block, lane, run);
    run.motion().catch_up(here);
  }

  static void tell_of_changes(Group& group, std::size_t lane) {
    Foreseen& foreseen = group.foreseen[lane];
    if (foreseen.passed == 0) return;
    Run& run = *group.runs[lane];
    const auto steps = take_counts(*group.block, lane, run);
    run.motion().pass_changes(foreseen.passed, foreseen.changes[foreseen.passed - 1], steps);
    foreseen.passed = 0;
  }

  /// Returns the steps done in the lane since the last call.
  static std::uint64_t take_counts(Block& block, std::size_t lane, Run& run) {
    const auto steps = static_cast<std::uint64_t>(std::exchange(block.steps[lane], 0.0));
    run.counts().steps += steps;
    run.counts().root_isolations += static_cast<std::uint64_t>(std::exchange(block.root_isolations[lane], 0.0));
    return steps;
  }

  [[nodiscard]] std::uint32_t all_lanes() const { return (1U << static_cast<unsigned>(kernels_.lanes)) - 1U; }

  const Kernels& kernels_;
  std::array<Group, kind_count> groups_;
  std::vector<Run*> finished_;
  std::size_t size_ = 0;
};

}  // namespace rocking::lanes
