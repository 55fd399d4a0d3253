#pragma once

#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

/// A small change of state, in Theta, Theta' and V.
struct Displacement {
  double tilt = 0.0;
  double tilt_rate = 0.0;
  double slip_rate = 0.0;
};

/// Displaces a state, within its contact state, by `wanted`; returns the displacement made.
inline Displacement displace(State& state, const Displacement& wanted, double shape_angle) {
  Displacement done;
  if (is_rocking(state.contact)) {
    done.tilt = wanted.tilt;
    done.tilt_rate = wanted.tilt_rate;
  }
  if (is_sliding(state.contact)) done.slip_rate = wanted.slip_rate;
  state.tilt += done.tilt * shape_angle;
  state.tilt_rate += done.tilt_rate * shape_angle;
  state.slip_rate += done.slip_rate;
  return done;
}

}  // namespace rocking::dynamics
