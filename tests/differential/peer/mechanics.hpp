#pragma once

#include "differential/peer/scene.hpp"

namespace rocking::peer {

inline constexpr double weight = 4.0 / 3.0;  ///< g/(R p^2)

/// Quantities of a block in the laws of Newton and Euler. Lengths over R, inertia over m R^2.
struct Body {
  double psi;
  double sine;
  double cosine;
  double slenderness;   ///< H/B
  double slip_inertia;  ///< J in the equations with slip
};

[[nodiscard]] Body body_of(const Scene& scene);

/// A block on one edge: S, theta, w.
struct Stance {
  double side;
  double theta;
  double w;
};

/// Forces of the base on the block and the corresponding accelerations.
struct Balance {
  double w_dot;
  double v_dot;
  double normal;
  double friction;
  double
      determinant;  ///< derivative of the residual moment with respect to w'; the motion is determined while it is > 0
};

/// The edge does not move relative to the base.
[[nodiscard]] Balance sticking(const Body& body, const Stance& stance, double alpha);

/// The edge slides in `direction` against the friction mu_k N.
[[nodiscard]] Balance sliding(const Body& body, const Stance& stance, double alpha, double direction, double mu_k);

}  // namespace rocking::peer
