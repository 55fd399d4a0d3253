#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

/// A second implementation of lib/docs/model.md for comparison with ours: ordinary differential equations in theta, w,
/// X, V, integrated by CVODE of SUNDIALS with its root finding. From the library it uses only the draws, which are an
/// input.
namespace rocking::peer {

/// Means of mu_s and mu_k.
struct Friction {
  double at_rest;
  double sliding;
};

/// Standard deviations; 0 where a coefficient does not fluctuate.
struct Sigmas {
  double at_rest = 0.0;
  double sliding = 0.0;
  double restitution = 0.0;
  double amplitude = 0.0;
};

/// alpha_v = amplitude psi sin(frequency tau + phase), psi of the nearer edge.
struct VerticalSine {
  double amplitude;
  double frequency;
  double phase;
};

/// A corner of a recorded base motion, which is linear between them; two at one time are a jump.
struct Corner {
  double seconds;
  double horizontal;  ///< over g
  double vertical;
};

/// A block, its base and its initial state. Symbols as in lib/docs/model.md.
struct Scene {
  std::array<double, 2> edges;  ///< horizontal distances of the left and the right edge from the centre of mass
  double height;                ///< of the centre of mass, in the same unit
  double gyration_squared;      ///< I/m about the centre of mass
  double amplitude;             ///< A_h
  double frequency;             ///< Omega_h
  double phase;                 ///< Phi in [0, 2 pi)
  bool pulse;                   ///< the base moves for the first period only; Phi = 0
  double restitution;           ///< e; at a wall abs(w2/w1)
  std::optional<Friction> friction;
  bool edge_inertia = false;        ///< J = 4/3 instead of 1/3
  bool signed_impact_rule = false;  ///< Jeong & Yang's Eq. 26 as printed
  Sigmas sigmas;
  int refreshes_per_period = 200;
  double tilt;       ///< Theta at tau = 0
  double tilt_rate;  ///< Theta'
  double slip_rate;  ///< V
  std::uint64_t seed = 0;
  std::uint64_t realisation = 0;
  double open_side = 0.0;  ///< S of the only side to which a block at a wall turns; 0: no wall
  // Of blocks at a wall only.
  std::optional<VerticalSine> vertical = std::nullopt;
  std::vector<Corner> record = {};  ///< in place of the sine
  double gravity = 9.81;            ///< from which the time of the record over tau follows
};

}  // namespace rocking::peer
