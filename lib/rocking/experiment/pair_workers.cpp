#include "rocking/experiment/pair_workers.hpp"

#include <condition_variable>
#include <memory>
#include <mutex>

#include "rocking/base/on_threads.hpp"
#include "rocking/experiment/job_crew.hpp"
#include "rocking/experiment/pair_job.hpp"

namespace rocking::experiment {
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
    JobCrew<PairJob> crew(experiment_->seed, options_->lanes, options_->stop_requested);
    try {
      work_with(crew);
    } catch (const base::Stopped&) {
      // What is under way is given up, as where the request is seen between two steps.
    }
    give_up(crew.size());
  }

  void work_with(JobCrew<PairJob>& crew) {
    while (true) {
      while (crew.wants_more()) {
        const auto pair = next(crew.is_idle());
        if (!pair) break;
        const std::uint64_t count = effective_realisations(experiment_->conditions[pair->condition]);
        crew.start(std::make_unique<PairJob>(*experiment_, *pair, count));
      }
      if (crew.is_idle() || options_->stop_requested.is_made()) return;
      for (const auto& job : crew.work()) accept(*job);
    }
  }

  void fail() {
    const std::lock_guard lock(mutex_);
    has_failed_ = true;
    changed_.notify_all();
  }

  void accept(const PairJob& job) {
    const auto summaries = job.summaries();
    const std::lock_guard lock(mutex_);
    flow_->accept(job.pair(), summaries);
    --under_way_;
    changed_.notify_all();
  }

  /// What a thread that stops has not finished is left for another run.
  void give_up(std::size_t pairs) {
    const std::lock_guard lock(mutex_);
    under_way_ -= pairs;
    changed_.notify_all();
  }

  // Whatever is under way may bring more: a thread that has nothing else to do waits for it.
  [[nodiscard]] std::optional<Pair> next(bool may_wait) {
    std::unique_lock lock(mutex_);
    while (true) {
      if (options_->stop_requested.is_made() || has_failed_) return std::nullopt;
      if (const auto pair = flow_->next()) {
        ++under_way_;
        return pair;
      }
      if (under_way_ == 0 || !may_wait) return std::nullopt;
      changed_.wait(lock);
    }
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

}  // namespace rocking::experiment
