#pragma once

namespace rocking::dynamics {

/// A rigid rectangular block of uniform density.
struct Block {
  double width = 1.0;     ///< B [m]
  double height = 4.0;    ///< H [m]
  double gravity = 9.81;  ///< g [m/s^2]
};

/// The numbers of a block in the equations, computed once.
struct Geometry {
  double shape_angle;          ///< psi = atan(B/H) [rad]
  double half_diagonal;        ///< R = sqrt(B^2 + H^2)/2, edge to centre of mass [m]
  double frequency_parameter;  ///< p = sqrt(3 g/(4 R)) [rad/s]; normalised time is tau = p t
  double sine;                 ///< sin(psi)
  double cosine;               ///< cos(psi)
  double tangent;              ///< tan(psi) = B/H
};

/// Source: Housner (1963), BSSA 53(2) 403-417; Jeong & Yang (2012) Eq. 11 for p.
[[nodiscard]] Geometry geometry_of(const Block& block);

}  // namespace rocking::dynamics
