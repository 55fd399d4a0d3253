#pragma once

#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

/// Receives the events and strobe points of a realisation: a few calls a period, none within a step.
class Observer {
 public:
  /// An event at tau; `state` is the state after it.
  virtual void event(EventKind kind, double tau, const State& state) = 0;

  /// The state at a strobe instant, after its events.
  virtual void strobe(const State& state) = 0;

 protected:
  ~Observer() = default;
};

}  // namespace rocking::dynamics
