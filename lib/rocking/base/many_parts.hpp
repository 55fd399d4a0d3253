#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "rocking/base/stop_request.hpp"

namespace rocking::base {

/// Calls work(0) on this thread and work(1), ..., work(threads - 1) on one new thread each. If a call throws, failed()
/// is called; it may ask the other threads to end. When all threads have ended, the first exception is rethrown.
template <class Work, class Failed>
void on_threads(unsigned threads, Work&& work, Failed&& failed) {
  std::mutex mutex;
  std::exception_ptr failure;
  const auto try_to_work = [&](unsigned thread) {
    try {
      work(thread);
    } catch (...) {
      {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
      }
      failed();
    }
  };
  {
    std::vector<std::jthread> others;
    for (unsigned i = 1; i < threads; ++i) others.emplace_back(try_to_work, i);
    try_to_work(0);
  }
  if (failure) std::rethrow_exception(failure);
}

/// How a computation that consists of many independent parts is carried out. Nothing here changes its result.
struct ManyParts {
  unsigned threads = 1;
  StopRequest stop = {};               ///< looked at before each part
  std::function<void()> on_part = {};  ///< called after each part, by one thread at a time
};

/// Calls part(0) to part(count - 1), each once, in any order and on several threads. Throws Stopped if it is asked to
/// stop, and what a part throws.
template <class Part>
void for_each_part(const ManyParts& how, std::size_t count, Part&& part) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> has_failed{false};
  std::mutex mutex;
  const auto work = [&](unsigned) {
    for (std::size_t i = next++; i < count && !has_failed; i = next++) {
      how.stop.check();
      part(i);
      if (!how.on_part) continue;
      const std::lock_guard lock(mutex);
      how.on_part();
    }
  };
  const auto threads =
      static_cast<unsigned>(std::min<std::size_t>(std::max(1U, how.threads), std::max<std::size_t>(1, count)));
  on_threads(threads, work, [&] { has_failed = true; });
}

}  // namespace rocking::base
