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
    place(run);
  }

  /// One step where there is most to do.
  void step() {
    const auto mover = std::ranges::max_element(groups_, {}, [](const Group& group) { return group.to_move(); });
    const auto ender = std::ranges::max_element(groups_, {}, [](const Group& group) { return group.ending.size(); });
    if (mover->to_move() < ender->ending.size()) {
      end(*ender);
    } else {
      move(*mover);
    }
  }

  [[nodiscard]] bool has_finished() const { return !finished_.empty(); }
  /// Those that have finished since the last call.
  [[nodiscard]] std::vector<Run*> take_finished() { return std::exchange(finished_, {}); }

 private:
  /// Lanes, and who is in them.
  struct Lanes {
    std::unique_ptr<Block> block = std::make_unique<Block>();
    std::array<Run*, most_lanes> runs{};
    std::uint32_t occupied = 0;

    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(std::popcount(occupied)); }
    void put(std::size_t lane, Run& run) {
      runs[lane] = &run;
      occupied |= 1U << lane;
    }
    void vacate(std::size_t lane) { occupied &= ~(1U << lane); }
  };

  /// Runs of a kind.
  struct Group {
    Lanes moving;
    Lanes ending;  ///< whose coming step is one in which something may happen
    std::vector<Run*> waiting;

    [[nodiscard]] std::size_t to_move() const { return moving.size() + waiting.size(); }
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

  [[nodiscard]] Kind kind_of(const Group& group) const { return static_cast<Kind>(&group - groups_.data()); }

  void fill(Group& group) {
    Lanes& moving = group.moving;
    for_each_lane(all_lanes() & ~moving.occupied, [&](std::size_t lane) {
      if (group.waiting.empty()) return;
      Run& run = *group.waiting.back();
      group.waiting.pop_back();
      moving.put(lane, run);
      load(*moving.block, lane, run.motion().smooth_step());
    });
  }

  void move(Group& group) {
    fill(group);
    Lanes& moving = group.moving;
    const Block& block = *moving.block;
    kernels_.move[static_cast<std::size_t>(kind_of(group))](*moving.block);
    for_each_lane(block.strobed & moving.occupied,
                  [&](std::size_t lane) { moving.runs[lane]->motion().pass_strobe(strobe_point(block, lane)); });
    for_each_lane(block.arrived & moving.occupied, [&](std::size_t lane) { pass_breakpoint(group, lane); });
    for_each_lane(~block.quiet & moving.occupied, [&](std::size_t lane) { await_end(group, lane); });
  }

  void await_end(Group& group, std::size_t lane) {
    Lanes& ending = group.ending;
    if (ending.occupied == all_lanes()) end(group);
    const auto its_lane = static_cast<std::size_t>(std::countr_one(ending.occupied));
    copy_lane(*group.moving.block, lane, *ending.block, its_lane);
    ending.put(its_lane, *group.moving.runs[lane]);
    group.moving.vacate(lane);
  }

  void end(Group& group) {
    Lanes& ending = group.ending;
    kernels_.end[static_cast<std::size_t>(kind_of(group))](*ending.block);
    for_each_lane(std::exchange(ending.occupied, 0U),
                  [&](std::size_t lane) { finish_step(*ending.block, lane, *ending.runs[lane]); });
  }

  /// The lane's run takes what was found out of its step, and is put where it belongs after it.
  void finish_step(Block& block, std::size_t lane, Run& run) {
    catch_up(block, lane, run);
    if ((block.alone >> lane & 1U) != 0) {
      integrate::step(run.motion(), run.counts());
    } else {
      ++run.counts().steps;
      run.counts().root_isolations += doubts(block, lane);
      const auto first = integrate::earliest(losses(block, lane), block.length[lane], block.resolution[lane]);
      run.motion().finish_step(end_of_step(block, lane), first.fired);
    }
    place(run);
  }

  void pass_breakpoint(Group& group, std::size_t lane) {
    Block& block = *group.moving.block;
    Run& run = *group.moving.runs[lane];
    Motion& motion = run.motion();
    motion.pass_breakpoint(take_steps(block, lane, run));
    if (kind_of(motion) == kind_of(group)) return load_change(block, lane, motion.smooth_step());
    dynamics::SmoothProgress here = progress(block, lane);
    here.now = motion.clock().now();
    motion.catch_up(here);
    group.moving.vacate(lane);
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

  [[nodiscard]] std::uint32_t all_lanes() const { return (1U << static_cast<unsigned>(kernels_.lanes)) - 1U; }

  const Kernels& kernels_;
  std::array<Group, kind_count> groups_;
  std::vector<Run*> finished_;
  std::size_t size_ = 0;
};

}  // namespace rocking::lanes
