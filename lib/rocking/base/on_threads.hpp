#pragma once

#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace rocking::base {

/// Calls work(thread) with 0 on this thread, and with 1, ... `threads` - 1 each on one of its own. If one throws, failed() is
/// called, which may tell the others to end; once all have, the first thing thrown is passed on.
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
