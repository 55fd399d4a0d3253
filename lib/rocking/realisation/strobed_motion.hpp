#pragma once

#include <utility>

#include "rocking/dynamics/observer.hpp"
#include "rocking/realisation/start.hpp"

namespace rocking {

/// A motion that stops at its strobe points, with the state there. The motion has a pointer to this object, which
/// therefore cannot be moved.
class StrobedMotion final : private dynamics::Observer {
 public:
  /// make_motion(observer) returns the motion, scheduled for one strobe point.
  template <class MakeMotion>
  explicit StrobedMotion(MakeMotion&& make_motion) : motion_(make_motion(static_cast<dynamics::Observer&>(*this))) {}
  StrobedMotion(const StrobedMotion&) = delete;
  StrobedMotion& operator=(const StrobedMotion&) = delete;

  [[nodiscard]] Motion& motion() { return motion_; }
  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] integrate::LoopCounts& counts() { return counts_; }
  [[nodiscard]] static bool go_on() { return false; }

  /// The state at the last strobe point that was passed; at the start the initial one.
  [[nodiscard]] const dynamics::State& at_strobe() const { return at_strobe_; }

  /// From now on continues as the other would.
  void become(const StrobedMotion& other) {
    motion_ = other.motion_;
    motion_.observe_with(*this);
    at_strobe_ = other.at_strobe_;
  }

 private:
  void event(dynamics::EventKind, double, const dynamics::State&) override {}
  void strobe(const dynamics::State& state) override { at_strobe_ = state; }

  dynamics::State at_strobe_{};
  integrate::LoopCounts counts_;
  Motion motion_;
};

}  // namespace rocking
