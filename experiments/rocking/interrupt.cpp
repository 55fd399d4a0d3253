#include "interrupt.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>

namespace rocking::program {
namespace {

// A signal handler has no context, so these are global.
std::atomic<bool> stop_requested{false};
std::atomic<bool> signal_came{false};
std::atomic<bool> time_is_up{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait for a lock");

extern "C" void request_stop(int) {
  signal_came.store(true);
  stop_requested.store(true);
}

// An ignored signal stays ignored: the parent of this process (nohup, a shell without job control) requested that.
void catch_unless_ignored(int number, const struct sigaction& action) {
  struct sigaction before {};
  if (sigaction(number, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) return;
  sigaction(number, &action, nullptr);
}

}  // namespace

std::atomic<bool>& stop_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = &request_stop;
  action.sa_flags = SA_RESTART;
  action.sa_flags |= static_cast<int>(SA_RESETHAND);  // the second signal has its default action
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) catch_unless_ignored(number, action);
  return stop_requested;
}

void meet_limits_as_errors() {
  for (const int number : {SIGPIPE, SIGXFSZ}) std::signal(number, SIG_IGN);
}

void stop_for_time() {
  time_is_up.store(true);
  stop_requested.store(true);
}

base::StopRequest stop_on_signal() {
  static_cast<void>(stop_on_interrupt());
  return &signal_came;
}

StopReason why_stopped() {
  if (signal_came.load()) return StopReason::signal;
  return time_is_up.load() ? StopReason::time : StopReason::none;
}

TimeLimit::TimeLimit(double seconds)
    : watch_([this, seconds](const std::stop_token& token) {
        std::unique_lock lock(mutex_);
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(std::min(seconds, 1e9));
        woken_.wait_until(lock, token, std::chrono::time_point_cast<std::chrono::nanoseconds>(end),
                          [] { return false; });
        if (!token.stop_requested()) stop_for_time();
      }) {}

}  // namespace rocking::program
