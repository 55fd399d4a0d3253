#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace rocking::dynamics {

/// Where the mass of a rigid block is: any body with a flat base between two edges.
struct MassLayout {
  double left_edge;           ///< horizontal distance of the left edge from the centre of mass, > 0 [m]
  double right_edge;          ///< of the right edge, > 0 [m]
  double centre_height;       ///< of the centre of mass above the base, > 0 [m]
  double radius_of_gyration;  ///< sqrt(I/m) about the centre of mass, > 0 [m]
};

/// A rigid block: a rectangle of uniform density, unless its mass is laid out otherwise.
struct Block {
  double width = 1.0;                   ///< B [m]
  double height = 4.0;                  ///< H [m]
  double gravity = 9.81;                ///< g [m/s^2]
  std::optional<MassLayout> mass = {};  ///< where given, the equations use it, and not width and height
  double open_side = 0.0;  ///< S of the only side to which it can turn, away from a wall; 0: there is no wall
};

/// The uniform rectangle has equations with fewer operations.
enum class BlockForm : std::uint8_t { rectangle, general };

/// The numbers of a block that depend on the edge about which it rocks. Lengths over R.
struct Edge {
  double shape_angle;   ///< psi_S = atan(b_S/h) [rad]; b_S: distance of the edge from the centre of mass
  double sine;          ///< b_S/R: sin(psi) of a rectangle
  double cosine;        ///< h/R: cos(psi) of a rectangle
  double tangent;       ///< b_S/h
  double radius;        ///< r_S, edge to centre of mass: 1 for a rectangle
  double rocking_gain;  ///< (1 + J)/(J + r_S^2), of w' without slip: 1 for a rectangle
  double impact_gain;   ///< 2/(J + r_S^2), of impulses at this edge: 3/2 for a rectangle
  double sideways;      ///< b_-S/b_S, of the other edge: 1 for a rectangle
  double half_base;     ///< (b_1 + b_-1)/(2 R): sin(psi) of a rectangle
  double tilt_scale;    ///< psi of the edge nearer to the centre of mass over psi_S: 1 for a rectangle
};

/// The numbers of a block in the equations, computed once.
struct Geometry {
  double shape_angle;          ///< psi of the edge nearer to the centre of mass [rad]; of a rectangle, of both
  double half_diagonal;        ///< R = sqrt(((b_1 + b_-1)/2)^2 + h^2): of a rectangle, edge to centre of mass [m]
  double frequency_parameter;  ///< p = sqrt(g/(R (1 + J))) [rad/s], sqrt(3 g/(4 R)) for a rectangle; tau = p t
  double sine;                 ///< of the nearer edge
  double cosine;               ///< of the nearer edge
  double tangent;              ///< of the nearer edge
  double inertia;              ///< J = I/(m R^2) about the centre of mass, 1/3 for a rectangle
  double over_inertia;         ///< 1/J
  double over_square;          ///< 1 over the larger r^2 of the edges: 1 for a rectangle
  double load;                 ///< m g over m R p^2, 1 + J: 4/3 for a rectangle
  BlockForm form;
  std::array<Edge, 2> edges;  ///< left, right
  double open_side = 0.0;     ///< S of the only side to which it can turn; 0: of both

  /// The edge about which the block rocks on this side: +1 left, -1 right.
  [[nodiscard]] const Edge& edge(double side) const { return edges[side < 0.0 ? 1 : 0]; }
  /// Of the left and of the right edge.
  [[nodiscard]] std::array<double, 2> tangents() const { return {edges[0].tangent, edges[1].tangent}; }
  /// psi_S, the unit of Theta and Theta': S is the sign of the tilt, or of its rate where the tilt is 0.
  [[nodiscard]] double tilt_unit(double tilt, double tilt_rate) const {
    return edge(tilt != 0.0 ? tilt : tilt_rate).shape_angle;
  }
  [[nodiscard]] bool is_rectangle() const { return form == BlockForm::rectangle; }
  /// Whether the mirror image of a motion is a motion: the edges are alike.
  [[nodiscard]] bool has_mirror_symmetry() const { return open_side == 0.0 && edges[0].sine == edges[1].sine; }
};

/// A mass that is laid out as in a uniform rectangle, with equal edges and I = m R^2/3 up to 8 units of the last place, is
/// one: its numbers have the bits of the rectangle of that width and height.
/// Source: Housner (1963), BSSA 53(2) 403-417; Jeong & Yang (2012) Eq. 11 for p; lib/docs/model.md for the general one.
[[nodiscard]] Geometry geometry_of(const Block& block);

}  // namespace rocking::dynamics
