#pragma once

#include <cmath>

#include "property/scene.hpp"
#include "rocking/dynamics/forces.hpp"

/// Mechanics of the block, written from lib/docs/model.md alone.
namespace rocking::property {

/// phi.
inline double edge_angle_of(const dynamics::State& state, const Scene& scene) {
  return scene.stage.geometry().shape_angle - std::abs(state.tilt);
}

/// Energy over m R^2 p^2 in the frame of the base: the centre of mass moves at (V - w cos(phi), S w sin(phi)).
inline double energy_of(const dynamics::State& state, const Scene& scene) {
  const double phi = edge_angle_of(state, scene);
  const double x = state.slip_rate - state.tilt_rate * std::cos(phi);
  const double y = state.tilt_rate * std::sin(phi);
  return 0.5 * (x * x + y * y + state.tilt_rate * state.tilt_rate / 3.0) + 4.0 / 3.0 * std::cos(phi);
}

/// N of a slipping block: G = (4/3)(1 + alpha_v) in full contact, J (G - w^2 cos(phi))/D over an edge.
inline double slipping_normal(const dynamics::State& state, const Scene& scene, double tau, double mu_k) {
  const double g = 4.0 / 3.0 * scene.ground(tau).weight;
  if (state.contact == dynamics::ContactState::slide) return g;
  const double phi = edge_angle_of(state, scene);
  const double q = state.side * std::sin(phi) + state.slip_direction * mu_k * std::cos(phi);
  const double determinant = 1.0 / 3.0 + state.side * std::sin(phi) * q;
  return (g - state.tilt_rate * state.tilt_rate * std::cos(phi)) / (3.0 * determinant);
}

/// Forces of rocking without slip.
inline dynamics::Forces sticking_forces(const dynamics::State& state, const Scene& scene, double tau) {
  const auto ground = scene.ground(tau);
  return dynamics::rocking_forces(state, {.horizontal = ground.alpha, .weight = ground.weight},
                                  equation_constants(scene.stage.setting(), state.side));
}

inline bool slips(const dynamics::State& state) {
  return state.contact == dynamics::ContactState::slide || state.contact == dynamics::ContactState::rock_slide;
}

inline bool rocks(const dynamics::State& state) {
  return state.contact == dynamics::ContactState::rock || state.contact == dynamics::ContactState::rock_slide;
}

}  // namespace rocking::property
