#pragma once

#include "rocking/base/elementary.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"

namespace rocking::dynamics {

/// Contact forces over m R p^2 and the acceleration that goes with them.
struct Forces {
  double normal;        ///< N
  double friction;      ///< F that rocking without slip needs; > 0 pushes the block towards +x
  double acceleration;  ///< w'
};

/// sin and cos of phi = psi - abs(theta), the angle of the edge-to-centre line from the vertical.
[[nodiscard]] inline base::SinCos<double> edge_angle(const State& state, const Geometry& block) {
  if (state.tilt == 0.0) return {block.sine, block.cosine};
  return base::sin_cos(block.shape_angle - state.side * state.tilt);
}

/// Forces of rocking without slip under the base acceleration alpha (in g) and the weight 1 + alpha_v.
[[nodiscard]] inline Forces rocking_forces(const State& state, double alpha, double weight, const Geometry& block) {
  const auto [s, c] = edge_angle(state, block);
  const double beta = state.side * alpha;
  const double omega = state.side * state.tilt_rate;
  const double rate = beta * c - weight * s;
  return {.normal = 4.0 / 3.0 * weight + (rate * s - omega * omega * c),
          .friction = state.side * (4.0 / 3.0 * beta - (rate * c + omega * omega * s)),
          .acceleration = state.side * rate};
}

/// w' of rocking with slip: -(G - w^2 cos(phi)) q/D.
[[nodiscard]] inline double slipping_acceleration(const State& state, double inertia, double kinetic_friction,
                                                  double weight, const Geometry& block) {
  const auto [s, c] = edge_angle(state, block);
  const double omega = state.side * state.tilt_rate;
  const double arm = s + state.side * state.slip_direction * kinetic_friction * c;
  return -state.side * (4.0 / 3.0 * weight - omega * omega * c) * arm / (inertia + s * arm);
}

/// V' of rocking with slip: -(4/3) alpha - s mu_k N + w' cos(phi) + S w^2 sin(phi).
[[nodiscard]] inline double slip_acceleration(const State& state, double alpha, double weight, double inertia,
                                              double kinetic_friction, const Geometry& block) {
  const auto [s, c] = edge_angle(state, block);
  const double acceleration = slipping_acceleration(state, inertia, kinetic_friction, weight, block);
  const double square = state.tilt_rate * state.tilt_rate;
  const double normal = 4.0 / 3.0 * weight + (state.side * acceleration * s - square * c);
  return -4.0 / 3.0 * alpha - state.slip_direction * kinetic_friction * normal + acceleration * c +
         state.side * square * s;
}

}  // namespace rocking::dynamics
