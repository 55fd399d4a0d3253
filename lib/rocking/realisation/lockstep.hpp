#pragma once

#include <functional>
#include <memory>
#include <span>

#include "rocking/base/stop_request.hpp"
#include "rocking/dynamics/observer.hpp"
#include "rocking/lanes/kernels.hpp"
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

/// Runs motions in the lanes of one thread, all of them to where each ends. The bits of each do not depend on the
/// others or on the number of lanes.
class Lockstep {
 public:
  explicit Lockstep(const lanes::Kernels& kernels, base::StopRequest stop = {});
  ~Lockstep();
  Lockstep(const Lockstep&) = delete;
  Lockstep& operator=(const Lockstep&) = delete;

  /// `look` is called now and then, at least every few thousand steps; it may throw, and the object is of no further
  /// use then. Throws base::Stopped if a stop is requested.
  void run(std::span<StrobedMotion* const> motions, const std::function<void()>& look = {});

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rocking
