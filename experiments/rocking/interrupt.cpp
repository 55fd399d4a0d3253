#include "interrupt.hpp"

#include <csignal>

namespace rocking::program {
namespace {

// A signal handler takes no context with it: what must outlive every scope of the program.
std::atomic<bool> stop_requested{false};
std::atomic<StopReason> reason{StopReason::none};
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<StopReason>::is_always_lock_free,
              "a signal handler must not wait for a lock");

extern "C" void request_stop(int) {
  reason.store(StopReason::signal);
  stop_requested.store(true);
}

}  // namespace

const std::atomic<bool>& stop_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = &request_stop;
  action.sa_flags = SA_RESTART;
  action.sa_flags |= static_cast<int>(SA_RESETHAND);  // the second signal finds the default again
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) sigaction(number, &action, nullptr);
  return stop_requested;
}

void meet_limits_as_errors() {
  for (const int number : {SIGPIPE, SIGXFSZ}) std::signal(number, SIG_IGN);
}

void stop_for_time() {
  if (why_stopped() == StopReason::none) reason.store(StopReason::time);
  stop_requested.store(true);
}

StopReason why_stopped() { return reason.load(); }

}  // namespace rocking::program
