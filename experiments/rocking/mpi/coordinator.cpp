#include "session.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <set>
#include <thread>

#include <fmt/format.h>

#include "exit_code.hpp"
#include "rocking/ensemble/pair_workers.hpp"

namespace rocking::program::mpi {
namespace {

using Clock = std::chrono::steady_clock;

/// Size of the next block of a helper, from the duration of its last one.
struct BlockLength {
  std::size_t pairs = 1;
  Clock::time_point given;

  void learn() {
    constexpr double aim_s = 0.25;
    const double took_s = std::chrono::duration<double>(Clock::now() - given).count();
    const double factor = std::clamp(aim_s / std::max(took_s, 1e-6), 0.25, 4.0);
    pairs = std::clamp<std::size_t>(static_cast<std::size_t>(factor * static_cast<double>(pairs)), 1, 4096);
  }
};

class Coordinator {
 public:
  Coordinator(const Session& session, const RunOptions& options, const PairFlow& flow)
      : session_(&session), options_(&options), flow_(&flow) {}

  void run(const Experiment& experiment) {
    {
      const std::jthread own_work([&] { work_here(experiment); });
      while (!is_done()) {
        take_messages();
        give_blocks();
        if (stopping_) stop_busy_helpers();
        std::this_thread::sleep_for(std::chrono::microseconds(100));
      }
    }
    session_->send_to_others(Tag::rest, {});
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  // Results of helpers may make more pairs necessary, so a thread without work waits for them.
  void work_here(const Experiment& experiment) {
    RunOptions options = *options_;
    options.stop_requested = &stopping_;
    const PairFlow flow{.next = [this] { return next(); },
                        .accept = [this](const Pair& pair, const std::vector<Summary>& all) { accept(pair, all); },
                        .left = [this] { return left(); }};
    std::unique_lock lock(mutex_);
    while (!over_) {
      seen_ = accepted_;
      lock.unlock();
      try {
        run_pairs(experiment, options, flow);
      } catch (...) {
        fail(std::current_exception());
      }
      lock.lock();
      idle_here_ = true;
      changed_.wait(lock, [this] { return over_ || (accepted_ != seen_ && !stopping_); });
      idle_here_ = false;
    }
  }

  std::optional<Pair> next() {
    const std::lock_guard lock(mutex_);
    return flow_->next();
  }

  void accept(const Pair& pair, const std::vector<Summary>& summaries) {
    const std::lock_guard lock(mutex_);
    flow_->accept(pair, summaries);
    ++accepted_;
    changed_.notify_all();
  }

  std::uint64_t left() {
    const std::lock_guard lock(mutex_);
    return flow_->left();
  }

  // The first failure is reported.
  void fail(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::move(failure);
    stopping_ = true;
  }

  void take_messages() {
    while (auto message = session_->receive()) {
      if (message->tag == Tag::failure) {
        busy_.erase(message->rank);
        fail(std::make_exception_ptr(InTheWay(fmt::format("rank {}: {}", message->rank, text_from(message->bytes)))));
      } else {
        take_outcomes(*message);
      }
    }
  }

  void take_outcomes(const Message& message) {
    const auto outcomes = outcomes_from(message.bytes);
    if (const auto given = busy_.find(message.rank); given != busy_.end()) {
      if (outcomes.size() < given->second) stopping_ = true;  // the helper was asked to stop
      busy_.erase(given);
      lengths_[message.rank].learn();
    }
    free_.insert(message.rank);
    if (failure_here()) return;
    try {
      for (const auto& [pair, summaries] : outcomes) accept(pair, summaries);
    } catch (...) {
      fail(std::current_exception());
    }
  }

  bool failure_here() {
    const std::lock_guard lock(mutex_);
    return failure_ != nullptr;
  }

  void give_blocks() {
    if (options_->stop_requested.is_made()) stopping_ = true;
    while (!free_.empty() && !stopping_) {
      const int rank = *free_.begin();
      const std::vector<Pair> block = take_block(lengths_[rank].pairs);
      if (block.empty()) return;
      free_.erase(rank);
      busy_[rank] = block.size();
      lengths_[rank].given = Clock::now();
      session_->send(rank, Tag::block, to_bytes(std::span<const Pair>(block)));
    }
  }

  // A realisation may take hours, so each helper is told to stop only once.
  void stop_busy_helpers() {
    for (const auto& [rank, pairs] : busy_) {
      if (told_to_stop_.insert(rank).second) session_->send(rank, Tag::stop, {});
    }
  }

  std::vector<Pair> take_block(std::size_t most) {
    const std::lock_guard lock(mutex_);
    std::vector<Pair> block;
    while (block.size() < most) {
      const auto pair = flow_->next();
      if (!pair) break;
      block.push_back(*pair);
    }
    return block;
  }

  // No process works, and no result has arrived since this process found no work.
  bool is_done() {
    const std::lock_guard lock(mutex_);
    over_ = busy_.empty() && idle_here_ && (stopping_ || accepted_ == seen_);
    if (over_) changed_.notify_all();
    return over_;
  }

  const Session* session_;
  const RunOptions* options_;
  const PairFlow* flow_;
  std::atomic<bool> stopping_{false};
  // Used by the thread that communicates.
  std::set<int> free_;
  std::map<int, std::size_t> busy_;  ///< pairs that each helper runs
  std::map<int, BlockLength> lengths_;
  std::set<int> told_to_stop_;
  // Used by both threads, under the lock.
  std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t accepted_ = 0;
  std::uint64_t seen_ = 0;  ///< `accepted_` when this process last looked for pairs
  bool idle_here_ = false;
  bool over_ = false;
  std::exception_ptr failure_;
};

}  // namespace

ProcessPool pool_of(const Session& session) {
  ProcessPool pool{.threads = 1, .processes = static_cast<unsigned>(session.size())};
  if (session.size() == 1) return pool;
  pool.start_workers = [&session](const Identity& identity, unsigned threads) -> PairRunner {
    session.send_to_others(Tag::assignment, to_bytes(Assignment{.threads = threads, .identity = identity}));
    return [&session](const Experiment& experiment, const RunOptions& options, const PairFlow& flow) {
      Coordinator(session, options, flow).run(experiment);
    };
  };
  return pool;
}

}  // namespace rocking::program::mpi
