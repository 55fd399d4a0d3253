#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "rocking/base/stop_request.hpp"

namespace rocking::program {

enum class StopReason : std::uint8_t { none, signal, time };

/// From here on Ctrl-C, a polite kill or a scheduler's warning (SIGINT, SIGTERM, SIGHUP, SIGUSR1) asks to stop instead of
/// ending the process; a second one ends it. One that this process was started to ignore stays ignored. Returns what then
/// becomes true.
[[nodiscard]] const std::atomic<bool>& stop_on_interrupt();

/// The same, but not for a time that is up.
[[nodiscard]] base::StopRequest stop_on_signal();

/// From here on a pipe that nobody reads and a limit of a file's size are errors of the write that meets them, and no longer
/// ends of the process.
void meet_limits_as_errors();

/// Asks the same because the time is up.
void stop_for_time();

[[nodiscard]] StopReason why_stopped();

/// Calls stop_for_time() when so many seconds are over, unless it is destroyed before.
class TimeLimit {
 public:
  explicit TimeLimit(double seconds);

 private:
  std::mutex mutex_;
  std::condition_variable_any woken_;
  std::jthread watch_;
};

}  // namespace rocking::program
