#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <type_traits>
#include <utility>

#include <pybind11/pybind11.h>

#include "rocking/rocking.hpp"

namespace rocking::python {

/// A clock of the seconds since now.
inline std::function<double()> seconds_from_now() {
  return [start = std::chrono::steady_clock::now()] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
}

/// A computation in a thread of its own, while the calling thread, without the interpreter's lock, waits for it, looks
/// for signals and tells Python of progress. Ctrl-C, or an exception of the Python function, stops it.
template <class Result>
class Watched {
 public:
  /// `max_time`: stops it after this time [s].
  explicit Watched(pybind11::object on_progress, std::optional<double> max_time = {})
      : on_progress_(std::move(on_progress)), max_time_(max_time) {}

  /// compute(execution) with the fields that stop it and tell of progress. Absent only where it threw base::Stopped.
  template <class Compute>
  std::optional<Result> run(Execution execution, const Compute& compute) {
    execution.stop = &stop_;
    execution.elapsed_seconds = elapsed_;
    execution.on_progress = [this](std::uint64_t done, std::uint64_t all) {
      if (all == 0) return Decision::proceed;  // how many there will be is not known
      done_.store(done, std::memory_order_relaxed);
      all_.store(all, std::memory_order_relaxed);
      return Decision::proceed;
    };
    std::thread worker([&] {
      try {
        result_ = compute(execution);
      } catch (...) {
        failure_ = std::current_exception();
      }
      const std::lock_guard lock(mutex_);
      has_ended_ = true;
      ended_.notify_one();
    });
    while (!wait()) look_up();
    {
      const pybind11::gil_scoped_release release;
      worker.join();
    }
    return conclude();
  }

  [[nodiscard]] bool was_interrupted() const { return was_interrupted_; }

 private:
  bool wait() {
    const pybind11::gil_scoped_release release;
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, std::chrono::milliseconds(50), [this] { return has_ended_; });
  }

  void look_up() {
    if (stop_) return;
    if (max_time_ && elapsed_() >= *max_time_) stop_ = true;
    try {
      if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
      tell();
    } catch (pybind11::error_already_set& error) {
      was_interrupted_ = error.matches(PyExc_KeyboardInterrupt);
      if (!was_interrupted_) python_error_ = std::current_exception();
      stop_ = true;
    }
  }

  void tell() {
    const std::uint64_t done = done_.load(std::memory_order_relaxed);
    const std::uint64_t all = all_.load(std::memory_order_relaxed);
    if (on_progress_.is_none() || all == 0 || (done == reported_done_ && all == reported_all_)) return;
    reported_done_ = done;
    reported_all_ = all;
    on_progress_(done, all);
  }

  std::optional<Result> conclude() {
    if (python_error_) std::rethrow_exception(python_error_);
    try {
      if (failure_) std::rethrow_exception(failure_);
    } catch (const base::Stopped&) {
      return std::nullopt;
    }
    if (!was_interrupted_) tell();
    return std::move(result_);
  }

  pybind11::object on_progress_;
  std::optional<double> max_time_;
  std::function<double()> elapsed_ = seconds_from_now();
  std::atomic<bool> stop_{false};
  std::atomic<std::uint64_t> done_{0}, all_{0};
  std::uint64_t reported_done_ = 0, reported_all_ = 0;
  bool was_interrupted_ = false;
  std::exception_ptr python_error_, failure_;
  std::optional<Result> result_;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
};

/// What compute(execution) returns. Ctrl-C raises KeyboardInterrupt.
template <class Compute>
auto watch(unsigned threads, pybind11::object on_progress, const Compute& compute) {
  Watched<std::invoke_result_t<const Compute&, const Execution&>> watched(std::move(on_progress));
  auto found = watched.run({.threads = threads}, compute);
  if (watched.was_interrupted() || !found) {
    PyErr_SetNone(PyExc_KeyboardInterrupt);
    throw pybind11::error_already_set();
  }
  return *std::move(found);
}

}  // namespace rocking::python
