#include "rocking/ensemble/pair_workers.hpp"

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include "rocking/base/many_parts.hpp"
#include "rocking/ensemble/group_scheduler.hpp"
#include "rocking/ensemble/pair_in_progress.hpp"

namespace rocking {
namespace {

class PairWorkers {
 public:
  PairWorkers(const Experiment& experiment, const RunOptions& options, const PairFlow& flow)
      : experiment_(&experiment), options_(&options), flow_(&flow) {}

  void run() {
    base::on_threads(
        options_->threads, [this](unsigned) { work(); }, [this] { fail(); });
  }

 private:
  void work() {
    GroupScheduler<PairInProgress> scheduler(experiment_->seed, options_->lanes, options_->stop_requested);
    try {
      work_with(scheduler);
    } catch (const base::Stopped&) {
      // Realisations in progress are abandoned, as when the request is seen between two steps.
    }
    give_up(scheduler.size());
  }

  void work_with(GroupScheduler<PairInProgress>& scheduler) {
    while (true) {
      while (scheduler.wants_more()) {
        const auto pair = next(scheduler.size());
        if (!pair) break;
        const std::uint64_t count = effective_realisations(experiment_->conditions[pair->condition]);
        scheduler.start(std::make_unique<PairInProgress>(*experiment_, *pair, count));
      }
      if (scheduler.is_idle() || options_->stop_requested.is_made()) return;
      for (const auto& group : scheduler.work()) accept(*group);
    }
  }

  void fail() {
    const std::lock_guard lock(mutex_);
    has_failed_ = true;
    changed_.notify_all();
  }

  void accept(const PairInProgress& group) {
    const auto summaries = group.summaries();
    const std::lock_guard lock(mutex_);
    flow_->accept(group.pair(), summaries);
    --under_way_;
    changed_.notify_all();
  }

  /// Pairs that a stopping thread has not finished are left to a later run.
  void give_up(std::size_t pairs) {
    const std::lock_guard lock(mutex_);
    under_way_ -= pairs;
    changed_.notify_all();
  }

  /// The next pair of a thread that has `open` ones. A pair in progress may lead to more pairs: an idle thread waits
  /// for that.
  [[nodiscard]] std::optional<Pair> next(std::size_t open) {
    std::unique_lock lock(mutex_);
    while (true) {
      if (options_->stop_requested.is_made() || has_failed_ || has_its_share(open)) return std::nullopt;
      if (const auto pair = flow_->next()) {
        ++under_way_;
        return pair;
      }
      if (under_way_ == 0 || open > 0) return std::nullopt;
      changed_.wait(lock);
    }
  }

  [[nodiscard]] bool has_its_share(std::size_t open) const {
    return open > 0 && open * options_->threads >= flow_->left();
  }

  const Experiment* experiment_;
  const RunOptions* options_;
  const PairFlow* flow_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::size_t under_way_ = 0;
  bool has_failed_ = false;
};

}  // namespace

void run_pairs(const Experiment& experiment, const RunOptions& options, const PairFlow& flow) {
  PairWorkers(experiment, options, flow).run();
}

}  // namespace rocking
