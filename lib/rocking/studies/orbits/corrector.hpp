#pragma once

#include "rocking/studies/orbits/map_family.hpp"

namespace rocking {

/// An orbit on a curve of orbits, with what the curve's test functions need.
struct CurvePoint {
  Unknowns at{};
  Unknowns tangent{};   ///< of norm 1
  PoincareImage image;  ///< of the map of the family
  double residual = 0.0;
  double error = 0.0;                                  ///< distance from the curve: residual times condition
  double flip = 0.0;                                   ///< det(I + M): 0 at a period doubling, or where symmetry breaks
  std::optional<double> pair = {};                     ///< pair_growth: 0 at a Neimark-Sacker bifurcation
  std::optional<section::StrobePoint> asymmetry = {};  ///< MapFamily::asymmetry
  int steps = 0;                                       ///< of Newton's method

  [[nodiscard]] double fold() const { return tangent[3]; }
};

/// A hyperplane: normal . (u - through) = 0.
struct Hyperplane {
  Unknowns normal{};
  Unknowns through{};
};

/// The orbit of the family on a hyperplane, by Newton's method from `through`. Its tangent has a positive product with
/// the normal, where the curve is not in the plane. Absent where the residual does not fall to 1e-13 times the largest
/// entry of M (if above 1), or the orbit has no derivative. Throws base::Stopped if it is asked to stop.
[[nodiscard]] std::optional<CurvePoint> correct(const MapFamily& family, const Hyperplane& plane,
                                                base::StopRequest stop);

}  // namespace rocking
