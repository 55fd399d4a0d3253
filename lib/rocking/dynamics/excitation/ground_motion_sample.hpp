#pragma once

namespace rocking::dynamics {

/// A sample of a recorded base acceleration.
struct GroundMotionSample {
  double time;        ///< [s], from the start of the run; never falls, two equal times are a jump
  double horizontal;  ///< over g
  double vertical;    ///< over g
};

}  // namespace rocking::dynamics
