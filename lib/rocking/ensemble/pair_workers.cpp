#include "rocking/ensemble/pair_workers.hpp"

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/ensemble/group_scheduler.hpp"
#include "rocking/ensemble/work_list.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/realisation_scheduler.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {
namespace {

/// A pair of realisations in progress: the runs that it needs and the parts of their results that are kept. A pure
/// function of its arguments, whatever the order in which the runs end. Its runs point into it, so that it cannot be
/// moved.
class PairInProgress {
 public:
  /// `count`: number of realisations of the condition. The last pair of an odd number has one realisation only.
  PairInProgress(const Experiment& experiment, const Pair& pair, std::uint64_t count);
  PairInProgress(const PairInProgress&) = delete;
  PairInProgress& operator=(const PairInProgress&) = delete;

  [[nodiscard]] const Pair& pair() const { return pair_; }
  [[nodiscard]] std::span<const RequestedRun> runs() const { return runs_; }

  /// Takes the result of a run; true if it was the last one.
  bool accept(std::size_t run, RealisationResult result);

  /// Summaries of the realisations in order, after all results have been accepted.
  [[nodiscard]] std::vector<Summary> summaries() const;

 private:
  enum class Purpose : std::uint8_t { itself, rerun };

  void add(Purpose purpose, const Condition& condition, std::uint64_t realisation);

  Pair pair_;
  Condition tighter_;  ///< for reruns
  std::vector<RequestedRun> runs_;
  std::vector<Purpose> purposes_;
  std::vector<std::optional<RealisationResult>> results_;  ///< by run
  std::size_t open_ = 0;
};

/// Realisations differ in their random numbers only, so that every N-th one is as good as a random selection.
bool is_rerun(const Condition& condition, std::uint64_t number) {
  return is_random(condition.scene) && condition.rerun_every > 0 && number % condition.rerun_every == 0;
}

PairInProgress::PairInProgress(const Experiment& experiment, const Pair& pair, std::uint64_t count)
    : pair_(pair), tighter_(experiment.conditions[pair.condition]) {
  const Condition& condition = experiment.conditions[pair.condition];
  tighter_.tolerance = rerun_tolerance(condition.tolerance);
  if (tighter_.horizon.until_classified) tighter_.horizon.until_classified->long_run_every = 0;
  for (std::uint64_t number = pair.first; number < std::min(pair.first + 2, count); ++number) {
    add(Purpose::itself, condition, number);
    if (is_rerun(condition, number)) add(Purpose::rerun, tighter_, number);
  }
}

void PairInProgress::add(Purpose purpose, const Condition& condition, std::uint64_t realisation) {
  runs_.push_back({.condition = &condition, .realisation = realisation});
  purposes_.push_back(purpose);
  results_.emplace_back();
  ++open_;
}

bool PairInProgress::accept(std::size_t run, RealisationResult result) {
  results_[run] = std::move(result);
  return --open_ == 0;
}

std::vector<Summary> PairInProgress::summaries() const {
  std::vector<Summary> summaries;
  std::vector<const RealisationResult*> results;
  for (std::size_t run = 0; run < runs_.size(); ++run) {
    const RealisationResult& result = *results_[run];
    switch (purposes_[run]) {
      case Purpose::itself:
        results.push_back(&result);
        summaries.push_back(summarise(result, runs_[run].realisation));
        break;
      case Purpose::rerun:
        summaries.back().rerun_mode = result.classification.mode;
        summaries.back().rerun_diverged = divergence_period(*results.back(), result);
        break;
    }
  }
  if (results.size() == 2) summaries[0].diverged_from_next = divergence_period(*results[0], *results[1]);
  return summaries;
}

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
