#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "rocking/realisation/realisation_scheduler.hpp"

namespace rocking {

/// Runs groups of realisations on one thread. The realisations of all groups are advanced at once.
///
/// A Group has runs(), valid during its lifetime, and accept(run, RealisationResult), which takes the result of one run
/// and returns whether it was the last one.
template <class Group>
class GroupScheduler {
 public:
  /// Parameters as of RealisationScheduler.
  GroupScheduler(std::uint64_t seed, const lanes::Kernels& kernels, base::StopRequest stop)
      : scheduler_(seed, kernels, stop) {}

  /// Whether a lane is free for the runs of another group, and no result waits to be returned by work().
  [[nodiscard]] bool wants_more() const { return scheduler_.wants_more(); }
  [[nodiscard]] bool is_idle() const { return groups_.empty(); }
  /// Number of groups that are not finished.
  [[nodiscard]] std::size_t size() const { return groups_.size(); }

  void start(std::unique_ptr<Group> started) {
    const auto& group = groups_.emplace_back(std::move(started));
    for (std::size_t run = 0; run < group->runs().size(); ++run) {
      members_[next_id_] = {group.get(), run};
      scheduler_.start(group->runs()[run], next_id_++);
    }
  }

  /// Advances the realisations for about a millisecond; returns the groups that are finished.
  [[nodiscard]] std::vector<std::unique_ptr<Group>> work() {
    std::vector<std::unique_ptr<Group>> done;
    for (auto& [id, result] : scheduler_.work()) {
      const auto entry = members_.extract(id);
      const auto [group, run] = entry.mapped();
      if (!group->accept(run, std::move(result))) continue;
      const auto place = std::ranges::find(groups_, group, &std::unique_ptr<Group>::get);
      done.push_back(std::move(*place));
      groups_.erase(place);
    }
    return done;
  }

 private:
  struct MemberOfGroup {
    Group* group;
    std::size_t run;
  };

  std::vector<std::unique_ptr<Group>> groups_;
  std::map<std::size_t, MemberOfGroup> members_;
  std::size_t next_id_ = 0;
  RealisationScheduler scheduler_;
};

}  // namespace rocking
