#pragma once

#include <atomic>
#include <cstdint>

namespace rocking::program {

enum class StopReason : std::uint8_t { none, signal, time };

/// From here on Ctrl-C, a polite kill or a scheduler's warning (SIGINT, SIGTERM, SIGHUP, SIGUSR1) asks to stop instead of
/// ending the process; a second one ends it. Returns what then becomes true.
[[nodiscard]] const std::atomic<bool>& stop_on_interrupt();

/// From here on a pipe that nobody reads and a limit of a file's size are errors of the write that meets them, and no longer
/// ends of the process.
void meet_limits_as_errors();

/// Asks the same because the time is up.
void stop_for_time();

[[nodiscard]] StopReason why_stopped();

}  // namespace rocking::program
