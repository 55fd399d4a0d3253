#include "rocking/experiment/pair_workers.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "rocking/experiment/pair_job.hpp"
#include "rocking/experiment/realisation_crew.hpp"

namespace rocking::experiment {
namespace {

/// The pairs that a thread is at.
class ThreadsShare {
 public:
  ThreadsShare(const Experiment& experiment, const lanes::Kernels& kernels)
      : experiment_(&experiment), crew_(kernels) {}

  [[nodiscard]] bool wants_more() const { return crew_.wants_more(); }
  [[nodiscard]] bool is_idle() const { return jobs_.empty(); }
  [[nodiscard]] std::size_t size() const { return jobs_.size(); }

  void start(const Pair& pair) {
    const Condition& condition = experiment_->conditions[pair.condition];
    auto& job = jobs_.emplace_back(std::make_unique<PairJob>(*experiment_, pair, effective_realisations(condition)));
    for (std::size_t task = 0; task < job->tasks().size(); ++task) {
      const PairJob::Task& run = job->tasks()[task];
      tickets_[next_ticket_] = {job.get(), task};
      crew_.start(*run.condition, experiment_->seed, run.realisation, next_ticket_++);
    }
  }

  /// Goes on for a while; returns the pairs that are done.
  [[nodiscard]] std::vector<std::unique_ptr<PairJob>> work() {
    std::vector<std::unique_ptr<PairJob>> done;
    for (auto& [ticket, record] : crew_.work()) {
      const auto entry = tickets_.extract(ticket);
      const auto [job, task] = entry.mapped();
      if (!job->accept(task, std::move(record))) continue;
      const auto place = std::ranges::find(jobs_, job, &std::unique_ptr<PairJob>::get);
      done.push_back(std::move(*place));
      jobs_.erase(place);
    }
    return done;
  }

 private:
  struct TaskOfJob {
    PairJob* job;
    std::size_t task;
  };

  const Experiment* experiment_;
  std::vector<std::unique_ptr<PairJob>> jobs_;
  std::map<std::size_t, TaskOfJob> tickets_;
  std::size_t next_ticket_ = 0;
  RealisationCrew crew_;
};

class PairWorkers {
 public:
  PairWorkers(const Experiment& experiment, const RunOptions& options, const PairFlow& flow)
      : experiment_(&experiment), options_(&options), flow_(&flow) {}

  void run() {
    {
      std::vector<std::jthread> others;
      for (unsigned i = 1; i < std::max(1U, options_->threads); ++i) others.emplace_back([this] { work(); });
      work();
    }
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void work() {
    try {
      ThreadsShare share(*experiment_, options_->lanes);
      while (true) {
        while (share.wants_more()) {
          const auto pair = next(share.is_idle());
          if (!pair) break;
          share.start(*pair);
        }
        if (share.is_idle() || is_asked_to_stop()) break;
        for (const auto& job : share.work()) accept(*job);
      }
      give_up(share.size());
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      changed_.notify_all();
    }
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

  [[nodiscard]] bool is_asked_to_stop() const {
    return options_->stop_requested != nullptr && options_->stop_requested->load();
  }

  // Whatever is under way may bring more: a thread that has nothing else to do waits for it.
  [[nodiscard]] std::optional<Pair> next(bool may_wait) {
    std::unique_lock lock(mutex_);
    while (true) {
      if (is_asked_to_stop() || failure_) return std::nullopt;
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
  std::exception_ptr failure_;
};

}  // namespace

void run_pairs(const Experiment& experiment, const RunOptions& options, const PairFlow& flow) {
  PairWorkers(experiment, options, flow).run();
}

}  // namespace rocking::experiment
