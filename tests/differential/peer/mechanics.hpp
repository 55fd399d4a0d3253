#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "differential/peer/scene.hpp"

namespace rocking::peer {

/// Quantities of a block in the laws of Newton and Euler. Lengths over R, inertia over m R^2.
struct Body {
  std::array<double, 2> edges;  ///< horizontal distances of the left and the right edge from the centre of mass
  double height;                ///< of the centre of mass
  double inertia;               ///< about the centre of mass
  double slip_inertia;          ///< J in the equations with slip
  double weight;                ///< g/(R p^2)

  /// Of the edge on the side S, +1 left and -1 right.
  [[nodiscard]] double edge(double side) const { return edges[side < 0.0 ? 1 : 0]; }
  [[nodiscard]] double tangent(double side) const { return edge(side) / height; }
  [[nodiscard]] double psi(double side) const { return std::atan2(edge(side), height); }
  /// psi of the nearer edge, the unit of alpha.
  [[nodiscard]] double unit() const { return std::min(psi(1.0), psi(-1.0)); }
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

/// Acceleration of the base over g.
struct Shaking {
  double alpha;
  double vertical = 0.0;
};

/// The edge does not move relative to the base.
[[nodiscard]] Balance sticking(const Body& body, const Stance& stance, const Shaking& base);

/// The edge slides in `direction` against the friction mu_k N.
[[nodiscard]] Balance sliding(const Body& body, const Stance& stance, const Shaking& base, double direction,
                              double mu_k);

}  // namespace rocking::peer
