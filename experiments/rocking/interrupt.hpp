#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "rocking/base/stop_request.hpp"

namespace rocking::program {

enum class StopReason : std::uint8_t { none, signal, time };

/// From this call on SIGINT (Ctrl-C), SIGTERM, SIGHUP and SIGUSR1 (a scheduler's warning) request a stop instead of
/// ending the process; a second signal ends it. Signals that the process inherited as ignored stay ignored. Returns the
/// flag that a request sets.
[[nodiscard]] std::atomic<bool>& stop_on_interrupt();

/// A request that only a signal sets, not a time limit.
[[nodiscard]] base::StopRequest stop_on_signal();

/// From this call on a write to a closed pipe or beyond a limit of the file size fails with an error and does not end
/// the process.
void meet_limits_as_errors();

/// Requests a stop because the time limit was reached.
void stop_for_time();

[[nodiscard]] StopReason why_stopped();

/// Calls stop_for_time() after this many seconds, unless it is destroyed before.
class TimeLimit {
 public:
  explicit TimeLimit(double seconds);

 private:
  std::mutex mutex_;
  std::condition_variable_any woken_;
  std::jthread watch_;
};

}  // namespace rocking::program
