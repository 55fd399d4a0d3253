#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "rocking/base/stop_request.hpp"

namespace rocking::rare {

/// Thrown by a computation that is not finished when the time of the study is up.
class TimeIsUp : public base::Stopped {};

/// What ends the work of a study: a request, or a time. Used by several threads.
class Halt {
 public:
  Halt() = default;
  /// `seconds` on the clock of `elapsed_seconds`; absent: no limit.
  Halt(base::StopRequest stop, std::function<double()> elapsed_seconds, std::optional<double> seconds)
      : stop_(stop), elapsed_seconds_(std::move(elapsed_seconds)), seconds_(seconds) {}

  /// Time since the start of the study [s]; 0 without a limit.
  [[nodiscard]] double elapsed() const { return seconds_ ? elapsed_seconds_() : 0.0; }
  /// Whether `share` of the time does not suffice for `needed` more seconds.
  [[nodiscard]] bool ends_within(double needed, double share) const {
    return seconds_ && elapsed_seconds_() + needed >= share * *seconds_;
  }
  /// Throws Stopped if the request has been made, TimeIsUp at the end of the time.
  void check() const {
    stop_.check();
    if (ends_within(0.0, 1.0)) throw TimeIsUp();
  }
  /// The request alone, which costs less.
  void check_request() const { stop_.check(); }

 private:
  base::StopRequest stop_;
  std::function<double()> elapsed_seconds_;
  std::optional<double> seconds_;
};

}  // namespace rocking::rare
