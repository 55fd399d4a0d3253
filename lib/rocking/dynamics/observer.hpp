#pragma once

#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

/// Is told what a realisation does. Called a few times a period, never within a step.
class Observer {
 public:
  /// Something happened at tau; `state` is the one after it.
  virtual void event(EventKind kind, double tau, const State& state) = 0;

  /// The state at a strobe instant, after its events.
  virtual void strobe(const State& state) = 0;

 protected:
  ~Observer() = default;
};

}  // namespace rocking::dynamics
