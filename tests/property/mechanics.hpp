#pragma once

#include <array>
#include <cmath>

#include "property/scene.hpp"
#include "rocking/dynamics/forces.hpp"

/// Mechanics of the block, written from lib/docs/model.md alone.
namespace rocking::property {

/// A body between two edges, in lengths of the unit R and masses of the unit m.
struct Body {
  std::array<double, 2> edges;  ///< horizontal distances of the left and the right edge from the centre of mass
  double height;                ///< of the centre of mass
  double inertia;               ///< J, about the centre of mass
};

inline Body body_of(const dynamics::Block& block) {
  const auto [left, right, height, gyration] = block.mass.value_or(
      dynamics::MassLayout{.left_edge = 0.5 * block.width,
                           .right_edge = 0.5 * block.width,
                           .centre_height = 0.5 * block.height,
                           .radius_of_gyration = std::hypot(block.width, block.height) / std::sqrt(12.0)});
  const double unit = std::hypot(0.5 * (left + right), height);
  return {{left / unit, right / unit}, height / unit, gyration * gyration / (unit * unit)};
}

/// m g over m R p^2.
inline double load_of(const Scene& scene) { return 1.0 + body_of(scene.stage.block).inertia; }

/// tan(psi) of the edge on this side.
inline double tangent_of(const Scene& scene, double side) {
  const Body body = body_of(scene.stage.block);
  return body.edges[side < 0.0 ? 1 : 0] / body.height;
}

/// Distances of the centre of mass from the edge on the block's side: r sin(phi) and r cos(phi).
struct Levers {
  double across;
  double up;
};

inline Levers levers_of(const dynamics::State& state, const Body& body) {
  const double edge = body.edges[state.side < 0.0 ? 1 : 0];
  const double phi = std::atan2(edge, body.height) - std::abs(state.tilt);
  const double radius = std::hypot(edge, body.height);
  return {radius * std::sin(phi), radius * std::cos(phi)};
}

/// Velocity of the centre of mass in the frame of the base.
struct Velocity {
  double along;
  double upwards;
};

inline Velocity velocity_of(const dynamics::State& state, const Scene& scene) {
  const Levers lever = levers_of(state, body_of(scene.stage.block));
  return {state.slip_rate - state.tilt_rate * lever.up, state.side * state.tilt_rate * lever.across};
}

/// Energy over m R^2 p^2 in the frame of the base.
inline double energy_of(const dynamics::State& state, const Scene& scene) {
  const Body body = body_of(scene.stage.block);
  const auto [along, upwards] = velocity_of(state, scene);
  return 0.5 * (along * along + upwards * upwards + body.inertia * state.tilt_rate * state.tilt_rate) +
         (1.0 + body.inertia) * levers_of(state, body).up;
}

/// N of a slipping block: G = (1 + J)(1 + alpha_v) in full contact, J (G - w^2 c)/D over an edge.
inline double slipping_normal(const dynamics::State& state, const Scene& scene, double tau, double mu_k) {
  const Body body = body_of(scene.stage.block);
  const double g = (1.0 + body.inertia) * scene.ground(tau).weight;
  if (state.contact == dynamics::ContactState::slide) return g;
  const auto [across, up] = levers_of(state, body);
  const double q = state.side * across + state.slip_direction * mu_k * up;
  const double determinant = body.inertia + state.side * across * q;
  return body.inertia * (g - state.tilt_rate * state.tilt_rate * up) / determinant;
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
