#pragma once

#include <atomic>
#include <exception>

namespace rocking::base {

/// Thrown by a computation that was asked to stop before it had a result.
class Stopped : public std::exception {
 public:
  [[nodiscard]] const char* what() const noexcept override { return "asked to stop before there was a result"; }
};

/// A request to stop, made by others (a signal handler, a clock) by setting a flag. Without a flag it is never made.
/// The flag must outlive the request.
class StopRequest {
 public:
  StopRequest(const std::atomic<bool>* flag = nullptr) : flag_(flag) {}

  [[nodiscard]] bool is_made() const { return flag_ != nullptr && flag_->load(std::memory_order_relaxed); }
  /// Throws Stopped if the request has been made.
  void check() const {
    if (is_made()) throw Stopped();
  }

 private:
  const std::atomic<bool>* flag_;
};

}  // namespace rocking::base
