#pragma once

#include <atomic>

namespace rocking::program {

/// From here on Ctrl-C, or a polite kill, asks to stop instead of ending the process; a second one ends it.
/// Returns what then becomes true.
[[nodiscard]] const std::atomic<bool>& stop_on_interrupt();

}  // namespace rocking::program
