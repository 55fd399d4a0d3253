#pragma once

#include <functional>
#include <memory>
#include <span>

#include "rocking/base/stop_request.hpp"
#include "rocking/lanes/kernels.hpp"
#include "rocking/realisation/strobed_motion.hpp"

namespace rocking {

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
