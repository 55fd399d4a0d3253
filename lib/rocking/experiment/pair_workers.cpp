#include "rocking/experiment/pair_workers.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

namespace rocking::experiment {
namespace {

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
      while (const auto pair = next()) {
        const Condition& condition = experiment_->conditions[pair->condition];
        const auto summaries = run_pair(*experiment_, *pair, effective_realisations(condition));
        const std::lock_guard lock(mutex_);
        flow_->accept(*pair, summaries);
        --under_way_;
        changed_.notify_all();
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      changed_.notify_all();
    }
  }

  // Whatever is under way may bring more: a thread that finds nothing waits for it.
  [[nodiscard]] std::optional<Pair> next() {
    std::unique_lock lock(mutex_);
    while (true) {
      const bool asked_to_stop = options_->stop_requested != nullptr && options_->stop_requested->load();
      if (asked_to_stop || failure_) return std::nullopt;
      if (const auto pair = flow_->next()) {
        ++under_way_;
        return pair;
      }
      if (under_way_ == 0) return std::nullopt;
      changed_.wait(lock);
    }
  }

  const Experiment* experiment_;
  const RunOptions* options_;
  const PairFlow* flow_;
  std::mutex mutex_;
  std::condition_variable changed_;
  unsigned under_way_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

void run_pairs(const Experiment& experiment, const RunOptions& options, const PairFlow& flow) {
  PairWorkers(experiment, options, flow).run();
}

}  // namespace rocking::experiment
