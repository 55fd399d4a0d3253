#pragma once

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

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

}  // namespace rocking::base
