#pragma once

#include <optional>

#include "rocking/base/stop_request.hpp"
#include "rocking/experiment/realisation.hpp"
#include "rocking/experiment/record.hpp"
#include "rocking/random/draws.hpp"

namespace rocking::experiment {

/// Runs of harmonically shaken conditions, each from where the one before it ended, under the same draws.
class Continuation {
 public:
  /// Once it is asked to stop, run() throws base::Stopped.
  explicit Continuation(const random::Draws& draws, base::StopRequest stop = {}) : draws_(draws), stop_(stop) {}

  /// Whether the coming run goes on from the one before it. The first one does not, nor one after a run that ended before
  /// its horizon: they begin from the initial state of their condition.
  [[nodiscard]] bool can_go_on() const { return motion_.has_value(); }

  /// Runs a condition over its horizon. All conditions have friction, or none has.
  [[nodiscard]] Record run(const Condition& condition);

  /// The motion at the end of the last run, its clock on the last strobe point; absent where the coming run begins anew.
  [[nodiscard]] const std::optional<Motion>& motion() const { return motion_; }

 private:
  random::Draws draws_;
  base::StopRequest stop_;
  std::optional<Motion> motion_;
};

}  // namespace rocking::experiment
