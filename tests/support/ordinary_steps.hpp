#pragma once

#include <utility>

#include "rocking/integrate/hybrid.hpp"

namespace rocking::support {

/// A motion in the form that the integrator needs (integrate::HybridSystem) and no more: every step is an ordinary one.
/// Tests derive from it to watch or to limit the steps.
template <class Motion>
struct OrdinarySteps {
  Motion& motion;

  [[nodiscard]] bool ended() const { return motion.ended(); }
  [[nodiscard]] double time_resolution() const { return motion.time_resolution(); }
  [[nodiscard]] double time_to_breakpoint() const { return motion.time_to_breakpoint(); }
  [[nodiscard]] double time_to_strobe() const { return motion.time_to_strobe(); }
  [[nodiscard]] double expand(double reach) { return motion.expand(reach); }
  template <class Visitor>
  void for_each_guard(const integrate::FiredGuards& wanted, Visitor&& visit) const {
    motion.for_each_guard(wanted, std::forward<Visitor>(visit));
  }
  void strobe(double x) { motion.strobe(x); }
  void move(double x) { motion.move(x); }
  void reset(const integrate::FiredGuards& fired, bool at_breakpoint) { motion.reset(fired, at_breakpoint); }
};

}  // namespace rocking::support
