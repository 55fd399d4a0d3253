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

#include "rocking/base/stop_request.hpp"
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
  /// Once it is asked to stop, add() and step() throw base::Stopped from among the steps that a run does alone, of which there
  /// may be any number; the runs are of no further use then.
  explicit Crew(const Kernels& kernels, base::StopRequest stop = {}) : kernels_(kernels), stop_(stop) {
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      groups_[i].kind = {i / kind_count, static_cast<Kind>(i % kind_count)};
      groups_[i].number = i;
    }
  }

  /// Runs that are neither finished nor taken away.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// With as many runs there is work for every lane, whatever they do.
  [[nodiscard]] std::size_t wanted_size() const { return 6 * static_cast<std::size_t>(kernels_.lanes); }

  void add(Run& run) {
    ++size_;
    if (const auto kind = next_kind(run)) wait(run, *kind);
  }

  /// One step of the lanes of a kind, of which there are most.
  void step() { advance(groups_[static_cast<std::size_t>(std::ranges::max_element(sizes_) - sizes_.begin())]); }

  /// One that has finished and was not taken yet; null if there is none.
  [[nodiscard]] Run* take_finished() {
    if (finished_.empty()) return nullptr;
    Run* run = finished_.back();
    finished_.pop_back();
    return run;
  }

 private:
  /// Of steps that are done in the lanes of one block.
  struct StepKind {
    std::size_t excitation = 0;  ///< dynamics::Excitation::index
    Kind kind = Kind::rock;
    friend bool operator==(const StepKind&, const StepKind&) = default;
  };

  /// Runs of a kind: those in the lanes of a block, and those that wait for one.
  struct Group {
    StepKind kind;
    std::size_t number = 0;  ///< among the groups
    std::unique_ptr<Block> block = std::make_unique<Block>();
    std::array<Run*, most_lanes> runs{};
    std::uint32_t occupied = 0;
    std::vector<Run*> waiting;

    void put(std::size_t lane, Run& run) {
      runs[lane] = &run;
      occupied |= 1U << lane;
      const auto step = run.motion().smooth_step();
      load(*block, lane, step);
      foresee(lane, step);
    }
    /// The run that is in the lane goes on there.
    void stay(std::size_t lane) {
      const auto step = runs[lane]->motion().smooth_step();
      load_step(*block, lane, step);
      foresee(lane, step);
    }
    void foresee(std::size_t lane, const dynamics::SmoothStep& step) {
      const auto& motion = runs[lane]->motion();
      if (!motion.slips() || !motion.is_brief() || motion.excitation().has_knots()) return;
      load_intervals(*block, lane, motion.foresee(), step.clock->start());
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
  [[nodiscard]] static std::optional<StepKind> kind_of(const Motion& motion) {
    if (!motion.has_ordinary_step()) return std::nullopt;
    const bool is_brief = motion.is_brief();
    const Kind kind = motion.slips() ? (is_brief ? Kind::rock_slide_briefly : Kind::rock_slide)
                      : motion.tests_friction()
                          ? (is_brief ? Kind::rock_with_friction_briefly : Kind::rock_with_friction)
                          : (is_brief ? Kind::rock_briefly : Kind::rock);
    return StepKind{motion.excitation().index(), kind};
  }

  /// The kind of the run's next step in company, after those that are not; absent if it has finished before.
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
    const std::size_t index = kind.excitation * kind_count + static_cast<std::size_t>(kind.kind);
    groups_[index].waiting.push_back(&run);
    ++sizes_[index];
  }

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
    kernels_.advance[group.kind.excitation][static_cast<std::size_t>(group.kind.kind)](block);
    for_each_lane(block.quiet & block.strobed & group.occupied,
                  [&](std::size_t lane) { group.runs[lane]->motion().pass_strobe(strobe_point(block, lane)); });
    for_each_lane(block.landed & group.occupied, [&](std::size_t lane) { pass_impact(group, lane); });
    const std::uint32_t at_breakpoint = block.at_breakpoint & group.occupied;
    for_each_lane(at_breakpoint, [&](std::size_t lane) {
      catch_up(group, lane, true);
      go_on(group, lane);
    });
    for_each_lane(~(block.quiet | block.held | at_breakpoint) & group.occupied, [&](std::size_t lane) {
      catch_up(group, lane, false);
      finish_step(group, lane);
      go_on(group, lane);
    });
  }

  static void pass_impact(Group& group, std::size_t lane) {
    Run& run = *group.runs[lane];
    const dynamics::SmoothProgress here = progress(*group.block, lane);
    run.counts().steps += here.steps;
    group.block->steps[lane] = 0.0;
    run.motion().pass_impact(here);
  }

  /// The lane's run takes what was found out of its step.
  void finish_step(Group& group, std::size_t lane) {
    Block& block = *group.block;
    Run& run = *group.runs[lane];
    if ((block.alone >> lane & 1U) != 0) return integrate::step(run.motion(), run.counts());
    ++run.counts().steps;
    if ((block.at_last_strobe >> lane & 1U) != 0) return run.motion().finish_at_strobe(strobe_point(block, lane));
    run.motion().finish_step(end_of_step(block, lane), fired(block, lane));
  }

  void go_on(Group& group, std::size_t lane) {
    Run& run = *group.runs[lane];
    const auto kind = next_kind(run);
    if (kind == group.kind) return group.stay(lane);
    group.vacate(lane);
    --sizes_[group.number];
    if (kind) wait(run, *kind);
  }

  /// Tells the lane's run of the steps that were done in the lane. Steps on the friction grid come to a breakpoint each.
  /// `at_breakpoint`: the lane stands at one, and the interval that begins there is not known yet.
  void catch_up(Group& group, std::size_t lane, bool at_breakpoint) {
    Run& run = *group.runs[lane];
    dynamics::SmoothProgress here = progress(*group.block, lane);
    run.counts().steps += here.steps;
    run.counts().root_isolations += count(group.block->root_isolations[lane]);
    if (run.motion().excitation().has_knots()) {
      here.breakpoints = count(group.block->breakpoints[lane]);
    } else if (group.kind.kind == Kind::rock_slide_briefly) {
      here.breakpoints = here.steps;
      here.foreseen = here.steps - (at_breakpoint ? 1 : 0);
    }
    here.at_breakpoint = at_breakpoint;
    run.motion().catch_up(here);
  }

  [[nodiscard]] std::uint32_t all_lanes() const { return (1U << static_cast<unsigned>(kernels_.lanes)) - 1U; }

  const Kernels& kernels_;
  base::StopRequest stop_;
  std::array<Group, dynamics::excitation_kinds * kind_count> groups_;
  std::array<std::uint32_t, dynamics::excitation_kinds * kind_count>
      sizes_{};  ///< runs in the lanes of each, or waiting
  std::vector<Run*> finished_;
  std::size_t size_ = 0;
};

}  // namespace rocking::lanes
