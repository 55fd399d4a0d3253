#pragma once

#include <utility>

#include "rocking/integrate/hybrid.hpp"

namespace rocking::support {

/// A motion in the form that the integrator uses. `watch` can inspect the guards computed by the integrator before each
/// move in time and before each reset. The integrator does not see the guards in `overlooked`: this simulates a faulty
/// one.
template <class Motion, class Watch>
class WatchedMotion {
 public:
  WatchedMotion(Motion& motion, Watch& watch, const integrate::FiredGuards& overlooked = {})
      : motion_(motion), watch_(watch), seen_(~overlooked), sticks_anyway_(motion.contradictions() > 0) {}

  [[nodiscard]] bool ended() const { return motion_.ended(); }
  [[nodiscard]] double time_resolution() const { return motion_.time_resolution(); }
  [[nodiscard]] double time_to_breakpoint() const { return motion_.time_to_breakpoint(); }
  [[nodiscard]] double time_to_strobe() const { return motion_.time_to_strobe(); }
  [[nodiscard]] double expand(double reach) { return length_ = motion_.expand(reach); }
  template <class Visitor>
  void for_each_guard(const integrate::FiredGuards& wanted, Visitor&& visit) const {
    motion_.for_each_guard(wanted & seen_, std::forward<Visitor>(visit));
  }
  void strobe(double x) { motion_.strobe(x); }
  void move(double x) {
    watch_.before_move(motion_, length_, x, sticks_anyway_);
    motion_.move(x);
  }
  void reset(const integrate::FiredGuards& fired, bool at_breakpoint) {
    watch_.before_reset(fired);
    const auto before = motion_.contradictions();
    motion_.reset(fired, at_breakpoint);
    if (fired.any() || at_breakpoint) sticks_anyway_ = motion_.contradictions() > before;
  }

 private:
  Motion& motion_;
  Watch& watch_;
  integrate::FiredGuards seen_;
  bool sticks_anyway_;  ///< although friction does not suffice, until the next event (lib/docs/model.md, section 3)
  double length_ = 0.0;
};

}  // namespace rocking::support
