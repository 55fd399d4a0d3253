#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <mutex>

#include "rocking/base/on_threads.hpp"
#include "rocking/base/stop_request.hpp"

namespace rocking::base {

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
