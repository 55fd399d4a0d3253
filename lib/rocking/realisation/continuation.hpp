#pragma once

#include <optional>

#include "rocking/base/stop_request.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/start.hpp"

namespace rocking {

/// Runs of conditions with harmonic excitation. Each starts from the final state of the one before; all use common
/// random numbers.
class Continuation {
 public:
  /// When asked to stop, run() throws base::Stopped.
  explicit Continuation(const random::Draws& draws, base::StopRequest stop = {}) : draws_(draws), stop_(stop) {}

  /// Whether the next run continues the one before it. The first run, and one after a run that ended before its
  /// horizon, start from the initial state of their condition.
  [[nodiscard]] bool can_go_on() const { return motion_.has_value(); }

  /// Runs a condition over its horizon. Either all conditions have friction or none has. Throws base::InputError if
  /// check_condition does.
  [[nodiscard]] RealisationResult run(const Condition& condition);

  /// The motion at the end of the last run, its clock on the last strobe point; absent if the next run starts from an
  /// initial state.
  [[nodiscard]] const std::optional<Motion>& motion() const { return motion_; }

 private:
  random::Draws draws_;
  base::StopRequest stop_;
  std::optional<Motion> motion_;
};

}  // namespace rocking
